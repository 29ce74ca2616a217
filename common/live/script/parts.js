// parts.js: a chapter's module, how numbers are written, and a number against time.
const home = new URL('.', document.currentScript.src);
window.live_modules = window.live_modules || {};

/// A chapter's module: a script beside this one, loaded when its first figure is started.
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

const still = matchMedia('(prefers-reduced-motion: reduce)'), dark = matchMedia('(prefers-color-scheme: dark)');
const make = (name, properties = {}, ...inside) => { const e = Object.assign(document.createElement(name), properties); e.append(...inside); return e; };
const button = (words, onclick) => make('button', {type: 'button', textContent: words, onclick});
const pen = document.createElement('canvas').getContext('2d');
const raised = n => String(n).replace(/[-\d]/g, c => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);
/// @param counted  whole numbers are written as such: 27 impacts
function written(value, counted) {
    if (value === null || !Number.isFinite(value)) return 'lost';
    if (counted && Number.isInteger(value) && Math.abs(value) < 1e6) return String(value).replace('-', '−');
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
