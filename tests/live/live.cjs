// live.cjs BOOK: every figure of the woven book that moves, in headless Chromium. Each shows its still until it is started,
// starts, steps, draws its still's picture at its still's moment, survives the ends of its sliders with every method, and
// leaves no error. The page: one WebGL context for all, no frame for what is not seen, still without motion or WebGL2, after a
// lost context and on paper; a fault of the physics is a sentence; a phone; fingers' sizes; weight.
'use strict';
const fs = require('fs'), path = require('path'), url = require('url'), {open} = require('./browser.cjs');
const book = path.resolve(process.argv[2]);
// Left out: chapters 4 and 5, whose figures did not come to an end in ten minutes of software OpenGL, and side roads.
const pages = fs.readdirSync(book).filter(name => /^0[0-3]_.*\.html$/.test(name) && fs.readFileSync(path.join(book, name), 'utf8').includes('data-figure='));
if (!pages.length) { console.log(`no figure moves in ${book}`); process.exit(1); }

const complaints = [];
let here = '';
const complain = what => complaints.push(`${here}: ${what}`);
const need = (held, what) => { if (!held) complain(what); };

/// Inside the page: how far the canvas is from the still, both 320 wide; mean over all channels, of 255.
async function distance(figure) {
    const still = figure.stage.querySelector('.shot img'), width = 320, height = Math.round(width * still.naturalHeight / still.naturalWidth);
    const pixels = async source => {
        const canvas = Object.assign(document.createElement('canvas'), {width, height}), pen = canvas.getContext('2d');
        pen.imageSmoothingQuality = 'high';
        pen.drawImage(source, 0, 0, width, height);
        return pen.getImageData(0, 0, width, height).data;
    };
    // file:// taints a canvas that an image was drawn on, so the test hands the still's bytes in
    const bitmap = await createImageBitmap(await (await fetch(window.stills[figure.name])).blob());
    const a = await pixels(bitmap), b = await pixels(figure.canvas);
    let sum = 0;
    for (let i = 0; i < a.length; ++i) if (i % 4 < 3) sum += Math.abs(a[i] - b[i]);
    return sum / (width * height * 3);
}

