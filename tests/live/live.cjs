// live.cjs BOOK [PAGE…]: every figure of the woven book that moves, in headless Chromium, or those of the pages named. Each
// shows its still until it is started, starts, steps, draws its still's picture at its still's moment, survives the ends of its
// sliders with every method, stands still at its first state where motion is not wanted, and leaves no error. Every page: one
// WebGL context for all, a phone, fingers' sizes, weight. The first page: what a figure does without (without.cjs).
'use strict';
const fs = require('fs'), path = require('path'), url = require('url'), {open} = require('./browser.cjs');
const {without} = require('./without.cjs');
const book = path.resolve(process.argv[2]), named = process.argv.slice(3);
const pages = fs.readdirSync(book).filter(name => name.endsWith('.html') && (!named.length || named.includes(name))
    && fs.readFileSync(path.join(book, name), 'utf8').includes('data-figure='));
if (!pages.length) { console.log(`no figure moves in ${book}`); process.exit(1); }

const complaints = [];
let here = '';
const complain = what => complaints.push(`${here}: ${what}`);
const need = (held, what) => { if (!held) complain(what); };

async function page_of(browser, name, setting = {}) {
    const {width = 1280, scheme = 'light', motion = 'no-preference', before = ''} = setting;
    await browser.tell('Emulation.setDeviceMetricsOverride', {width, height: 900, deviceScaleFactor: 1, mobile: width < 500});
    await browser.media(scheme, motion);
    const {identifier} = await browser.tell('Page.addScriptToEvaluateOnNewDocument', {source: counted + before});
    here = name;
    await browser.go(url.pathToFileURL(path.join(book, name)).href);
    await browser.tell('Page.removeScriptToEvaluateOnNewDocument', {identifier});
    await browser.run('document.querySelectorAll("main details").forEach(d => d.open = true); await document.fonts.ready;');
}

const counted = `window.contexts = new Set(); { const get = HTMLCanvasElement.prototype.getContext;
    HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { const c = get.call(this, kind, ...rest); if (kind === 'webgl2' && c) contexts.add(c); return c; }; }\n`;

/// Inside the page: how far the canvas is from the still: the mean over all channels of the means of 3 by 3 pixels, of 255. (Edges
/// are smoothed in two ways, within a pixel.)
async function distance(figure) {
    const {naturalWidth: width, naturalHeight: height} = figure.stage.querySelector('.shot img');
    const pixels = source => {
        const canvas = Object.assign(document.createElement('canvas'), {width, height}), pen = canvas.getContext('2d');
        pen.drawImage(source, 0, 0, width, height);
        return pen.getImageData(0, 0, width, height).data;
    };
    // file:// taints a canvas that an image was drawn on, so the test hands the still's bytes in
    const a = pixels(await createImageBitmap(await (await fetch(window.stills[figure.name])).blob())), b = pixels(figure.canvas);
    let sum = 0, count = 0;
    for (let y = 0; y + 3 <= height; y += 3) for (let x = 0; x + 3 <= width; x += 3) for (let channel = 0; channel < 3; ++channel, ++count) {
        let apart = 0;
        for (let k = 0; k < 9; ++k) {
            const at = 4 * ((y + Math.floor(k / 3)) * width + x + k % 3) + channel;
            apart += a[at] - b[at];
        }
        sum += Math.abs(apart) / 9;
    }
    return sum / count;
}

/// Inside the page: one figure by all its controls. Software draws here, so all but the picture that is compared is drawn coarse.
async function examine(f, distance, sleep) {
    const bad = [], need = (held, what) => { if (!held) bad.push(what); }, gone = what => ({bad: [...bad, `${what}: ${f.note.textContent}`]});
    const coarse = 0.15, draw = f.draw, still = f.stage.querySelector('.shot');
    f.stage.scrollIntoView({block: 'center'});
    need(!f.canvas && still.getBoundingClientRect().width > 50, 'its still is not shown before it is started');
    need(still.querySelector('img').alt.length > 20, 'its still has no words for who does not see it');
    const tall = f.stage.clientHeight;
    f.share = coarse;
    await f.start();
    if (!f.wasm) return gone('it does not start');
    need(f.stage.clientHeight <= Math.max(tall, 416) + 1, `it is ${f.stage.clientHeight} px tall where its still was ${tall}: the page jumps`);
    for (let n = 0; n < 200 && !(f.time > 0); ++n) await sleep(50);
    need(f.time > 0, 'started, and nothing moves');
    f.apply(true); f.play(false);
    const before = f.time;
    f.call('step'); f.tell();
    need(f.time > before, 'one step, and no time has passed');
    need(f.letters.isConnected && f.numbers.textContent.length > 5, 'no numbers');
    // its first state at its moment: the still
    f.share = 1;
    f.stage.style.width = still.querySelector('img').naturalWidth + 'px', f.stage.style.maxWidth = 'none';
    f.draw = () => { };
    f.put(f.controls.states[0]);
    f.draw = draw;
    f.go(f.controls.states[0].time);
    const apart = await distance(f);
    need(apart <= 1, `at the moment of its still it is ${apart.toFixed(2)} of 255 away from it`);
    f.stage.style.removeProperty('width'), f.stage.style.removeProperty('max-width');
    // the ends of every slider, by every method: set by the slider's own means, drawn once
    f.share = coarse;
    for (let c = 0; c < Math.max(1, f.controls.choices.length); ++c) for (let s = 0; s < f.sliders.length; ++s) for (const end of [0, 1]) {
        f.draw = () => { };
        f.put(f.controls.states[0]);
        f.choice = c;
        f.sliders[s].range.value = end;
        f.sliders[s].range.oninput();
        f.apply(true); f.play(false);
        f.draw = draw;
        if (f.wasm) { for (let n = 0; n < 30; ++n) f.call('step'); f.tell(); f.draw(true); }
        if (!f.wasm) return gone(`slider ${s} at its end ${end}, method ${c}`);
    }
    // keys move the thumb, however coarse the value is: 40 presses are a tenth of the way
    f.draw = () => { };
    for (const {element, range} of f.sliders) {
        range.value = 0.6;
        const from = range.valueAsNumber, name = element.firstChild.textContent, step = +range.step;
        let pressed = 0;
        for (; pressed < 40 && range.valueAsNumber < 0.95; ++pressed) { range.stepUp(); range.oninput(); }
        need(Math.abs(range.valueAsNumber - from - pressed * step) < 1.5 * step, `keys do not move the slider "${name}": from ${from} to ${range.value}`);
        if (!f.wasm) return gone(`slider "${name}" by keys`);
    }
    f.draw = draw;
    for (const state of f.controls.states) {
        f.put(state); f.go(state.time);
        if (!f.wasm) return gone(`state ${state.key}`);
    }
    // fingers and keys
    for (const e of f.figure.querySelectorAll('button:not(.begin), .ways label, input[type=range]')) {
        const box = e.getBoundingClientRect();
        need(box.height >= 43.5, `a target of ${box.height} px: ${e.textContent || e.type}`);
    }
    need(f.canvas.tabIndex === 0 && f.canvas.getAttribute('aria-label').length > 20, 'the canvas has no name or no place in the order of keys');
    for (const key of ['ArrowLeft', 'ArrowUp', '+', '-']) f.canvas.dispatchEvent(new KeyboardEvent('keydown', {key}));
    need(f.wasm, `a key broke it: ${f.note.textContent}`);
    const place = f.canvas.getBoundingClientRect();
    for (const [type, by] of [['pointerdown', 0], ['pointermove', 30], ['pointerup', 30]])
        f.canvas.dispatchEvent(new PointerEvent(type, {clientX: place.x + place.width / 2 + by, clientY: place.y + place.height / 2, pointerId: 1}));
    need(f.wasm, `a hand broke it: ${f.note.textContent}`);
    return {bad, apart, contexts: contexts.size};
}

