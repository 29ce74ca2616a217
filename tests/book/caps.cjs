// caps.cjs BOOK: a page can be finished. As the weaver counts (lengths.csv): a page of the main road has at most 3500 words, the
// toolbox 2500, captions and folded answers among them; from chapter 3 on at most 14 numbered figures. The first exercise of a
// page that begins a chapter stands before the eighth minute: so it is typed and checked within ten.
'use strict';
const fs = require('fs'), path = require('path');
const rows = fs.readFileSync(path.join(process.argv[2], 'lengths.csv'), 'utf8').trim().split('\n').slice(1).map(l => l.split(','));
const bad = [], halves = /^0[67]a_/;
let pages = 0;
for (const [page, words, figures, , , first] of rows) {
    if (/^\d\d[a-z]_/.test(page) && !halves.test(page)) continue;      // a side road
    ++pages;
    console.log(`${page}: ${words} words, ${figures} figures, first exercise after ${first} minutes`);
    const most = page.startsWith('00') ? 2500 : 3500;
    if (+words > most) bad.push(`${page}: ${words} words, at most ${most}`);
    if (parseInt(page) >= 3 && +figures > 14) bad.push(`${page}: ${figures} numbered figures, at most 14`);
    if (!first || +first >= 8) bad.push(`${page}: the first exercise comes after ${first || 'no'} minutes`);
}
for (const what of bad) console.log(what);
process.exit(bad.length || pages < 4 ? 1 : 0);
