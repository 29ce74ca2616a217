// axe.cjs BOOK AXE: asks axe-core (its axe.min.js) about every page of the book, light and dark, on a phone and a wide screen.
// Fails on a finding that axe calls serious or critical. Quoted source files are all alike: the first one stands for them.
'use strict';
const fs = require('fs'), path = require('path'), url = require('url');
const {pages_of, run} = require('./chromium.cjs');

const book = path.resolve(process.argv[2]), axe = fs.readFileSync(process.argv[3], 'utf8');
const all = pages_of(book).filter(page => !path.relative(book, page).startsWith('open'));
const is_source = page => path.relative(book, page).startsWith('source');
const pages = [...all.filter(page => !is_source(page)), ...all.filter(is_source).slice(0, 1)];

run(async ({tell, event}) => {
    for (const domain of ['Page', 'Runtime']) await tell(`${domain}.enable`);
    const found = new Map();
    for (const page of pages)
        for (const [width, scheme] of [[1280, 'light'], [360, 'dark']]) {
            await tell('Emulation.setDeviceMetricsOverride', {width, height: 800, deviceScaleFactor: 1, mobile: width < 500});
            await tell('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: scheme}]});
            const loaded = event('Page.loadEventFired');
            await tell('Page.navigate', {url: url.pathToFileURL(page).href});
            await loaded;
            await tell('Runtime.evaluate', {expression: axe});
            const {result, exceptionDetails} = await tell('Runtime.evaluate', {awaitPromise: true, returnByValue: true, expression:
                `(async () => { document.querySelectorAll('main details').forEach(d => d.open = true);
                    const {violations} = await axe.run(document, {resultTypes: ['violations']});
                    return violations.map(v => ({id: v.id, impact: v.impact, help: v.help, count: v.nodes.length,
                        where: [...new Map(v.nodes.map(n => [n.target.join().replace(/[^ ,>]*:nth-child\\([0-9]+\\)|#[^ >]*/g, ''), n])).values()].slice(0, 3).map(n => n.html.slice(0, 120) + ' | ' + n.failureSummary.split('\\n')[1]).join(' || ')})); })()`});
            if (exceptionDetails) throw new Error(exceptionDetails.exception.description);
            for (const v of result.value) {
                const key = `${v.impact}: ${v.id}: ${v.help}`;
                found.set(key, [...(found.get(key) || []), `${path.relative(book, page)} at ${width} px, ${scheme}: ${v.count}: ${v.where}`]);
            }
        }
    let grave = 0;
    for (const [what, places] of found) {
        const serious = /^(serious|critical)/.test(what);
        grave += serious;
        console.log(what);
        for (const place of places.slice(0, serious ? 6 : 2)) console.log('    ' + place);
    }
    console.log(`axe-core: ${pages.length} pages, two views each: ${found.size} kinds of finding, ${grave} of them serious`);
    return grave ? 1 : 0;
}, 10);
