// live.js: makes <figure class="live" data-chapter="01_newton" data-figure="planet"> move. It knows no figure: what is
// drawn, which controls there are and what they do come from the chapter's WebAssembly module. Without this script, without
// WebGL2, on paper and after a fault the still picture stays.
'use strict';
(() => {
const home = new URL('.', document.currentScript.src);
window.live_modules = window.live_modules || {};

// --- OpenGL for the module: its calls handed to WebGL2. One context for the whole page, made with the first figure. -----
let shared = null;
function context() {
    if (shared) return shared;
    const canvas = document.createElement('canvas');
    const gl = canvas.getContext('webgl2', {alpha: false, antialias: true, depth: true, powerPreference: 'low-power'});
    if (!gl) throw new Error('This browser gives no WebGL2, so the figure stays still.');
    canvas.addEventListener('webglcontextlost', event => {      // each figure falls back; the next start makes a new context
        event.preventDefault();
        shared = null;
        for (const figure of figures) if (figure.wasm) figure.fall_back('The graphics were reset. Start it again.');
    });
    return shared = {canvas, gl};
}
function gl_calls(gl, memory) {
    const things = [null], spots = [null], spot_of = new Map(), free = [];   // the module has numbers, WebGL has objects
    const keep = thing => { const i = free.length ? free.pop() : things.length; things[i] = thing; return i; };
    const drop = (i, how) => { if (i) { gl[how](things[i]); things[i] = null; free.push(i); } };
    const u32 = () => new Uint32Array(memory().buffer), i32 = () => new Int32Array(memory().buffer);   // anew: it may have grown
    const f32 = (at, n) => new Float32Array(memory().buffer, at, n), u8 = (at, n) => new Uint8Array(memory().buffer, at, n);
    const text = at => { const bytes = u8(0), end = bytes.indexOf(0, at); return new TextDecoder().decode(bytes.subarray(at, end)); };
    const gen = make => (n, at) => { for (let i = 0; i < n; ++i) u32()[(at >> 2) + i] = keep(gl[make]()); };
    const del = how => (n, at) => { for (let i = 0; i < n; ++i) drop(u32()[(at >> 2) + i], how); };
    const log = (words, room, at) => {
        const bytes = new TextEncoder().encode(words || '').subarray(0, room - 1);
        u8(at, room).set(bytes);
        u8(at, room)[bytes.length] = 0;
    };
    const same = ['Viewport', 'Clear', 'Enable', 'Disable', 'DepthFunc', 'BlendFunc', 'TexParameteri', 'DrawArrays', 'ReadBuffer',
        'EnableVertexAttribArray'];
    const calls = Object.fromEntries(same.map(n => ['gl' + n, gl[n[0].toLowerCase() + n.slice(1)].bind(gl)]));
    let linked = 0;
    const dispose = () => { for (const thing of things) if (thing) gl['delete' + thing.constructor.name.replace(/^WebGL|Object$/g, '')](thing); };
    return [dispose, Object.assign(calls, {
        glCreateShader: kind => keep(gl.createShader(kind)),
        // the one line in which the shaders of a still and of a moving picture differ
        glShaderSource: (id, n, at) => gl.shaderSource(things[id], text(u32()[at >> 2]).replace('#version 330 core',
            '#version 300 es\nprecision highp float; precision highp int; precision highp sampler2DShadow;')),
        glCompileShader: id => gl.compileShader(things[id]),
        glGetShaderiv: (id, what, at) => { i32()[at >> 2] = gl.getShaderParameter(things[id], what); },
        glGetShaderInfoLog: (id, room, length, at) => log(gl.getShaderInfoLog(things[id]), room, at),
        glDeleteShader: id => drop(id, 'deleteShader'),
        glCreateProgram: () => keep(gl.createProgram()),
        glAttachShader: (p, s) => gl.attachShader(things[p], things[s]),
        glLinkProgram: p => { gl.linkProgram(things[p]); ++linked; },
        glGetProgramiv: (p, what, at) => { i32()[at >> 2] = gl.getProgramParameter(things[p], what); },
        glGetProgramInfoLog: (p, room, length, at) => log(gl.getProgramInfoLog(things[p]), room, at),
        glDeleteProgram: p => drop(p, 'deleteProgram'),
        glUseProgram: p => gl.useProgram(things[p]),
        glGetUniformLocation(p, name) {                         // names are literals: the same address is the same name
            const key = p * 0x100000000 + name;
            let at = spot_of.get(key);
            if (at === undefined) spot_of.set(key, at = spots.push(gl.getUniformLocation(things[p], text(name))) - 1);
            return at;
        },
        glUniform1i: (at, x) => gl.uniform1i(spots[at], x),
        glUniform1f: (at, x) => gl.uniform1f(spots[at], x),
        glUniform2fv: (at, n, v) => gl.uniform2fv(spots[at], f32(v, 2 * n)),
        glUniform3fv: (at, n, v) => gl.uniform3fv(spots[at], f32(v, 3 * n)),
        glUniformMatrix3fv: (at, n, t, v) => gl.uniformMatrix3fv(spots[at], !!t, f32(v, 9 * n)),
        glUniformMatrix4fv: (at, n, t, v) => gl.uniformMatrix4fv(spots[at], !!t, f32(v, 16 * n)),
        glGenVertexArrays: gen('createVertexArray'), glDeleteVertexArrays: del('deleteVertexArray'),
        glGenBuffers: gen('createBuffer'), glDeleteBuffers: del('deleteBuffer'),
        glGenTextures: gen('createTexture'), glDeleteTextures: del('deleteTexture'),
        glGenFramebuffers: gen('createFramebuffer'), glDeleteFramebuffers: del('deleteFramebuffer'),
        glBindVertexArray: i => gl.bindVertexArray(things[i]),
        glBindBuffer: (where, i) => gl.bindBuffer(where, things[i]),
        glBindTexture: (where, i) => gl.bindTexture(where, things[i]),
        glBindFramebuffer: (where, i) => gl.bindFramebuffer(where, things[i]),      // 0: the canvas
        glBufferData: (where, bytes, at, use) => at ? gl.bufferData(where, u8(at, bytes), use) : gl.bufferData(where, bytes, use),
        glVertexAttribPointer: (i, n, kind, unit, stride, at) => gl.vertexAttribPointer(i, n, kind, !!unit, stride, at),
        glTexImage2D: (where, level, inside, w, h, edge, format, kind) => gl.texImage2D(where, level, inside, w, h, edge, format, kind, null),
        glFramebufferTexture2D: (where, place, kind, i, level) => gl.framebufferTexture2D(where, place, kind, things[i], level),
        glDrawBuffers: (n, at) => gl.drawBuffers([...u32().subarray(at >> 2, (at >> 2) + n)]),
        glDrawElements: (kind, n, type, at) => gl.drawElements(kind, n, type, at),
        glDepthMask: on => gl.depthMask(!!on),
        glColorMask: (r, g, b, a) => gl.colorMask(!!r, !!g, !!b, !!a),
    })];
}

// --- a chapter's module: a script beside this one, loaded when its first figure is started --------------------------------
const compiled = new Map();
function module_of(chapter) {
    if (!compiled.has(chapter)) compiled.set(chapter, (async () => {
        if (!live_modules[chapter]) await new Promise((resolve, reject) => {
            const script = Object.assign(document.createElement('script'), {src: new URL(chapter + '.js', home).href, onload: resolve,
                onerror: () => reject(new Error(`The file live/${chapter}.js is missing: ./course run makes it.`))});
            document.head.append(script);
        });
        const bytes = Uint8Array.from(atob(live_modules[chapter]), c => c.charCodeAt(0));
        delete live_modules[chapter];
        const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
        return WebAssembly.compile(await new Response(unpacked).arrayBuffer());
    })());
    return compiled.get(chapter);
}

// --- small helpers -------------------------------------------------------------------------------------------------------
const still = matchMedia('(prefers-reduced-motion: reduce)'), dark = matchMedia('(prefers-color-scheme: dark)');
const make = (name, properties = {}, ...inside) => { const e = Object.assign(document.createElement(name), properties); e.append(...inside); return e; };
const button = (words, onclick) => make('button', {type: 'button', textContent: words, onclick});
const pen = document.createElement('canvas').getContext('2d');
const raised = n => String(n).replace(/[-\d]/g, c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);
function written(value) {
    if (value === null || !Number.isFinite(value)) return 'lost';
    const size = Math.abs(value), minus = value < 0 ? '−' : '';
    if (size === 0) return '0';
    if (size >= 1e-3 && size < 1e5) return minus + (size >= 100 ? Math.round(size) : size.toPrecision(3));
    const power = Math.floor(Math.log10(size));
    return `${minus}${(size / 10 ** power).toPrecision(3)}·10${raised(power)}`;
}
const with_unit = (number, unit) => unit === '%' ? `${number} %` : unit ? `${number} ${unit}` : number;

/// A number against time, small: the last run, from its beginning.
class Trace {
    constructor(kind) {
        this.kind = kind;
        this.element = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
        this.element.setAttribute('viewBox', '0 0 160 36');
        this.element.setAttribute('preserveAspectRatio', 'none');
        this.element.setAttribute('class', 'trace');
        this.element.setAttribute('aria-hidden', 'true');
        this.line = this.element.appendChild(document.createElementNS('http://www.w3.org/2000/svg', 'polyline'));
        this.clear();
    }
    clear() { this.points = []; this.line.setAttribute('points', ''); }
    add(time, value) {
        const y = this.kind === 'logarithmic' ? Math.log10(Math.max(Math.abs(value ?? NaN), 1e-16)) : value;
        if (!Number.isFinite(y)) return;
        const last = this.points.at(-1);
        if (last && time <= last[0]) return;
        this.points.push([time, y]);
        if (this.points.length > 600) this.points = this.points.filter((_, i) => i % 2 === 0);
    }
    draw() {
        if (this.points.length < 8) return;             // after a jump there is no run to show
        const ys = this.points.map(p => p[1]), most = Math.max(...ys, this.kind === 'linear' ? 0 : -Infinity),
            least = Math.min(...ys, this.kind === 'linear' ? 0 : Infinity), span = most - least || 1, end = this.points.at(-1)[0] || 1;
        this.line.setAttribute('points', this.points.map(([t, y]) => `${(160 * t / end).toFixed(1)},${(34 - 32 * (y - least) / span).toFixed(1)}`).join(' '));
    }
}

// --- one figure ------------------------------------------------------------------------------------------------------------
const figures = [];
class Live {
    constructor(figure) {
        this.figure = figure;
        this.name = figure.dataset.figure;
        const sheet = figure.querySelector('.sheet');
        this.stage = make('div', {className: 'stage'});
        sheet.replaceWith(this.stage);
        this.begin = button('▶ Make it move', () => this.start());
        this.begin.className = 'begin';
        this.note = make('p', {className: 'note'});
        this.note.setAttribute('role', 'status');               // spoken: only what is rare, never the running numbers
        this.stage.append(sheet, this.begin);
        this.stage.after(this.note);
        this.playing = this.seen = false;
        this.share = 1;                                         // of the width that is drawn: less where drawing is slow
        this.slow = 0;
        this.frames = 0;
        new IntersectionObserver(entries => { this.seen = entries.at(-1).isIntersecting; this.tick(); }).observe(this.stage);
    }
    /// Starts it, in a state of its own or the one that a link names.
    async start(key) {
        this.begin.disabled = true;
        this.note.textContent = '';
        try {
            if (!this.wasm) await this.instantiate();
            if (!this.canvas) this.build();
            this.figure.classList.add('lives');
            const state = this.controls.states.find(s => s.key === key) || this.controls.states[0];
            this.put(state);
            this.canvas.focus({preventScroll: true});
        } catch (problem) { this.fall_back(problem.message); }
        this.begin.disabled = false;
    }
    async instantiate() {
        const module = await module_of(this.figure.dataset.chapter), {gl} = context(), utf8 = new TextDecoder();
        let wasm;
        const memory = () => wasm.exports.memory, words = (at, n) => utf8.decode(new Uint8Array(memory().buffer, at, n));
        const page = {
            say: (at, n) => { this.said = words(at, n); },
            width: (at, n, height, bold) => { pen.font = `${bold ? 700 : 400} ${height}px "Book Sans", Lato, sans-serif`; return pen.measureText(words(at, n)).width; },
            now: () => performance.now(),
            caught: (at, n) => { throw new Error(words(at, n)); },
        };
        const wasi = new Proxy({}, {get: (_, name) => () => { if (name === 'proc_exit') throw new Error('The program gave up.'); return 52; }});
        const [dispose, env] = gl_calls(gl, memory);
        this.dispose = dispose;
        wasm = await WebAssembly.instantiate(module, {page, env, wasi_snapshot_preview1: wasi});
        wasm.exports._initialize();
        this.wasm = wasm.exports;
        const index = this.ask('names').indexOf(this.name);
        if (index < 0) throw new Error(`This page's module has no figure ${this.name}.`);
        this.wasm.make(index);
        this.controls = this.ask('controls');
    }
    /// Calls into the module. After a throw its stack is in pieces: the instance is dropped, the message shown, the page lives.
    call(name, ...values) {
        try { return this.wasm[name](...values); }
        catch (problem) { this.fall_back(problem.message); throw problem; }
    }
    ask(name, ...values) { this.call(name, ...values); return JSON.parse(this.said); }
    fall_back(message) {
        this.play(false);
        if (this.wasm && shared) this.dispose();                // what the instance had on the graphics card
        this.wasm = null;
        this.figure.classList.remove('lives');
        this.note.textContent = message;
    }

    // --- its controls
    build() {
        const {width, height, choices, sliders} = this.controls;
        const canvas = this.canvas = make('canvas', {tabIndex: 0}), alternative = this.stage.querySelector('img').alt;
        this.stage.style.setProperty('--shape', width / height);
        canvas.setAttribute('role', 'img');
        canvas.setAttribute('aria-label', `${alternative} It moves: arrow keys turn the camera, plus and minus go nearer and away, space plays and pauses.`);
        this.paper = canvas.getContext('2d', {alpha: false});
        this.letters = make('div', {className: 'words letters'});
        this.letters.setAttribute('aria-hidden', 'true');
        this.stage.append(canvas, this.letters);
        this.listen(canvas);
        this.pause = button('Pause', () => this.play(!this.playing));
        const again = button('Again', () => this.apply(true)), step = button('One step', () => {
            this.play(false);
            try { this.call('step'); this.tell(); this.draw(true); } catch { return; }
        });
        this.values = sliders.map(s => s.start);
        this.choice = 0;
        this.sliders = sliders.map((slider, i) => this.slider(slider, i));
        const ways = make('fieldset', {className: 'ways'}, make('legend', {textContent: 'method'}));
        this.radios = choices.map((choice, i) => {
            const radio = make('input', {type: 'radio', name: `${this.figure.dataset.chapter}-${this.name}`, onchange: () => { this.choice = i; this.apply(true); }});
            const label = make('label', {}, radio, make('span', {textContent: choice.name}));
            label.style.cssText = `--light: ${choice.light}; --dark: ${choice.dark}`;
            ways.append(label);
            return radio;
        });
        this.numbers = make('div', {className: 'numbers'});
        const bar = make('div', {className: 'controls'}, make('div', {className: 'play'}, this.pause, again, step));
        if (choices.length) bar.append(ways);
        bar.append(...this.sliders.map(s => s.element));
        this.note.before(bar, this.numbers);
        this.cells = null;
    }
    slider({name, unit, least, most, logarithmic}, i) {
        const to = x => logarithmic ? Math.log(x / least) / Math.log(most / least) : (x - least) / (most - least);
        const back = s => logarithmic ? least * (most / least) ** s : least + s * (most - least);
        const range = make('input', {type: 'range', min: 0, max: 1, step: 0.0025});
        const shown = make('output', {}), tick = make('span', {className: 'tick', hidden: true});
        shown.setAttribute('aria-live', 'off');
        const put = value => {
            this.values[i] = value;
            range.value = to(value);
            const words = with_unit(written(value).replace(/(\.\d*?)0+(?=·|$)/, '$1').replace(/\.(?=·|$)/, ''), unit);
            shown.textContent = words;
            range.setAttribute('aria-valuetext', words);
        };
        range.oninput = () => {
            const s = +range.value, exact = back(s);
            put(s === 0 ? least : s === 1 ? most : exact >= 100 ? Math.round(exact) : +exact.toPrecision(3));
            this.apply(false);
        };
        const mark = ({mark: at, words}) => {
            tick.hidden = !(at >= least && at <= most);
            tick.textContent = words;
            tick.style.setProperty('--at', Math.min(Math.max(to(at), 0), 1));
        };
        const element = make('label', {className: 'slider'}, make('span', {textContent: name}), make('span', {className: 'track'}, range, tick), shown);
        return {element, put, mark, range};
    }
    listen(canvas) {
        let from = null;
        const place = e => { const box = canvas.getBoundingClientRect(); return [e.clientX - box.left, e.clientY - box.top]; };
        canvas.onpointerdown = e => {
            if (!this.wasm) return;
            from = [e.clientX, e.clientY];
            canvas.setPointerCapture(e.pointerId);
            try { this.held = !!this.call('grab', ...place(e)); } catch { return; }
        };
        canvas.addEventListener('touchstart', e => { if (this.held) e.preventDefault(); }, {passive: false});   // else upwards scrolls
        canvas.onpointermove = e => {
            if (!from || !this.wasm) return;
            if (this.held) {
                try { this.call('drag', ...place(e)); } catch { return; }
                if (!this.playing) this.draw(true);
            } else {
                this.turn(0.008 * (e.clientX - from[0]), 0.006 * (e.clientY - from[1]), 1);
            }
            from = [e.clientX, e.clientY];
        };
        canvas.onpointerup = canvas.onpointercancel = () => {
            if (this.held && this.wasm) try { this.call('release'); } catch { return; }
            from = null;
            this.held = false;
        };
        canvas.onkeydown = e => {
            const by = {ArrowLeft: [-.1, 0, 1], ArrowRight: [.1, 0, 1], ArrowUp: [0, .07, 1], ArrowDown: [0, -.07, 1], '+': [0, 0, .9], '-': [0, 0, 1.1]}[e.key];
            if (by) this.turn(...by);
            else if (e.key === ' ') this.play(!this.playing);
            else return;
            e.preventDefault();
        };
    }
    turn(right, up, nearer) {
        if (!this.wasm) return;
        try { this.call('turn', right, up, nearer); } catch { return; }
        if (!this.playing) this.draw(true);
    }
    /// Puts it into a state of its own; where motion is not wanted, at the state's moment.
    put(state) {
        this.choice = state.choice;
        state.values.forEach((value, i) => this.sliders[i].put(value));
        this.radios.forEach((radio, i) => { radio.checked = i === this.choice; });
        this.apply(true);
        if (still.matches && this.wasm) this.go(state.time);
    }
    go(time) {
        this.play(false);
        try { this.call('go', time); this.tell(); this.draw(true); } catch { return; }
    }
    /// Hands the controls to the figure. @param again from the beginning
    apply(again) {
        if (!this.wasm) return;
        const ended = this.ended;
        this.note.textContent = '';
        try {
            this.call('choose', this.choice);
            this.values.forEach((value, i) => this.call('set', i, value));
            this.call('apply', again || ended ? 1 : 0);
            this.ask('marks').forEach((slider, i) => this.sliders[i].mark(slider));
            const colour = this.controls.choices[this.choice];
            if (colour) this.figure.style.cssText += `;--way-light: ${colour.light}; --way-dark: ${colour.dark}`;
            this.tell();
            this.draw(true);
        } catch { return; }
        if ((again || ended) && !still.matches) this.play(true);
    }

    // --- time
    play(on) {
        this.playing = on;
        this.last = 0;
        if (this.pause) this.pause.textContent = on ? 'Pause' : 'Play';
        if (on && this.ended) return this.apply(true);
        this.tick();
    }
    /// Asks for the next frame only while there is one to be seen: playing, on the screen, and the page in front.
    tick() {
        if (this.asked || !this.playing || !this.seen || document.hidden || !this.wasm) return;
        this.asked = true;
        requestAnimationFrame(now => {
            this.asked = false;
            if (!this.playing || !this.seen || document.hidden || !this.wasm) { this.last = 0; return; }   // time off the screen is no time
            const gap = this.last ? (now - this.last) / 1000 : 0;
            this.last = now;
            this.pace(gap);
            ++this.frames;
            try {
                this.call('advance', Math.min(gap, 0.1));
                const words = this.frames % 6 === 0;
                if (this.frames % 2 === 0) this.tell(words);
                this.draw(words);
                if (this.ended) { this.tell(); this.draw(true); this.play_ends(); }
            } catch { return; }
            this.tick();
        });
    }
    play_ends() {
        this.playing = false;
        this.pause.textContent = 'Play';
        this.note.textContent = this.ended;
    }
    /// After a second of slow frames it is drawn coarser: better soft than jerky.
    pace(gap) {
        this.slow = gap > 1 / 24 ? this.slow + gap : 0;
        if (this.slow > 1 && this.share > 0.3) { this.share *= 0.7; this.slow = 0; }
    }

    // --- what is seen
    /// Asks for the numbers; writes them where `show` says so.
    tell(show = true) {
        const {time, ended, numbers} = this.ask('numbers');
        this.ended = ended;
        if (!this.cells || this.cells.length !== numbers.length) {
            this.cells = numbers.map(({name, trace}) => ({value: make('b', {}), name: make('span', {textContent: name}), trace: trace ? new Trace(trace) : null}));
            this.numbers.replaceChildren(...this.cells.map(c => make('p', {}, c.name, c.value, ...(c.trace ? [c.trace.element] : []))));
        }
        if (time === 0 || time < this.time) for (const cell of this.cells) if (cell.trace) cell.trace.clear();
        this.time = time;
        numbers.forEach(({name, value, unit}, i) => {
            const cell = this.cells[i];
            if (show) cell.name.textContent = name;
            if (cell.trace) cell.trace.add(time, value);
            if (!show) return;
            cell.value.textContent = with_unit(written(value), unit);
            if (cell.trace) cell.trace.draw();
        });
    }
    draw(with_words) {
        const {canvas} = context(), samples = Math.min(Math.max(Math.round(devicePixelRatio || 1), 1), 2);
        const width = this.stage.clientWidth, height = Math.round(width * this.controls.height / this.controls.width);
        const drawn = Math.max(64, Math.round(width * this.share)), rows = Math.max(1, Math.round(drawn * height / width));
        for (const c of [canvas, this.canvas])                  // figures of one width do not make each other's canvas anew
            if (c.width !== samples * drawn || c.height !== samples * rows) { c.width = samples * drawn; c.height = samples * rows; }
        this.call('draw', width, height, drawn, samples, dark.matches ? 1 : 0, with_words ? 1 : 0);
        this.paper.drawImage(canvas, 0, 0);
        if (!with_words) return;
        this.letters.replaceChildren(...JSON.parse(this.said).map(({text, left, right, baseline, height: size, ends, bold, light, dark: night}) => {
            const line = make('span', {textContent: text, className: bold ? 'bold' : 'quiet'});
            line.style.cssText = `${ends ? `right: ${width - right}px` : `left: ${left}px`}; top: ${baseline - 0.97 * size}px; --size: ${size}px; --light: ${light}; --dark: ${night}`;
            return line;
        }));
    }
}

// --- the page ----------------------------------------------------------------------------------------------------------------
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
})();
