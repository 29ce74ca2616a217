// without.cjs: what a figure does without: off the screen, in the back, slow, in a closed fold, after a fault, on paper, without
// WebGL2. Tried on a page's first one.
'use strict';

/// @param need(held, what) collects complaints    @param reload(setting) opens the page anew
exports.without = async function without(browser, need, reload) {
    const first = 'const f = live_figures[0]; ';
    await reload({});
    await browser.run(first + 'f.share = 0.3; f.stage.scrollIntoView({block: "center"}); await f.start(); await sleep(600);');
    let got = await browser.run(first + 'scrollTo(0, document.body.scrollHeight); for (let n = 0; f.seen && n < 100; ++n) await sleep(100); await sleep(100); const n = f.frames; await sleep(500); return [n, f.frames, f.playing]');
    need(got[0] === got[1] && got[2], `scrolled away, and it still asks for frames: ${got}`);
    got = await browser.run(first + `f.stage.scrollIntoView({block: "center"}); f.play(true); await sleep(300);
        const hide = on => { Object.defineProperty(document, 'hidden', {configurable: true, get: () => on}); document.dispatchEvent(new Event('visibilitychange')); };
        hide(true); await sleep(200); const n = f.frames, t = f.time; await sleep(500); const stood = [f.frames - n, f.time - t];
        hide(false); await sleep(700); return [...stood, f.frames > n]`);
    need(got[0] === 0 && got[1] === 0 && got[2], `a page in the back asks for frames, or in front again for none: ${got}`);
    got = await browser.run(first + `f.share = 1; f.draw(); const fine = f.canvas.width; f.play(false); for (let n = 0; n < 20; ++n) f.pace(0.2);
        f.draw(); const coarse = f.canvas.width, share = f.share; f.share = 0.3; return [fine, coarse, share]`);
    need(got[1] < 0.5 * got[0] && got[2] > 0.15, `slow frames are not drawn coarser: ${got}`);
    got = await browser.run(first + `f.figure.style.display = 'none'; dispatchEvent(new Event('resize')); f.figure.style.display = ''; dispatchEvent(new Event('resize')); return !!f.wasm`);
    need(got, 'resized in a closed fold, and it is gone');
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
