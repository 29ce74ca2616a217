// letters.cjs BOOK: one letter, one meaning. Every letter of every formula of the woven book stands on the notation page:
// in the table of symbols, or in that of a chapter's own letters. A vector's letter without its arrow is its length; a dot is a
// rate. The reading itself is tried on formulas whose letters are known.
'use strict';
const fs = require('fs'), path = require('path');
const book = process.argv[2];
const text = s => s.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"').replace(/&#x27;/g, "'").replace(/&amp;/g, '&');
const greek = new Set(('alpha beta gamma delta epsilon varepsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi varphi chi psi omega '
    + 'Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega').split(' '));
const decorations = new Set(['vec', 'hat', 'mathcal', 'bar', 'tilde']);

/// The letters of a formula: "p", "\vec p", "\nu", "\mathcal R".
function letters(tex) {
    let rest = tex.replace(/\\(text|mathrm|operatorname|mathsf|begin|end|htmlClass|label|tag)\*?\s*\{[^{}]*\}(\{[^{}]*\})?/g, ' ')
        .replace(/\\mathrm\s*\w/g, ' ').replace(/\\(ddot|dot|boldsymbol|mathbf)\b/g, ' ').replace(/\\\[[^\]]*\]/g, ' ')
        .replace(/\[[\d.]+(ex|em)\]/g, ' ');
    const found = [];
    let decorated = '';
    for (const [token] of rest.matchAll(/\\[A-Za-z]+|[A-Za-z]|\{|\S/g)) {
        const name = token.startsWith('\\') ? token.slice(1) : '';
        if (decorations.has(name)) { decorated = token + ' '; continue; }
        if (token === '{') continue;                        // \vec{p} is \vec p
        if (greek.has(name) || /^[A-Za-z]$/.test(token)) found.push(decorated + token);
        decorated = '';
    }
    return found;
}
const same = (tex, want) => {
    const got = letters(tex).join(' | ');
    if (got !== want) { console.log(`letters of ${tex}: ${got}, not ${want}`); process.exit(1); }
};
same('\\vec{p}_t + \\nu\\,dt\\;\\text{if } \\e^{-x}', '\\vec p | t | \\nu | d | t | x');
same('\\hat n\\cdot\\dot m\\,\\mathrm{m/s}', '\\hat n | m');

const formulas = html => [...html.matchAll(/<annotation encoding="application\/x-tex">([\s\S]*?)<\/annotation>/g)].map(m => text(m[1]));
const notation = fs.readFileSync(path.join(book, 'notation.html'), 'utf8');
const known = new Set(), own = {};
for (const [, row] of notation.matchAll(/<tr[^>]*>([\s\S]*?)<\/tr>/g)) {
    const cells = [...row.matchAll(/<t[dh][^>]*>([\s\S]*?)<\/t[dh]>/g)].map(m => m[1]);
    if (!cells.length) continue;
    const chapter = cells.length === 3 && cells[1].replace(/<[^>]*>/g, '').match(/^\s*chapter (\d)\s*$/);
    for (const letter of formulas(cells[0]).flatMap(letters)) {
        if (chapter) (own[chapter[1]] = own[chapter[1]] || new Set()).add(letter);
        else if (cells.length === 4) known.add(letter);
    }
}
const bad = [];
let count = 0;
for (const file of fs.readdirSync(book).filter(f => f.endsWith('.html') && f !== 'notation.html' && f !== 'errata.html')) {
    const chapter = (file.match(/^0(\d)/) || [])[1];
    for (const tex of formulas(fs.readFileSync(path.join(book, file), 'utf8')))
        for (const letter of letters(tex)) {
            ++count;
            const has = l => known.has(l) || (own[chapter] && own[chapter].has(l));
            if (!has(letter) && !has('\\vec ' + letter)) bad.push(`${file}: ${letter} in ${tex.replace(/\s+/g, ' ').slice(0, 70)}`);
        }
}
for (const what of [...new Set(bad)]) console.log(what);
console.log(`${count} letters, ${known.size} known, ${bad.length} not`);
process.exit(bad.length || !count || known.size < 30 ? 1 : 0);
