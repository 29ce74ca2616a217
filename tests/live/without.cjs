// without.cjs: what a figure does without: off the screen, after a fault, on paper, without WebGL2. Tried on a page's first one.
'use strict';

/// @param need(held, what) collects complaints    @param reload(setting) opens the page anew
exports.without = async function without(browser, need, reload) {
    const first = 'const f = live_figures[0]; ';
    await reload({});
    await browser.run(first + 'f.share = 0.3; f.stage.scrollIntoView({block: "center"}); await f.start(); await sleep(600);');
    let got = await browser.run(first + 'scrollTo(0, document.body.scrollHeight); for (let n = 0; f.seen && n < 100; ++n) await sleep(100); await sleep(100); const n = f.frames; await sleep(500); return [n, f.frames, f.playing]');
    need(got[0] === got[1] && got[2], `scrolled away, and it still asks for frames: ${got}`);
    got = await browser.run(first + 'f.stage.scrollIntoView({block: "center"}); f.values[0] = NaN; f.apply(true); await sleep(50); return [f.wasm === null, f.note.textContent, f.stage.querySelector(".shot").getBoundingClientRect().width > 50]');
    need(got[0] && got[1].includes('must be') && got[2], `a fault of the physics is no sentence over the still: ${got}`);
    got = await browser.run(first + 'await f.start(); await sleep(300); const lives = !!f.wasm; [...contexts][0].getExtension("WEBGL_lose_context").loseContext(); await sleep(300); const lost = f.wasm === null; const words = f.note.textContent; await f.start(); return [lives, lost, words, !!f.wasm]');
    need(got[0] && got[1] && got[2] && got[3], `after a lost context: ${got}`);
    await browser.tell('Emulation.setEmulatedMedia', {media: 'print'});
    got = await browser.run(first + 'return [f.stage.querySelector(".shot").getBoundingClientRect().height > 50, getComputedStyle(f.canvas).display, getComputedStyle(f.pause.closest(".controls")).display]');
    need(got[0] && got[1] === 'none' && got[2] === 'none', `on paper: ${got}`);

    await reload({before: `{ const get = HTMLCanvasElement.prototype.getContext; HTMLCanvasElement.prototype.getContext = function (kind, ...rest) { return kind === 'webgl2' ? null : get.call(this, kind, ...rest); }; }`});
    got = await browser.run(first + 'await f.start(); return [f.wasm, f.note.textContent, f.stage.querySelector(".shot").getBoundingClientRect().width > 50]');
    need(!got[0] && got[1].includes('WebGL2') && got[2], `without WebGL2: ${got}`);
};
