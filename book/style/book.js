// The book reads without this. It finds words in all pages, without a server, and marks the section being read.
'use strict';
(() => {
    const base = document.currentScript.src.replace(/[^/]*$/, '');
    const here = base + (document.body.dataset.edition || '');      // pages of this edition

    // --- where the reader is: the section whose heading passed the top last -----------------------------------------
    const links = [...document.querySelectorAll('nav .here ol a[href^="#"]')];
    const headings = [...new Set(links.map(a => document.getElementById(decodeURIComponent(a.hash.slice(1)))))].filter(Boolean);
    const where = document.querySelector('.top .where');
    let marked = null;
    function mark() {
        let now = null;
        for (const h of headings) if (h.getBoundingClientRect().top < 140) now = h;
        if (now === marked) return;
        marked = now;
        for (const a of links) {
            if (now && decodeURIComponent(a.hash.slice(1)) === now.id) a.setAttribute('aria-current', 'true');
            else a.removeAttribute('aria-current');
        }
        if (where) where.textContent = now ? now.textContent : '';
        const side = document.querySelector('.side'), link = side && side.querySelector('[aria-current="true"]');
        if (!link) return;
        const l = link.getBoundingClientRect(), s = side.getBoundingClientRect();
        if (l.top < s.top + 40 || l.bottom > s.bottom - 40) side.scrollTop += l.top - s.top - s.height / 3;
    }
    if (headings.length) {
        let waiting = false;
        addEventListener('scroll', () => {
            if (waiting) return;
            waiting = true;
            requestAnimationFrame(() => { waiting = false; mark(); });
        }, {passive: true});
        mark();
    }

    // --- what scrolls sideways can be scrolled from the keyboard --------------------------------------------------------
    function reachable() {
        for (const e of document.querySelectorAll('.scroll, .katex-display, main pre'))
            if (e.scrollWidth > e.clientWidth + 1) e.tabIndex = 0;
    }
    reachable();
    addEventListener('resize', reachable);
    addEventListener('toggle', reachable, true);

    // --- search -----------------------------------------------------------------------------------------------------
    const plain = text => text.normalize('NFKD').replace(/[\u0300-\u036f]/g, '').toLowerCase();
    let index = null;
    function load() {
        if (index) return index;
        return index = new Promise((done, fail) => {
            const script = document.createElement('script');
            script.src = base + 'search-index.js';
            script.onload = () => done(window.nutshellIndex.map(([href, title, text]) => ({href, title, text, in_title: plain(title), in_text: plain(text)})));
            script.onerror = fail;
            document.head.append(script);
        });
    }
    function find(entries, words) {
        const found = [];
        for (const e of entries) {
            let score = 0;
            for (const w of words) {
                const at = e.in_text.indexOf(w), title = e.in_title.includes(w);
                if (at < 0 && !title) { score = -1; break; }
                score += (title ? 20 : 0) + Math.min(e.in_text.split(w).length - 1, 8);
            }
            if (score > 0) found.push([score, e]);
        }
        return found.sort((a, b) => b[0] - a[0]).slice(0, 12).map(f => f[1]);
    }
    function excerpt(entry, words) {
        const at = Math.max(0, ...words.map(w => entry.in_text.indexOf(w)).filter(i => i >= 0).slice(0, 1));
        const from = Math.max(0, entry.text.lastIndexOf(' ', Math.max(0, at - 40)));
        const text = (from ? '\u2026' : '') + entry.text.slice(from, from + 130) + (from + 130 < entry.text.length ? '\u2026' : '');
        const p = document.createElement('small');
        const low = plain(text);
        let last = 0;
        if (low.length === text.length)
            for (let i = 0; i < text.length;) {
                const w = words.find(word => low.startsWith(word, i));
                if (!w) { ++i; continue; }
                const m = document.createElement('mark');
                m.textContent = text.slice(i, i + w.length);
                p.append(text.slice(last, i), m);
                last = i += w.length;
            }
        p.append(text.slice(last));
        return p;
    }
    for (const form of document.querySelectorAll('form.search')) {
        const input = form.querySelector('input'), list = form.querySelector('ol'), told = form.querySelector('[role=status]');
        form.hidden = false;
        input.addEventListener('focus', load, {once: true});
        form.addEventListener('submit', e => { e.preventDefault(); const first = list.querySelector('a'); if (first) first.click(); });
        input.addEventListener('input', async () => {
            const words = plain(input.value).split(/\s+/).filter(w => w.length > 1);
            const entries = await load();
            if (plain(input.value).split(/\s+/).filter(w => w.length > 1).join() !== words.join()) return;   // typed on meanwhile
            const found = words.length ? find(entries, words) : [];
            list.replaceChildren(...found.map(e => {
                const item = document.createElement('li'), link = document.createElement('a');
                link.href = here + e.href;
                link.append(e.title, excerpt(e, words));
                item.append(link);
                return item;
            }));
            told.textContent = !words.length ? '' : found.length ? '' : 'Nothing found.';
        });
        form.addEventListener('keydown', e => { if (e.key === 'Escape') { input.value = ''; list.replaceChildren(); told.textContent = ''; } });
    }
})();
