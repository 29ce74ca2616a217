// browser.cjs: headless Chromium by its debugging pipe (JSON messages that end in NUL), drawing by its own processor.
'use strict';
const {spawn, execFileSync} = require('child_process');
const fs = require('fs'), os = require('os'), path = require('path');

const name = ['chromium', 'chromium-browser', 'google-chrome'].find(candidate => {
    try { execFileSync('sh', ['-c', `command -v ${candidate}`]); return true; } catch { return false; }
});
if (!name) {
    console.log('no Chromium here (apt-get install chromium): the figures were not started');
    process.exit(process.env.CI === 'true' ? 1 : 77);
}

/// Opens a page of its own. @return {tell(method, parameters), media(scheme, motion), go(url), run(code), hear(listener), close(code)}
async function open() {
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'live_'));
    const chromium = spawn(name, ['--headless=new', '--no-first-run', '--disable-dev-shm-usage', '--disable-background-networking',
        '--hide-scrollbars', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--remote-debugging-pipe',
        `--user-data-dir=${profile}`, ...(process.getuid() === 0 ? ['--no-sandbox'] : []), 'about:blank'],
        {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    chromium.on('error', problem => { console.log(`cannot start ${name}: ${problem.message}`); process.exit(1); });
    const waiting = new Map(), listeners = [];
    let next = 0, rest = Buffer.alloc(0);
    chromium.stdio[4].on('data', data => {
        rest = Buffer.concat([rest, data]);
        for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) {
            const message = JSON.parse(rest.subarray(0, end));
            if (message.id) { waiting.get(message.id)(message); waiting.delete(message.id); }
            else for (const hear of [...listeners]) hear(message);
        }
    });
    const ask = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
        const id = ++next;
        waiting.set(id, m => m.error ? reject(new Error(`${method}: ${m.error.message}`)) : resolve(m.result));
        chromium.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
    });
    const {targetInfos} = await ask('Target.getTargets');
    const {sessionId} = await ask('Target.attachToTarget', {targetId: targetInfos.find(t => t.type === 'page').targetId, flatten: true});
    const tell = (method, params) => ask(method, params, sessionId);
    for (const domain of ['Page', 'Runtime', 'Log', 'Network']) await tell(`${domain}.enable`);
    return {
        tell,
        hear: listener => listeners.push(listener),
        media: (scheme, motion) => tell('Emulation.setEmulatedMedia', {media: '',
            features: [{name: 'prefers-color-scheme', value: scheme}, {name: 'prefers-reduced-motion', value: motion}]}),
        async go(url) {
            const loaded = new Promise(resolve => listeners.push(function hear(m) {
                if (m.method === 'Page.loadEventFired') { listeners.splice(listeners.indexOf(hear), 1); resolve(); }
            }));
            await tell('Page.navigate', {url});
            await loaded;
        },
        async run(code) {
            const {result, exceptionDetails} = await tell('Runtime.evaluate', {awaitPromise: true, returnByValue: true, expression:
                `(async () => { const sleep = ms => new Promise(r => setTimeout(r, ms)); ${code} })()`});
            if (exceptionDetails) throw new Error(exceptionDetails.exception?.description || exceptionDetails.text);
            return result.value;
        },
        close(code) {
            chromium.once('exit', () => {       // its helpers may still be writing for a moment
                try { fs.rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100}); } catch { }
                process.exit(code);
            });
            chromium.kill();
        },
    };
}
module.exports = {open};
