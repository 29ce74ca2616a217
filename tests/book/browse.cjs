// browse.cjs BOOK: opens every page of the woven book from disk in headless Chromium, on a phone, a small and a wide
// screen, light and dark. A page fails by: a console message or an exception, a request that fails or leaves the book's
// folder, a script that is no file of the book, sideways scrolling, a formula or picture that is cut off, a link or anchor
// that leads nowhere, text too faint for its paper. A page of a chapter is also too heavy (more than 1.5 MB are read for it in
// one scheme, what all pages share apart) or too long (more than 25 000 px on a screen 1440 px wide, folds closed).
'use strict';
const fs = require('fs'), path = require('path'), url = require('url');
const {pages_of, run} = require('./chromium.cjs');

const book = path.resolve(process.argv[2]);
const pages = pages_of(book);
const heaviest = 1.5e6, longest = 25000;                // bytes, px

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
            if (e.matches('.label') && getComputedStyle(e).color !== getComputedStyle(e.parentElement).color)
                bad.push(`a name that has not its curve's colour: ${who(e)} of ${svg.id}`);
            if (place.left < box.left - 1 || place.right > box.right + 1 || place.top < box.top - 1 || place.bottom > box.bottom + 1
                || place.left < 0 || place.right > width)
                bad.push(`a label lies outside its chart: ${who(e)} of ${svg.id}`);
            const size = parseFloat(getComputedStyle(e).fontSize) * svg.querySelector(e.closest('.narrow') ? '.narrow' : '.wide').getScreenCTM().a;
            if (width < 500 && size < 10.99) bad.push(`a label of ${size.toFixed(1)} px: ${who(e)} of ${svg.id}`);
        }
    }
    for (const e of document.querySelectorAll('.katex-error')) bad.push(`a formula was not set: ${who(e)}`);
    // Contrast of each kind of text with what lies behind it (WCAG: 4.5, 3 for large letters).
    const linear = v => v <= .03928 ? v / 12.92 : ((v + .055) / 1.055) ** 2.4;
    const light = ([r, g, b]) => .2126 * linear(r) + .7152 * linear(g) + .0722 * linear(b);
    const rgba = c => {                                 // rgb(…), rgba(…) or color(srgb …), each from 0 to 1
        const n = (c.match(/[\d.]+(e-?\d+)?/g) || [0, 0, 0, 0]).map(Number), whole = c.startsWith('color') ? 1 : 255;
        return [n[0] / whole, n[1] / whole, n[2] / whole, n.length > 3 ? n[3] : 1];
    };
    const over = (top, below) => [0, 1, 2].map(i => top[3] * top[i] + (1 - top[3]) * below[i]);
    const behind = e => {
        const layers = [];
        for (; e; e = e.parentElement) layers.push(rgba(getComputedStyle(e).backgroundColor));
        return layers.reverse().reduce((below, layer) => over(layer, below), [1, 1, 1]);
    };
    const paper = light(behind(document.body)), kinds = new Set();
    for (const e of document.querySelectorAll('body *:not(script, style, title, desc, svg.chart :not(text, tspan))')) {
        if (![...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim()) || !e.checkVisibility() || e.closest('.words, .katex-mathml')) continue;
        const style = getComputedStyle(e), svg = e.closest('svg'), back = behind(svg ? svg.parentElement : e);
        const ink = over(rgba(svg ? style.fill : style.color), back), kind = `${e.tagName} ${e.getAttribute('class') || ''} ${ink} ${back}`;
        if (kinds.has(kind)) continue;
        kinds.add(kind);
        const a = light(ink), b = light(back), ratio = (Math.max(a, b) + .05) / (Math.min(a, b) + .05), size = parseFloat(style.fontSize);
        const wanted = size >= 24 || (size >= 18.66 && style.fontWeight >= 700) ? 3 : 4.5;
        if (ratio < wanted) bad.push(`too faint (${ratio.toFixed(2)}): ${who(e)}`);
    }
    // The keyboard: every stop has a name, and they come in the order of the page.
    for (const e of document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex]')) {
        if (e.tabIndex < 0 || !e.checkVisibility()) continue;
        if (e.tabIndex > 0) bad.push(`it is taken out of the page's order: ${who(e)}`);
        const name = e.getAttribute('aria-label') || e.textContent.trim() || [...e.querySelectorAll('img')].map(i => i.alt).join('')
            || e.closest('label')?.textContent.trim() || e.labels?.[0]?.textContent.trim();
        if (!name) bad.push(`a stop of the keyboard without a name: ${who(e)}`);
    }
    return {bad, dark: paper < .2, ids: [...document.querySelectorAll('[id]')].map(e => e.id),
        links: [...document.querySelectorAll('a[href]')].map(a => a.href)};
}

