// browse.cjs BOOK: opens every page of the woven book from disk in headless Chromium, on a phone, a small and a wide
// screen, light and dark. A page fails by: a console message or an exception, a request that fails or leaves the book's
// folder, a script that is no file of the book, sideways scrolling, a formula or picture that is cut off, a link or anchor
// that leads nowhere, text too faint for its paper.
// Exit code 77 (skipped) without Chromium, unless CI=true: there it must be present.
'use strict';
const {spawn, execFileSync} = require('child_process');
const fs = require('fs'), os = require('os'), path = require('path'), url = require('url');

const book = path.resolve(process.argv[2]);
const browser = ['chromium', 'chromium-browser', 'google-chrome'].find(name => {
    try { execFileSync('sh', ['-c', `command -v ${name}`]); return true; } catch { return false; }
});
if (!browser) {
    console.log('no Chromium here (apt-get install chromium): the pages were not opened');
    process.exit(process.env.CI === 'true' ? 1 : 77);
}

const pages = [];
(function collect(folder) {
    for (const entry of fs.readdirSync(folder, {withFileTypes: true})) {
        const full = path.join(folder, entry.name);
        if (entry.isDirectory()) collect(full);
        else if (entry.name.endsWith('.html')) pages.push(full);
    }
})(book);

// --- the browser, by its debugging pipe: JSON messages that end in NUL -----------------------------------------------
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'browse_'));
const chromium = spawn(browser, ['--headless=new', '--disable-gpu', '--no-first-run', '--disable-dev-shm-usage',
    '--disable-background-networking', '--hide-scrollbars',
    '--remote-debugging-pipe', `--user-data-dir=${profile}`, ...(process.getuid() === 0 ? ['--no-sandbox'] : []), 'about:blank'],
    {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
const waiting = new Map(), heard = [];
let next = 0, rest = Buffer.alloc(0);
chromium.stdio[4].on('data', data => {
    rest = Buffer.concat([rest, data]);
    for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) {
        const message = JSON.parse(rest.subarray(0, end));
        if (message.id) { waiting.get(message.id)(message); waiting.delete(message.id); }
        else for (const hear of [...heard]) hear(message);
    }
});
const ask = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
    const id = ++next;
    waiting.set(id, m => m.error ? reject(new Error(`${method}: ${m.error.message}`)) : resolve(m.result));
    chromium.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
});
const event = name => new Promise(resolve => heard.push(function hear(m) {
    if (m.method === name) { heard.splice(heard.indexOf(hear), 1); resolve(m.params); }
}));

// --- what a page is asked, inside the browser ------------------------------------------------------------------------
function examine(width, inside) {
    const bad = [], wide = document.documentElement;
    const who = e => `<${e.tagName.toLowerCase()} class="${e.getAttribute('class') || ''}"> ${(e.textContent || '').trim().slice(0, 50)}`;
    if (wide.scrollWidth > width) {
        const far = [...document.querySelectorAll('main *')].filter(e => e.getBoundingClientRect().right > width + 1
            && !e.closest('pre, .plot, .scroll, .katex-display'));
        bad.push(`it scrolls sideways: ${wide.scrollWidth} px on ${width}; ${far.slice(0, 2).map(who).join('; ')}`);
    }
    for (const image of document.images) if (!image.complete || !image.naturalWidth) bad.push(`picture not shown: ${image.src}`);
    for (const s of document.scripts)      // the book's own files; the pages read without them
        if (!s.src.startsWith(inside)) bad.push(`a script that is no file of the book: ${s.src || s.textContent.slice(0, 40)}`);
    const scrolls = e => ['auto', 'scroll'].includes(getComputedStyle(e).overflowX);
    for (const e of document.querySelectorAll('.katex-display, pre, .plot, .scroll'))
        if (e.scrollWidth > e.clientWidth + 1 && !scrolls(e)) bad.push(`cut off: ${who(e)}`);
    if (width >= 1000)
        for (const e of document.querySelectorAll('.katex-display, pre'))
            if (e.scrollWidth > e.clientWidth + 1) bad.push(`wider than the column of a wide screen: ${who(e)}`);
    // Charts: one of the two layouts is shown, whole; its words stand inside the column and can be read on a phone.
    for (const svg of document.querySelectorAll('svg.chart')) {
        const hidden = [...svg.querySelectorAll('*:not(title, desc, style)')].filter(e => getComputedStyle(e).display === 'none');
        if (hidden.length !== 1 || !hidden[0].matches('.wide, .narrow'))
            bad.push(`not just one layout of a chart is hidden: ${hidden.slice(0, 3).map(who).join('; ')} of ${svg.id}`);
        const room = svg.closest('.plot').getBoundingClientRect(), box = svg.getBoundingClientRect();
        if (box.right > room.right + 1) bad.push(`a chart is wider than its column: ${svg.id}`);
        for (const e of svg.querySelectorAll('text, tspan')) {
            const place = e.getBoundingClientRect();
            if (!place.width) continue;
            if (place.left < box.left - 1 || place.right > box.right + 1 || place.top < box.top - 1 || place.bottom > box.bottom + 1
                || place.left < 0 || place.right > width)
                bad.push(`a label lies outside its chart: ${who(e)} of ${svg.id}`);
            const size = parseFloat(getComputedStyle(e).fontSize) * svg.querySelector(e.closest('.narrow') ? '.narrow' : '.wide').getScreenCTM().a;
            if (width < 500 && size < 10.99) bad.push(`a label of ${size.toFixed(1)} px: ${who(e)} of ${svg.id}`);
        }
    }
    for (const e of document.querySelectorAll('.katex-error')) bad.push(`a formula was not set: ${who(e)}`);
    // Contrast of the text with the page's paper (WCAG: 4.5).
    const linear = v => (v /= 255) <= .03928 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4;
    const light = ([r, g, b]) => .2126 * linear(r) + .7152 * linear(g) + .0722 * linear(b);
    const rgb = c => (c.match(/[\d.]+/g) || []).slice(0, 3).map(Number);
    const paper = light(rgb(getComputedStyle(document.body).backgroundColor));
    for (const e of document.querySelectorAll('main p, main li, main a, figcaption, h1, h2, svg.chart .title')) {
        const style = getComputedStyle(e), ink = light(rgb(e.closest('svg') ? style.fill : style.color));
        const ratio = (Math.max(ink, paper) + .05) / (Math.min(ink, paper) + .05);
        if (ratio < 4.5) { bad.push(`too faint (${ratio.toFixed(1)}): ${who(e)}`); break; }
    }
    return {bad, dark: paper < .2, ids: [...document.querySelectorAll('[id]')].map(e => e.id),
        links: [...document.querySelectorAll('a[href]')].map(a => a.href)};
}

