// same.cjs MODULE.wasm NATIVE: every figure in every state by every method, 1000 steps, in WebAssembly and by the native
// program: the same bits, or within what the figure states.
'use strict';
const {execFileSync} = require('child_process'), {load} = require('./module.cjs');
const [file, native] = process.argv.slice(2);

(async () => {
    const {wasm, ask, names} = await load(file);
    let bad = 0, same = 0, near = 0;
    const lines = execFileSync(native, {encoding: 'utf8', maxBuffer: 1e9}).trim().split('\n').map(line => JSON.parse(line.replace(/-?\b(nan|inf)\b/g, 'null')));
    for (const {figure, state, choice, values, numbers} of lines) {
        wasm.make(names.indexOf(figure));
        wasm.choose(choice);
        values.forEach((value, i) => wasm.set(i, value));
        wasm.apply(1);
        for (let n = 0; n < 1000 && !ask('numbers').ended; ++n) wasm.step();
        const {tolerance, state: found} = ask('state');
        const largest = Math.max(1e-300, ...numbers.map(x => Math.abs(x || 0)));
        const off = Math.max(...numbers.map((x, i) => x === found[i] ? 0 : x === null || found[i] === null ? Infinity : Math.abs(x - found[i]) / largest));
        if (found.length !== numbers.length || !(off <= tolerance)) {
            ++bad;
            console.log(`${figure}, state ${state}, choice ${choice}: ${found.length} numbers for ${numbers.length}, off by ${off}, allowed ${tolerance}`);
        } else if (off === 0) ++same; else ++near;
    }
    console.log(`${lines.length} runs of ${names.length} figures: ${same} with the same bits, ${near} within their tolerance, ${bad} bad`);
    process.exit(bad || !lines.length ? 1 : 0);
})();