async function main({tell, heard, event}) {
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await tell(`${domain}.enable`);

    const inside = url.pathToFileURL(book).href + '/';
    const complaints = [];
    let here = '', read = new Set();
    const complain = what => complaints.push(`${path.relative(book, here)}: ${what}`);
    heard.push(m => {
        if (m.method === 'Log.entryAdded') complain(`console: ${m.params.entry.text} ${m.params.entry.url || ''}`);
        if (m.method === 'Runtime.consoleAPICalled') complain(`console: ${JSON.stringify(m.params.args)}`);
        if (m.method === 'Runtime.exceptionThrown') complain(`exception: ${m.params.exceptionDetails.text}`);
        if (m.method === 'Network.loadingFailed' && !m.params.canceled) complain(`a request failed: ${m.params.errorText}`);
        if (m.method === 'Network.requestWillBeSent') {
            const to = m.params.request.url;
            if (!to.startsWith(inside) && !to.startsWith('data:')) complain(`a request leaves the book: ${to}`);
            if (to.startsWith(inside)) read.add(decodeURIComponent(to.slice(inside.length).split(/[?#]/)[0]));
        }
    });

    const views = [[360, 'light'], [1000, 'dark'], [1280, 'light']];
    const ids = new Map(), links = [], measures = [];
    for (here of pages) {
        const measured = /^0\d[a-z]?_/.test(path.relative(book, here));
        read = new Set();
        const loaded = event('Page.loadEventFired');
        await tell('Page.navigate', {url: url.pathToFileURL(here).href});
        await loaded;
        if (measured) {
            await tell('Emulation.setDeviceMetricsOverride', {width: 1440, height: 900, deviceScaleFactor: 1, mobile: false});
            const {result} = await tell('Runtime.evaluate', {awaitPromise: true, returnByValue: true, expression: `(async () => {
                await document.fonts.ready; await Promise.all([...document.images].map(i => (i.loading = 'eager', i.decode().catch(() => {}))));
                return document.documentElement.scrollHeight; })()`});
            if (result.value > longest) complain(`it is ${result.value} px long at 1440, more than ${longest}`);
            const own = [...read].filter(name => /\.html$|^pictures\//.test(name));
            const bytes = own.reduce((sum, name) => sum + fs.statSync(path.join(book, name)).size, 0);
            if (!(bytes > 1000 && bytes <= heaviest)) complain(`a browser reads ${bytes} bytes for it in one scheme, more than ${heaviest}`);
            measures.push(`${path.relative(book, here)} ${result.value} px ${(bytes / 1e6).toFixed(2)} MB`);
        }
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
    // Finding one's way: the search finds sections and their addresses hold; on a phone the bar stays and says where one is.
    here = path.join(book, 'index.html');
    const ask = async expression => {
        const {result, exceptionDetails} = await tell('Runtime.evaluate', {awaitPromise: true, returnByValue: true, expression});
        if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
        return result.value;
    };
    const open = async page => {
        const loaded = event('Page.loadEventFired');
        await tell('Page.navigate', {url: url.pathToFileURL(here = page).href});
        await loaded;
    };
    await open(path.join(book, 'index.html'));
    const hits = await ask(`(async () => {
        const form = document.querySelector('.side form.search'), input = form.querySelector('input'), told = form.querySelector('[role=status]');
        const found = async words => {
            input.value = words;
            input.dispatchEvent(new Event('input'));
            for (let i = 0; i < 100; ++i) {
                await new Promise(later => setTimeout(later, 20));
                if (form.querySelector('li a') || told.textContent) break;
            }
            const links = [...form.querySelectorAll('li a')].map(a => a.href);
            input.value = '';
            form.dispatchEvent(new KeyboardEvent('keydown', {key: 'Escape'}));
            return links;
        };
        return {some: await found('verlet spring'), none: await found('zzyzx')}; })()`);
    if (!hits.some.length) complain('the search finds nothing for "verlet spring"');
    if (hits.none.length) complain(`the search finds ${hits.none[0]} for a word that no page has`);
    for (const link of hits.some) {
        const [file, anchor] = link.split('#');
        if (!ids.has(file) || (anchor && !ids.get(file).has(decodeURIComponent(anchor)))) complain(`a finding of the search leads nowhere: ${link}`);
    }
    await tell('Emulation.setDeviceMetricsOverride', {width: 360, height: 740, deviceScaleFactor: 1, mobile: true});
    for (const page of pages.filter(page => /^0\d[a-z]?_/.test(path.relative(book, page)))) {
        await open(page);
        const bar = await ask(`(async () => {
            const headings = [...document.querySelectorAll('main h2')], h = headings[Math.floor(headings.length / 2)];
            window.scrollTo(0, h.getBoundingClientRect().top + scrollY + 200);
            await new Promise(later => setTimeout(later, 100));
            return {top: document.querySelector('.top').getBoundingClientRect().top, says: document.querySelector('.top .where').textContent,
                wanted: h.textContent}; })()`);
        if (bar.top !== 0) complain(`the bar of a phone does not stay: it stands at ${bar.top} px`);
        if (bar.says !== bar.wanted) complain(`the bar of a phone says "${bar.says}" in section "${bar.wanted}"`);
    }
    measures.forEach(m => console.log(m));
    [...new Set(complaints)].forEach(c => console.log(c));
    console.log(`${pages.length} pages, ${views.length} views each, ${links.length} links: ${complaints.length} complaints`);
    return complaints.length && pages.length ? 1 : pages.length ? 0 : 1;
}

run(main, 6);
