// limits.cjs MODULE.wasm…: what a reader finds by hand is what the page says. Every slider with a mark "limit …", or "sticks …", is put, for every
// method that has one, one and a half of its own positions below the mark and as far above: the figure's own words must say that
// it holds, and that it flew apart.
'use strict';
const {load} = require('./module.cjs');
const position = 0.0025, longest = 20000;       // of the page's sliders, common/live/script/figure.js; steps

let bad = 0, found = 0;

async function limits_of(file) {
    const {wasm, ask, names} = await load(file);
    for (const [index, name] of names.entries()) {
        wasm.make(index);
        const {choices, states} = ask('controls');
        for (const [choice, method] of choices.entries()) {
            const start = values => {
                wasm.choose(choice);
                values.forEach((value, i) => wasm.set(i, value));
                wasm.apply(1);
            };
            start(states[0].values);
            for (const [i, {mark, words, least, most, logarithmic}] of ask('marks').entries()) {
                if (!/^(limit|sticks)/.test(words) || !(mark > least && mark < most)) continue;
                const to = x => logarithmic ? Math.log(x / least) / Math.log(most / least) : (x - least) / (most - least);
                const back = s => logarithmic ? least * (most / least) ** s : least + s * (most - least);
                const apart = at => {
                    start(states[0].values.map((value, k) => k === i ? at : value));
                    let ended = '';
                    for (let n = 0; n < longest && !ended; n += 100) {
                        for (let k = 0; k < 100; ++k) wasm.step();
                        ended = ask('numbers').ended;
                    }
                    // a figure with several methods names those that flew apart
                    return /fl(ew|own|ies) apart|it slides/i.test(ended) && (!/: /.test(ended) || ended.includes(method.name));
                };
                const below = back(to(mark) - 1.5 * position), above = back(to(mark) + 1.5 * position);
                const holds = !apart(below), breaks = apart(above);
                ++found;
                if (!holds || !breaks) ++bad;
                console.log(`${name}, ${method.name}: limit ${mark.toPrecision(4)}; at ${below.toPrecision(4)} it ${holds ? 'holds' : 'FLIES APART'}, at ${above.toPrecision(4)} it ${breaks ? 'flies apart' : 'HOLDS'}`);
            }
        }
    }
}

(async () => {
    for (const file of process.argv.slice(2)) await limits_of(file);
    console.log(`${found} limits tried, ${bad} bad`);
    process.exit(bad || !found ? 1 : 0);
})();