async function main() {
    const {targetInfos} = await ask('Target.getTargets');
    const target = targetInfos.find(t => t.type === 'page').targetId;
    const {sessionId} = await ask('Target.attachToTarget', {targetId: target, flatten: true});
    const tell = (method, params) => ask(method, params, sessionId);
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await tell(`${domain}.enable`);

    const inside = url.pathToFileURL(book).href + '/';
    const complaints = [];
    let here = '';
    const complain = what => complaints.push(`${path.relative(book, here)}: ${what}`);
    heard.push(m => {
        if (m.method === 'Log.entryAdded') complain(`console: ${m.params.entry.text} ${m.params.entry.url || ''}`);
        if (m.method === 'Runtime.consoleAPICalled') complain(`console: ${JSON.stringify(m.params.args)}`);
        if (m.method === 'Runtime.exceptionThrown') complain(`exception: ${m.params.exceptionDetails.text}`);
        if (m.method === 'Network.loadingFailed' && !m.params.canceled) complain(`a request failed: ${m.params.errorText}`);
        if (m.method === 'Network.requestWillBeSent') {
            const to = m.params.request.url;
            if (!to.startsWith(inside) && !to.startsWith('data:')) complain(`a request leaves the book: ${to}`);
        }
    });

    const views = [[360, 'light'], [1000, 'dark'], [1280, 'light']];
    const ids = new Map(), links = [];
    for (here of pages) {
        const loaded = event('Page.loadEventFired');
        await tell('Page.navigate', {url: url.pathToFileURL(here).href});
        await loaded;
        for (const [width, scheme] of views) {
            await tell('Emulation.setDeviceMetricsOverride', {width, height: 800, deviceScaleFactor: 1, mobile: width < 500});
            await tell('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: scheme}]});
            const {result, exceptionDetails} = await tell('Runtime.evaluate', {awaitPromise: true, returnByValue: true,
                expression: `(async () => { document.querySelectorAll('main details').forEach(d => d.open = true);
                    await document.fonts.ready; await new Promise(requestAnimationFrame);
                    await Promise.all([...document.images].map(i => i.decode().catch(() => {}))); return (${examine})(${width}, ${JSON.stringify(inside)}); })()`});
            if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
            const found = result.value;
            found.bad.forEach(b => complain(`at ${width} px, ${scheme}: ${b}`));
            if (found.dark !== (scheme === 'dark')) complain(`it does not follow the ${scheme} scheme`);
            if (width === 1280) {
                ids.set(url.pathToFileURL(here).href, new Set(found.ids));
                const twice = found.ids.find((id, i) => found.ids.indexOf(id) !== i);
                if (twice) complain(`an id is there twice: ${twice}`);
                for (const link of found.links) links.push([here, link]);
            }
        }
    }
    for (const [from, link] of links) {
        here = from;
        const [file, anchor] = link.split('#');
        if (!file.startsWith(inside)) { if (file.startsWith('file:')) complain(`a link leaves the book: ${link}`); continue; }
        if (!ids.has(file)) { if (!fs.existsSync(url.fileURLToPath(file))) complain(`a link leads nowhere: ${link}`); }
        else if (anchor && !ids.get(file).has(decodeURIComponent(anchor))) complain(`a link's anchor is not there: ${link}`);
    }
    [...new Set(complaints)].forEach(c => console.log(c));
    console.log(`${pages.length} pages, ${views.length} views each, ${links.length} links: ${complaints.length} complaints`);
    return complaints.length && pages.length ? 1 : pages.length ? 0 : 1;
}

const clean_up = code => {
    chromium.once('exit', () => {       // its helpers may still be writing for a moment; what stays in /tmp is no complaint
        try { fs.rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100}); } catch { }
        process.exit(code);
    });
    chromium.kill();
};
const limit = setTimeout(() => { console.log('the browser did not answer in 4 minutes'); clean_up(1); }, 240000);
chromium.on('error', e => { console.log(`cannot start ${browser}: ${e.message}`); process.exit(1); });
main().then(code => { clearTimeout(limit); clean_up(code); }, e => { console.log(e.stack); clean_up(1); });
