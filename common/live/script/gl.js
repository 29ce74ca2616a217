// gl.js: OpenGL for the module: its calls handed to WebGL2. book/build.sh makes live.js of gl.js, parts.js, figure.js and
// page.js, in this order and in one function.
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
