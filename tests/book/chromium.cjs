// The browser of the book's tests: headless Chromium, driven through its debugging pipe. Without Chromium the test is skipped
// (exit code 77), unless CI=true: there it must be present.
//   const {pages_of, run} = require('./chromium.cjs');
//   run(async ({tell, heard, event}) => exit_code, minutes)
'use strict';
const {spawn, execFileSync} = require('child_process');
const fs = require('fs'), os = require('os'), path = require('path');

/// All HTML files in a folder and below.
exports.pages_of = function pages_of(folder) {
    const pages = [];
    for (const entry of fs.readdirSync(folder, {withFileTypes: true})) {
        const full = path.join(folder, entry.name);
        if (entry.isDirectory()) pages.push(...pages_of(full));
        else if (entry.name.endsWith('.html')) pages.push(full);
    }
    return pages;
};

/// Opens a browser with one page, gives its verbs to `work`, and ends the process with the code that it returns.
exports.run = function run(work, minutes) {
    const browser = ['chromium', 'chromium-browser', 'google-chrome'].find(name => {
        try { execFileSync('sh', ['-c', `command -v ${name}`]); return true; } catch { return false; }
    });
    if (!browser) {
        console.log('no Chromium here (apt-get install chromium): the pages were not opened');
        process.exit(process.env.CI === 'true' ? 1 : 77);
    }
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'browse_'));
    const chromium = spawn(browser, ['--headless=new', '--disable-gpu', '--no-first-run', '--disable-dev-shm-usage',
        '--disable-background-networking', '--hide-scrollbars',
        '--remote-debugging-pipe', `--user-data-dir=${profile}`, ...(process.getuid() === 0 ? ['--no-sandbox'] : []), 'about:blank'],
        {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
    const waiting = new Map(), heard = [];
    let next = 0, rest = Buffer.alloc(0);
    chromium.stdio[4].on('data', data => {
        rest = Buffer.concat([rest, data]);
        for (let end; (end = rest.indexOf(0)) >= 0; rest = rest.subarray(end + 1)) {
            const message = JSON.parse(rest.subarray(0, end));
            if (message.id) { waiting.get(message.id)(message); waiting.delete(message.id); }
            else for (const hear of [...heard]) hear(message);
        }
    });
    const ask = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
        const id = ++next;
        waiting.set(id, m => m.error ? reject(new Error(`${method}: ${m.error.message}`)) : resolve(m.result));
        chromium.stdio[3].write(JSON.stringify({id, method, params, sessionId}) + '\0');
    });
    const event = name => new Promise(resolve => heard.push(function hear(m) {
        if (m.method === name) { heard.splice(heard.indexOf(hear), 1); resolve(m.params); }
    }));

    const clean_up = code => {
        chromium.once('exit', () => {       // its helpers may still be writing for a moment; what stays in /tmp is no complaint
            try { fs.rmSync(profile, {recursive: true, force: true, maxRetries: 20, retryDelay: 100}); } catch { }
            process.exit(code);
        });
        chromium.kill();
    };
    const limit = setTimeout(() => { console.log(`the browser did not answer in ${minutes} minutes`); clean_up(1); }, minutes * 60000);
    chromium.on('error', e => { console.log(`cannot start ${browser}: ${e.message}`); process.exit(1); });
    (async () => {
        const {targetInfos} = await ask('Target.getTargets');
        const target = targetInfos.find(t => t.type === 'page').targetId;
        const {sessionId} = await ask('Target.attachToTarget', {targetId: target, flatten: true});
        return work({tell: (method, params) => ask(method, params, sessionId), heard, event});
    })().then(code => { clearTimeout(limit); clean_up(code); }, e => { console.log(e.stack); clean_up(1); });
};
