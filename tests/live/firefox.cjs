// firefox.cjs BOOK: every figure of the woven book that moves, in Firefox, where it is installed. On a display (its own, Xvfb, or
// the one that DISPLAY names) each starts, steps, and goes to each of its states; headless Firefox has no WebGL2, and then each
// must say so over its still. No page may leave an error. Driven by Marionette: JSON with its length before it.
'use strict';
const {spawn, execFileSync} = require('child_process'), fs = require('fs'), net = require('net'), os = require('os'), path = require('path'), url = require('url');
const book = path.resolve(process.argv[2]);
const pages = fs.readdirSync(book).filter(name => name.endsWith('.html') && fs.readFileSync(path.join(book, name), 'utf8').includes('data-figure='));
const is_here = name => { try { execFileSync('sh', ['-c', `command -v ${name}`]); return true; } catch { return false; } };
const name = ['firefox-esr', 'firefox'].find(is_here);
if (!name || !pages.length) { console.log('no Firefox here (apt-get install firefox-esr)'); process.exit(pages.length ? 77 : 1); }

const sleep = ms => new Promise(resolve => setTimeout(resolve, ms));
const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'live_firefox_'));
const started = [];

/// A display without a screen. @return what DISPLAY has to be; empty without Xvfb
async function display() {
    if (process.env.DISPLAY || !is_here('Xvfb')) return process.env.DISPLAY || '';
    const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1400x1200x24', '-nolisten', 'tcp'], {stdio: ['ignore', 'ignore', 'ignore', 'pipe']});
    started.push(server);
    return new Promise(resolve => { server.stdio[3].once('data', number => resolve(`:${String(number).trim()}`)); server.once('exit', () => resolve('')); });
}

/// @return {ask(command, parameters), run(code)}
async function open(screen) {
    const port = await new Promise(resolve => { const probe = net.createServer().listen(0, '127.0.0.1', () => { const {port} = probe.address(); probe.close(() => resolve(port)); }); });
    const wanted = {'marionette.port': port, 'webgl.force-enabled': true, 'browser.shell.checkDefaultBrowser': false,
        'datareporting.policy.dataSubmissionEnabled': false, 'app.update.enabled': false, 'app.normandy.enabled': false, 'network.captive-portal-service.enabled': false};
    fs.writeFileSync(path.join(profile, 'user.js'), Object.entries(wanted).map(([key, value]) => `user_pref(${JSON.stringify(key)}, ${JSON.stringify(value)});\n`).join(''));
    started.push(spawn(name, ['--marionette', '--no-remote', '--profile', profile, ...(screen ? [] : ['--headless'])],
        {stdio: 'ignore', env: {...process.env, HOME: profile, DISPLAY: screen, LIBGL_ALWAYS_SOFTWARE: '1'}}));
    let line = null;
    for (let n = 0; n < 300 && !line; ++n, await sleep(200))
        line = await new Promise(resolve => { const socket = net.connect(port, '127.0.0.1', () => resolve(socket)); socket.once('error', () => resolve(null)); });
    if (!line) throw new Error(`${name} did not start`);
    const waiting = new Map();
    let rest = Buffer.alloc(0), next = 0, greeted;
    const ready = new Promise(resolve => { greeted = resolve; });
    line.on('data', data => {
        rest = Buffer.concat([rest, data]);
        for (let colon; (colon = rest.indexOf(':')) >= 0;) {
            const end = colon + 1 + Number(rest.subarray(0, colon));
            if (rest.length < end) return;
            const message = JSON.parse(rest.subarray(colon + 1, end));
            rest = rest.subarray(end);
            if (!Array.isArray(message)) { greeted(); continue; }
            const [, id, problem, result] = message, [resolve, reject] = waiting.get(id);
            if (problem) reject(new Error(`${problem.error}: ${problem.message}`)); else resolve(result);
        }
    });
    const ask = (command, parameters = {}) => new Promise((resolve, reject) => {
        waiting.set(++next, [resolve, reject]);
        const words = JSON.stringify([0, next, command, parameters]);
        line.write(`${Buffer.byteLength(words)}:${words}`);
    });
    await ready;
    await ask('WebDriver:NewSession', {capabilities: {}});
    await ask('WebDriver:SetTimeouts', {script: 300000, pageLoad: 120000});
    const run = async code => {
        const {value} = await ask('WebDriver:ExecuteAsyncScript', {args: [], sandbox: null, script: `const done = arguments[arguments.length - 1], sleep = ms => new Promise(r => setTimeout(r, ms));
            (async () => { ${code} })().then(value => done({value}), problem => done({problem: String(problem)}));`});
        if (value.problem) throw new Error(value.problem);
        return value.value;
    };
    return {ask, run};
}

/// Inside the page.
async function examine(sleep) {
    const bad = [];
    addEventListener('error', event => bad.push(event.message));
    addEventListener('unhandledrejection', event => bad.push(String(event.reason)));
    document.querySelectorAll('main details').forEach(d => { d.open = true; });
    const moves = !!document.createElement('canvas').getContext('webgl2');
    for (const f of live_figures) {
        const need = (held, what) => { if (!held) bad.push(`${f.name}: ${what} ${f.note.textContent}`); };
        f.stage.scrollIntoView({block: 'center'});
        f.share = 0.3;
        await f.start();
        if (!moves) { need(!f.wasm && f.note.textContent.includes('WebGL2') && f.stage.querySelector('.shot').clientWidth > 50, 'no sentence over its still'); continue; }
        for (let n = 0; n < 100 && f.wasm && !(f.time > 0); ++n) await sleep(50);
        need(f.wasm && f.time > 0, 'it does not start');
        for (const state of f.wasm ? f.controls.states : []) { f.put(state); if (f.wasm) f.go(state.time); need(f.wasm, `state ${state.key}`); if (!f.wasm) break; }
        if (f.wasm) f.play(false);
    }
    return {bad, moves, figures: live_figures.length};
}

(async () => {
    const complaints = [];
    let figures = 0, moves = false;
    try {
        const {ask, run} = await open(await display());
        for (const page of pages) {
            await ask('WebDriver:Navigate', {url: url.pathToFileURL(path.join(book, page)).href});
            const found = await run(`return (${examine})(sleep)`);
            figures += found.figures, moves = found.moves;
            for (const what of found.bad) complaints.push(`${page}: ${what}`);
        }
    } catch (problem) { complaints.push(problem.stack); }
    complaints.forEach(what => console.log(what));
    console.log(`${name}${moves ? '' : ', without WebGL2 (install xvfb for a display)'}: ${figures} figures on ${pages.length} pages, ${complaints.length} complaints`);
    for (const process of started.reverse()) process.kill();
    await sleep(1000);
    try { fs.rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100}); } catch { }
    process.exit(complaints.length || !figures ? 1 : 0);
})();
