// module.cjs: a chapter's WebAssembly module without a browser: OpenGL that does nothing but says that all is well.
'use strict';
const fs = require('fs');

/// @return {wasm: its exports, ask(name, values…): what it answers, names: of its figures}
exports.load = async function load(file) {
    const module = new WebAssembly.Module(fs.readFileSync(file));
    let wasm, said = '';
    const words = (at, n) => Buffer.from(wasm.memory.buffer, at, n).toString();
    const nothing = new Proxy({}, {get: () => () => 0});
    const page = {say: (at, n) => { said = words(at, n); }, width: () => 0, now: () => 0, caught: (at, n) => { throw new Error(words(at, n)); }};
    const env = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module)) if (from === 'env') env[name] = () => 1;
    env.glGetShaderiv = env.glGetProgramiv = (id, what, at) => { new Int32Array(wasm.memory.buffer)[at >> 2] = 1; };
    wasm = (await WebAssembly.instantiate(module, {page, env, wasi_snapshot_preview1: nothing})).exports;
    wasm._initialize();
    const ask = (name, ...values) => { wasm[name](...values); return JSON.parse(said); };
    return {wasm, ask, names: ask('names')};
};
