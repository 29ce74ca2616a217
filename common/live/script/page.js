// page.js: all figures of a page, the links into them, and ./course live N --mine.
if (typeof WebAssembly === 'object' && 'IntersectionObserver' in window && 'DecompressionStream' in window)
    for (const figure of document.querySelectorAll('figure.live')) if (figure.querySelector('.sheet')) figures.push(new Live(figure));
document.addEventListener('visibilitychange', () => { for (const f of figures) { f.last = 0; f.tick(); } });
still.addEventListener('change', () => { if (still.matches) for (const f of figures) f.play(false); });
dark.addEventListener('change', () => { for (const f of figures) if (f.wasm) f.draw(true); });
addEventListener('resize', () => { for (const f of figures) if (f.wasm) f.draw(true); });
document.addEventListener('click', event => {
    const link = event.target.closest && event.target.closest('a[data-state]');
    const live = link && figures.find(f => f.name === link.dataset.figure);
    if (!live) return;                                          // an ordinary link to the figure
    event.preventDefault();
    live.start(link.dataset.state);
    const box = live.stage.getBoundingClientRect();
    if (box.top < 0 || box.bottom > innerHeight) live.stage.scrollIntoView({block: 'center', behavior: still.matches ? 'auto' : 'smooth'});
});
// ./course live N --mine: the same page on the reader's own answers. Once a second it asks whether they were built again.
if (window.live_is_mine) {
    let version = null;
    const alive = sessionStorage.getItem('alive');
    if (alive) for (const f of figures) if (JSON.parse(alive).includes(f.name)) f.start();
    window.live_mine = (stamp, sentence) => {
        if (version !== null && version !== stamp && !sentence) {
            sessionStorage.setItem('alive', JSON.stringify(figures.filter(f => f.wasm).map(f => f.name)));
            location.reload();
        }
        if (version !== stamp) for (const f of figures) f.note.textContent = sentence ? sentence + ' (What moves is the last that worked.)' : '';
        version = stamp;
    };
    setInterval(() => {
        const script = Object.assign(document.createElement('script'), {src: new URL('mine.js?' + Date.now(), home).href});
        script.onload = script.onerror = () => script.remove();
        document.head.append(script);
    }, 1000);
}
window.live_figures = figures;                                  // for tests
