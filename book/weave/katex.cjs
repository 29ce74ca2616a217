// katex.cjs KATEX_DIR BOOK_DIR: sets every <span class="tex"> of the woven pages in place, so that the reader's browser
// runs no script, and copies KaTeX's style sheet and fonts beside them. Bad TeX is reported with page and line, and the exit code is 1.
'use strict';
const fs = require('fs'), path = require('path');
const [katexDir, book] = process.argv.slice(2);
const katex = require(path.resolve(katexDir, 'katex.js'));

const macros = {
    '\\norm': '\\lVert #1 \\rVert',
    '\\abs': '\\lvert #1 \\rvert',
    '\\e': '\\mathrm{e}',          // Euler's number; e is the restitution
    '\\ii': '\\mathrm{i}',         // the quarter turn; i is an index
};
const text = s => s.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&amp;/g, '&');
const set = new Map();                           // the same formula is set once
let bad = 0;
const pages = folder => fs.existsSync(path.join(book, folder))
    ? fs.readdirSync(path.join(book, folder)).filter(f => f.endsWith('.html')).map(f => path.join(folder, f)) : [];
for (const file of [...pages('.'), ...pages('open')]) {
    const page = path.join(book, file);
    const html = fs.readFileSync(page, 'utf8');
    const done = html.replace(/<span class="tex( display)?" data-at="([^"]*)">([\s\S]*?)<\/span>/g, (_, display, at, escaped) => {
        const key = (display || '') + escaped;
        if (!set.has(key)) {
            try {
                set.set(key, katex.renderToString(text(escaped), {displayMode: !!display, throwOnError: true, strict: 'error',
                    output: 'htmlAndMathml', macros: {...macros}}));
            } catch (e) {
                const why = e.message.replace(/^KaTeX parse error: |\u0332/g, '').split('\n')[0];
                console.error(`${at}: bad TeX: ${why}\n    ${text(escaped).trim()}`);
                ++bad;
                return '?';
            }
        }
        return set.get(key);
    });
    if (done !== html) fs.writeFileSync(page, done);
}
if (bad) process.exit(1);

// Style sheet and fonts: every browser that can show this book takes WOFF2, so the other formats stay behind.
const out = path.join(book, 'katex');
fs.mkdirSync(path.join(out, 'fonts'), {recursive: true});
const css = fs.readFileSync(path.join(katexDir, 'katex.css'), 'utf8')
    .replace(/src:([^;}]*)/g, (all, list) => (list.match(/url\([^)]*\.woff2["']?\)\s*format\([^)]*\)/) || [null])[0]
        ?.replace(/^/, 'src: ') ?? all);
fs.writeFileSync(path.join(out, 'katex.css'), css);
for (const [, font] of css.matchAll(/url\(["']?(fonts\/[^)"']+\.woff2)["']?\)/g))
    fs.copyFileSync(path.join(katexDir, font), path.join(out, font));
