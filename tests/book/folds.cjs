// folds.cjs BOOK PROJECT: write before you read. For every exercise of the headers, on every page up to its chapter:
// its body, and every line that is found only in it, stands in a fold, except for a chapter's one worked example. On each
// page with exercises the first stands in the first third. The open edition shows every body: so the search is known to find.
'use strict';
const fs = require('fs'), path = require('path');
const [book, project] = process.argv.slice(2);
const plain = html => html.replace(/<[^>]*>/g, '').replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&quot;/g, '"')
    .replace(/&#39;/g, "'").replace(/&nbsp;/g, ' ').replace(/&amp;/g, '&');
const squeezed = line => line.replace(/\s+/g, ' ').trim();

// --- the bodies, and how often each line stands in the headers -----------------------------------------------------
const bodies = {}, seen = new Map();
for (const chapter of fs.readdirSync(path.join(project, 'chapters'))) {
    const folder = path.join(project, 'chapters', chapter, 'nutshell');
    if (!/^\d\d_/.test(chapter) || !fs.existsSync(folder)) continue;
    for (const file of fs.readdirSync(folder)) {
        let id = null;
        for (const text of fs.readFileSync(path.join(folder, file), 'utf8').split('\n')) {
            const line = squeezed(text), begin = line.match(/^\/\/ exercise (\d+\.\d+)$/);
            if (begin) bodies[id = begin[1]] = [];
            else if (/^\/\/ end \d+\.\d+$/.test(line)) id = null;
            else if (line) {
                seen.set(line, (seen.get(line) || 0) + 1);
                if (id) bodies[id].push(line);
            }
        }
    }
}

// --- what a page shows outside its folds ---------------------------------------------------------------------------
function unfolded(html) {
    let depth = 0, out = '';
    for (const piece of html.split(/(<details[^>]*>|<\/details>)/)) {
        if (piece.startsWith('<details')) ++depth;
        else if (piece === '</details>') --depth;
        else if (!depth) out += piece;
    }
    return out;
}
const main = html => html.slice(html.indexOf('<main'), html.indexOf('</main>'));
const lines = html => new Set([...html.matchAll(/<pre[^>]*>([\s\S]*?)<\/pre>/g)].flatMap(m => plain(m[1]).split('\n').map(squeezed)));

const bad = [], asked = new Set(), found = new Set();
const earlier = (id, file) => parseInt(id) < parseInt(file);      // a later chapter's page may quote what was written before
const pages = fs.readdirSync(book).filter(f => f.endsWith('.html'));
for (const file of pages) {
    const html = main(fs.readFileSync(path.join(book, file), 'utf8'));
    const outside = unfolded(html), shown = lines(outside);
    const example = [...html.matchAll(/Exercise (\d+\.\d+): a worked example/g)].map(m => m[1]);
    for (const [id, body] of Object.entries(bodies)) {
        if (example.includes(id) || earlier(id, file)) continue;
        if (body.every(line => shown.has(line)) && body.some(line => line.length > 20)) bad.push(`${file}: the whole body of ${id} stands outside a fold`);
        for (const line of body)
            if (seen.get(line) === 1 && shown.has(line)) bad.push(`${file}: a line of ${id} stands outside a fold: ${line}`);
    }
    for (const [, id] of html.matchAll(/id="ex:(\d+\.\d+)"/g)) asked.add(id);
    if (file.match(/^\d\d_/) && html.includes('id="ex:')) {
        const text = html.replace(/<svg[\s\S]*?<\/svg>/g, '').replace(/<span class="katex-mathml">[\s\S]*?<\/math><\/span>/g, '');
        const part = plain(text.slice(0, text.indexOf('id="ex:'))).length / plain(text).length;
        if (part > 1 / 3) bad.push(`${file}: the first exercise comes at ${Math.round(100 * part)} % of the page`);
    }
    const open = lines(main(fs.readFileSync(path.join(book, 'open', file), 'utf8')));
    for (const [id, body] of Object.entries(bodies)) if (body.every(line => open.has(line))) found.add(id);
}
for (const id of Object.keys(bodies)) {
    if (!asked.has(id)) bad.push(`exercise ${id} stands on no page`);
    if (!found.has(id)) bad.push(`the open edition shows no body of ${id}`);
}
for (const what of bad) console.log(what);
console.log(`${Object.keys(bodies).length} exercises, ${pages.length} pages`);
process.exit(bad.length || !Object.keys(bodies).length ? 1 : 0);