/// Bytes of all that the page has read so far, itself, fonts and typesetting included.
async function weight(browser, name) {
    const read = await browser.run('return performance.getEntriesByType("resource").map(r => r.name)');
    const files = new Set([path.join(book, name), ...read.filter(u => u.startsWith('file:')).map(u => url.fileURLToPath(u))]);
    return [...files].reduce((sum, file) => sum + fs.statSync(file).size, 0);
}

async function each_figure(browser, name) {
    await page_of(browser, name);
    const stills = {};
    for (const [figure, source] of await browser.run('return live_figures.map(f => [f.name, f.stage.querySelector(".shot img").getAttribute("src")])'))
        stills[figure] = 'data:image/jpeg;base64,' + fs.readFileSync(path.join(book, source)).toString('base64');
    await browser.run(`window.stills = ${JSON.stringify(stills)};`);
    for (const [i, figure] of Object.keys(stills).entries()) {
        const begun = Date.now();
        const found = await browser.run(`return (${examine})(live_figures[${i}], ${distance}, sleep)`).catch(problem => ({bad: [problem.message.slice(0, 300)]}));
        for (const what of found.bad) complain(`${figure}: ${what}`);
        console.log(`  ${name} ${figure}: ${found.apart === undefined ? '?' : found.apart.toFixed(2)} of 255 from its still, ${((Date.now() - begun) / 1000).toFixed(1)} s`);
        need(found.contexts === undefined || found.contexts === 1, `${figure}: ${found.contexts} WebGL contexts on one page`);
    }
    // where motion is not wanted each stands in its first state, at that state's moment
    await browser.media('light', 'reduce');
    for (const what of await browser.run(`const bad = [];
        for (const f of live_figures) {
            await f.start();
            const {time} = f.controls.states[0], before = f.time;
            await sleep(100);
            const stood = !f.playing && f.time === before;
            f.call('step'); f.tell();                           // it stands within a step of the state's moment
            if (!stood || Math.abs(before - time) > Math.max(0, f.time - before) + 1e-9) bad.push(f.name + ' under reduced motion: at ' + before + ', its state is at ' + time);
        }
        return bad;`)) complain(what);
    return weight(browser, name);
}

/// A phone in the dark, all figures started.
async function phone(browser, name) {
    await page_of(browser, name, {width: 360, scheme: 'dark'});
    const got = await browser.run('for (const f of live_figures) { f.share = 0.3; await f.start(); f.play(false); } return [document.documentElement.scrollWidth, live_figures.filter(f => f.wasm).length, live_figures.length, getComputedStyle(live_figures[0].canvas).touchAction]');
    need(got[0] <= 360 && got[1] === got[2] && got[3] === 'pan-y', `on a phone, all started: ${got}`);
    return weight(browser, name);
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
            const begun = Date.now(), light = await each_figure(browser, name), dark = await phone(browser, name);
            console.log(`  ${name}: ${(light / 1e6).toFixed(2)} MB light, ${(dark / 1e6).toFixed(2)} MB dark, its module and fonts included; ${((Date.now() - begun) / 1000).toFixed(0)} s`);
            need(Math.max(light, dark) <= 1.5e6, `the page weighs ${(Math.max(light, dark) / 1e6).toFixed(2)} MB`);
        }
        await without(browser, need, setting => page_of(browser, pages[0], setting));
    } catch (problem) { complain(problem.stack); }
    clearTimeout(limit);
    [...new Set(complaints)].forEach(c => console.log(c));
    console.log(`${pages.length} pages with figures that move: ${complaints.length} complaints`);
    browser.close(complaints.length ? 1 : 0);
})();
