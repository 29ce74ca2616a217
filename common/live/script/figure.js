// figure.js: makes one <figure class="live" data-chapter="01_newton" data-figure="planet"> move. It knows no figure: what is
// drawn, which controls there are and what they do come from the chapter's WebAssembly module. Without this script, without
// WebGL2, on paper and after a fault the still picture stays.
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
            if (!this.figure.classList.contains('lives'))       // as tall as its still was, so that the page does not jump
                this.stage.style.setProperty('--tall', Math.max(this.stage.clientHeight, 416) + 'px');
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
    slider({name, unit, least, most, logarithmic, whole}, i) {
        const to = x => logarithmic ? Math.log(x / least) / Math.log(most / least) : (x - least) / (most - least);
        const back = s => logarithmic ? least * (most / least) ** s : least + s * (most - least);
        const range = make('input', {type: 'range', min: 0, max: 1, step: whole && !logarithmic ? 1 / (most - least) : 0.0025});
        const shown = make('output', {}), tick = make('span', {className: 'tick', hidden: true});
        shown.setAttribute('aria-live', 'off');
        const show = value => {
            this.values[i] = value;
            const words = with_unit(written(value).replace(/(\.\d*?)0+(?=·|$)/, '$1').replace(/\.(?=·|$)/, ''), unit);
            shown.textContent = words;
            range.setAttribute('aria-valuetext', words);
        };
        const put = value => { range.value = to(value); show(value); };
        range.oninput = () => {                                 // the thumb stays where the hand or key has put it
            const s = +range.value, exact = back(s);
            show(s === 0 ? least : s === 1 ? most : whole || exact >= 100 ? Math.round(exact) : +exact.toPrecision(3));
            this.apply(false);
        };
        const mark = ({mark: at, words}) => {
            tick.hidden = !words || !(at >= least && at <= most);
            element.classList.toggle('plain', !words);
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
        if (!(again || ended) || still.matches) return;
        if (this.ended) this.play_ends();                       // a figure that is at its end where it begins
        else this.play(true);
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
            cell.value.textContent = with_unit(written(value, !unit), unit);
            if (cell.trace) cell.trace.draw();
        });
    }
    draw(with_words) {
        const {canvas} = context(), samples = Math.min(Math.max(Math.round(devicePixelRatio || 1), 1), 2);
        const width = this.stage.clientWidth;
        if (!width) return;                                     // in a fold that is closed
        const height = Math.round(width * this.controls.height / this.controls.width);
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