async function page_of(browser, name, setting = {}) {
    const {width = 1280, scheme = 'light', motion = 'no-preference', before = ''} = setting;
    await browser.tell('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: width < 500});
    await browser.tell('Emulation.setEmulatedMedia', {media: '', features: [{name: 'prefers-color-scheme', value: scheme}, {name: 'prefers-reduced-motion', value: motion}]});
    const {identifier} = await browser.tell('Page.addScriptToEvaluateOnNewDocument', {source: before});
    here = name;
    await browser.go(url.pathToFileURL(path.join(book, name)).href);
    await browser.tell('Page.removeScriptToEvaluateOnNewDocument', {identifier});
    await browser.run('document.querySelectorAll("main details").forEach(d => d.open = true); await document.fonts.ready;');
}

const counted = `window.contexts = new Set(); const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { const c = get.call(this, kind, ...rest); if (kind === 'webgl2' && c) contexts.add(c); return c; };`;

/// Every figure of a page, one after the other.
async function each_figure(browser, name) {
    await page_of(browser, name, {before: counted});
    const stills = {};
    for (const [figure, source] of await browser.run('return live_figures.map(f => [f.name, f.stage.querySelector(".shot img").getAttribute("src")])'))
        stills[figure] = 'data:image/jpeg;base64,' + fs.readFileSync(path.join(book, source)).toString('base64');
    await browser.run(`window.stills = ${JSON.stringify(stills)};`);
    const count = await browser.run('return live_figures.length');
    for (let i = 0; i < count; ++i) {
        const found = await browser.run(`const f = live_figures[${i}], bad = [], need = (held, what) => { if (!held) bad.push(what); };
            f.stage.scrollIntoView({block: 'center'});
            need(!f.canvas && f.stage.querySelector('.shot').getBoundingClientRect().width > 100, 'its still is not shown before it is started');
            need(f.stage.querySelector('.shot img').alt.length > 20, 'its still has no words for who does not see it');
            await f.start();
            if (!f.wasm) return {bad: ['it does not start: ' + f.note.textContent]};
            for (let n = 0; n < 60 && !(f.time > 0) ; ++n) await sleep(50);
            need(f.time > 0, 'started, and nothing moves');
            f.play(false);
            f.apply(true); f.play(false);
            const before = f.time;
            f.call('step'); f.tell();
            need(f.time > before, 'one step, and no time has passed');
            need(f.letters.isConnected && f.numbers.textContent.length > 5, 'no numbers');
            // its first state at its moment: the still
            f.share = 1;
            f.stage.style.width = f.stage.querySelector('.shot img').naturalWidth + 'px', f.stage.style.maxWidth = 'none';
            f.put(f.controls.states[0]); f.go(f.controls.states[0].time);
            const apart = await (${distance})(f);
            need(apart <= 1, 'at the moment of its still it is ' + apart.toFixed(2) + ' of 255 away from it');
            f.stage.style.cssText = f.stage.style.cssText.replace(/(^|;)\\s*(max-)?width:[^;]*/g, '');
            // the ends of every slider, by every method
            const choices = Math.max(1, f.controls.choices.length);
            for (let c = 0; c < choices; ++c) for (let s = 0; s < f.sliders.length; ++s) for (const end of [0, 1]) {
                f.put(f.controls.states[0]); f.play(false);
                f.choice = c;
                f.sliders[s].range.value = end;
                f.sliders[s].range.oninput();
                f.apply(true); f.play(false);
                for (let n = 0; n < 30; ++n) f.call('step');
                f.tell(); f.draw(true);
                if (!f.wasm) return {bad: [...bad, 'slider ' + s + ' at its end ' + end + ', method ' + c + ': ' + f.note.textContent]};
            }
            for (const state of f.controls.states) { f.put(state); f.play(false); f.go(state.time); if (!f.wasm) return {bad: [...bad, 'state ' + state.key + ': ' + f.note.textContent]}; }
            // fingers and keys
            for (const e of f.figure.querySelectorAll('button:not(.begin), .ways label, input[type=range]')) {
                const box = e.getBoundingClientRect();
                need(box.height >= 43.5, 'a target of ' + box.height + ' px: ' + (e.textContent || e.type));
            }
            need(f.canvas.tabIndex === 0 && f.canvas.getAttribute('aria-label').length > 20, 'the canvas has no name or no place in the order of keys');
            for (const key of ['ArrowLeft', 'ArrowUp', '+', '-']) f.canvas.dispatchEvent(new KeyboardEvent('keydown', {key}));
            need(f.wasm, 'a key broke it: ' + f.note.textContent);
            f.canvas.dispatchEvent(new PointerEvent('pointerdown', {clientX: f.canvas.getBoundingClientRect().x + 200, clientY: f.canvas.getBoundingClientRect().y + 150, pointerId: 1}));
            return {bad, name: f.name, apart, contexts: contexts.size};`).catch(problem => ({bad: [problem.message.slice(0, 300)]}));
        const figure = await browser.run(`return live_figures[${i}].name`);
        for (const what of found.bad) complain(`${figure}: ${what}`);
        if (found.apart !== undefined) console.log(`  ${name} ${figure}: ${found.apart.toFixed(2)} of 255 from its still`);
        need(found.contexts === undefined || found.contexts === 1, `${figure}: ${found.contexts} WebGL contexts on one page`);
    }
}

/// What the page does without: tried on its first figure.
async function without(browser, name) {
    await page_of(browser, name, {before: counted});
    await browser.run('const f = live_figures[0]; f.stage.scrollIntoView({block: "center"}); await f.start(); await sleep(600);');
    let got = await browser.run('const f = live_figures[0]; scrollTo(0, document.body.scrollHeight); await sleep(500); const n = f.frames; await sleep(500); return [n, f.frames, f.playing]');
    need(got[0] === got[1] && got[2], `scrolled away, and it still asks for frames: ${got}`);
    got = await browser.run('const f = live_figures[0]; f.stage.scrollIntoView({block: "center"}); f.values[0] = NaN; f.apply(true); await sleep(50); return [f.wasm === null, f.note.textContent, f.stage.querySelector(".shot").getBoundingClientRect().width > 100]');
    need(got[0] && got[1].includes('must be') && got[2], `a fault of the physics is no sentence over the still: ${got}`);
    got = await browser.run('const f = live_figures[0]; await f.start(); await sleep(300); const lives = !!f.wasm; [...contexts][0].getExtension("WEBGL_lose_context").loseContext(); await sleep(300); const lost = f.wasm === null; const words = f.note.textContent; await f.start(); return [lives, lost, words, !!f.wasm]');
    need(got[0] && got[1] && got[2] && got[3], `after a lost context: ${got}`);
    await browser.tell('Emulation.setEmulatedMedia', {media: 'print'});
    got = await browser.run('const f = live_figures[0]; return [f.stage.querySelector(".shot").getBoundingClientRect().height > 50, getComputedStyle(f.canvas).display, getComputedStyle(f.pause.closest(".controls")).display]');
    need(got[0] && got[1] === 'none' && got[2] === 'none', `on paper: ${got}`);

    await page_of(browser, name, {motion: 'reduce'});
    got = await browser.run('const f = live_figures[0]; f.stage.scrollIntoView({block: "center"}); await f.start(); const t = f.time; await sleep(400); return [f.playing, t === f.time, Math.abs(f.time - f.controls.states[0].time) < 0.02 * f.time + 1e-9]');
    need(!got[0] && got[1] && got[2], `where motion is not wanted: ${got}`);

    await page_of(browser, name, {before: `const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : get.call(this, kind, ...rest); };`});
    got = await browser.run('const f = live_figures[0]; await f.start(); return [f.wasm, f.note.textContent, f.stage.querySelector(".shot").getBoundingClientRect().width > 100]');
    need(!got[0] && got[1].includes('WebGL2') && got[2], `without WebGL2: ${got}`);

    await page_of(browser, name, {width: 360, scheme: 'dark'});
    got = await browser.run('for (const f of live_figures) await f.start(); await sleep(300); return [document.documentElement.scrollWidth, live_figures.filter(f => f.wasm).length, live_figures.length, getComputedStyle(live_figures[0].canvas).touchAction]');
    need(got[0] <= 360 && got[1] === got[2] && got[3] === 'pan-y', `on a phone, all started: ${got}`);
    const weight = await browser.run('return performance.getEntriesByType("resource").map(r => r.name)');
    const bytes = [path.join(book, name), ...weight.filter(u => u.startsWith('file:') && !/\/(fonts|katex)\//.test(u)).map(u => url.fileURLToPath(u))].reduce((sum, file) => sum + fs.statSync(file).size, 0);
    console.log(`  ${name}: ${(bytes / 1e6).toFixed(2)} MB in the dark, its module included`);
    need(bytes <= 1.5e6, `the page weighs ${(bytes / 1e6).toFixed(2)} MB`);
}

(async () => {
    const browser = await open();
    const limit = setTimeout(() => { console.log(`the browser did not answer in time at ${here}`); browser.close(1); }, 1700e3);
    browser.hear(m => {
        if (m.method === 'Log.entryAdded' && !/GPU stall|Performance|CONTEXT_LOST|context lost/i.test(m.params.entry.text)) complain(`console: ${m.params.entry.text}`);
        if (m.method === 'Runtime.consoleAPICalled') complain(`console: ${JSON.stringify(m.params.args).slice(0, 300)}`);
        if (m.method === 'Runtime.exceptionThrown') complain(`exception: ${m.params.exceptionDetails.exception?.description || m.params.exceptionDetails.text}`);
    });
    try {
        for (const name of pages) {
            await each_figure(browser, name);
            await without(browser, name);
        }
    } catch (problem) { complain(problem.stack); }
    clearTimeout(limit);
    [...new Set(complaints)].forEach(c => console.log(c));
    console.log(`${pages.length} pages with figures that move: ${complaints.length} complaints`);
    browser.close(complaints.length ? 1 : 0);
})();
