"use strict";
// The replay: decodes the recorded poses and draws them. No library, no network.
const $ = id => document.getElementById(id);
const scenes = JSON.parse($("data").textContent);
const canvas = $("view");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
const dark = matchMedia("(prefers-color-scheme: dark)");

// ---- recorded poses: 16-bit integers, frame after frame, body after body: position, rotation ----------------
function decode(scene) {
  const text = atob(scene.data), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
  const view = new DataView(bytes.buffer), n = scene.bodies.length, out = new Float32Array(scene.frames * n * 7);
  for (let i = 0; i < out.length; i++) {
    const k = i % 7;
    out[i] = k < 3 ? scene.low[k] + scene.step[k] * view.getUint16(2 * i, true) : view.getInt16(2 * i, true) / 32767;
  }
  return out;
}

// ---- small matrices, by columns ------------------------------------------------------------------------------
const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => { const l = Math.hypot(...a); return [a[0] / l, a[1] / l, a[2] / l]; };
function multiply(a, b) {
  const r = new Float32Array(16);
  for (let c = 0; c < 4; c++) for (let i = 0; i < 4; i++)
    for (let k = 0; k < 4; k++) r[4 * c + i] += a[4 * k + i] * b[4 * c + k];
  return r;
}
function lookAt(eye, target, up) {
  const z = unit(sub(eye, target)), x = unit(cross(up, z)), y = cross(z, x);
  return new Float32Array([x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1]);
}
function perspective(angle, aspect, near, far) {
  const f = 1 / Math.tan(angle / 2), d = 1 / (near - far);
  return new Float32Array([f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (near + far) * d, -1, 0, 0, 2 * near * far * d, 0]);
}
function orthographic(r, near, far) {
  const d = 1 / (near - far);
  return new Float32Array([1 / r, 0, 0, 0, 0, 1 / r, 0, 0, 0, 0, 2 * d, 0, 0, 0, (near + far) * d, 1]);
}

// ---- meshes: vertex = position = normal's source --------------------------------------------------------------
function cube() {
  const v = [];
  for (let axis = 0; axis < 3; axis++) for (const s of [1, -1]) {
    const n = [0, 0, 0]; n[axis] = s;
    const corner = (a, b) => { const p = [...n]; p[(axis + 1) % 3] = a; p[(axis + 2) % 3] = b; return p; };
    const q = [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)];
    for (const i of s > 0 ? [0, 1, 2, 0, 2, 3] : [0, 2, 1, 0, 3, 2]) v.push(...q[i], ...n);
  }
  return new Float32Array(v);
}
function ball(rings) {
  const v = [], at = (i, j) => {
    const a = Math.PI * i / rings, b = Math.PI * j / rings;
    return [Math.sin(a) * Math.cos(b), Math.cos(a), Math.sin(a) * Math.sin(b)];
  };
  for (let i = 0; i < rings; i++) for (let j = 0; j < 2 * rings; j++) {
    const q = [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
    for (const k of [0, 1, 2, 0, 2, 3]) v.push(...q[k], ...q[k]);
  }
  return new Float32Array(v);
}

// ---- shaders ----------------------------------------------------------------------------------------------------
const common = `#version 300 es
precision highp float; precision highp sampler2DShadow;`;
const bodyVertex = common + `
layout(location=0) in vec3 corner; layout(location=1) in vec3 normal;
layout(location=2) in vec3 place; layout(location=3) in vec4 turn; layout(location=4) in vec4 size; layout(location=5) in vec3 paint;
uniform mat4 camera, light;
out vec3 world, local, n; out vec4 shade; flat out vec4 form; flat out vec3 color;
vec3 rotate(vec4 q, vec3 v) { return v + 2. * cross(q.xyz, cross(q.xyz, v) + q.w * v); }
void main() {
  local = corner * size.xyz; world = place + rotate(turn, local); n = rotate(turn, normal);
  form = size; color = paint; shade = light * vec4(world + .03 * n, 1); gl_Position = camera * vec4(world, 1);
}`;
const lighting = `
uniform vec3 eye, sun, fog, sky, earth; uniform float reach; uniform sampler2DShadow shadow;
float lit(vec4 shade, float slope) {
  vec3 p = shade.xyz * .5 + .5; if (any(lessThan(p, vec3(0))) || any(greaterThan(p, vec3(1)))) return 1.;
  float s = 0., bias = .0006 + .0016 * slope; vec2 t = 1. / vec2(textureSize(shadow, 0));
  for (int i = -2; i <= 2; i++) for (int j = -2; j <= 2; j++) s += texture(shadow, vec3(p.xy + t * 1.1 * vec2(i, j), p.z - bias));
  return s / 25.;
}
vec3 tone(vec3 c) { c = c * (1. + c * .12) / (1. + c * .55); return pow(c, vec3(1. / 2.2)); }`;
const bodyFragment = common + lighting + `
in vec3 world, local, n; in vec4 shade; flat in vec4 form; flat in vec3 color; out vec4 result;
void main() {
  vec3 m = normalize(n), v = normalize(eye - world), base = color;
  if (form.w < .5) {
    vec3 d = form.xyz - abs(local); float e = max(min(d.x, d.y), min(max(d.x, d.y), d.z));
    float w = max(fwidth(e), 1e-4), edge = .018 * min(min(form.x, form.y), min(form.z, .6)) * 2.;
    base *= mix(.55, 1., smoothstep(edge - w, edge + w, e));
  } else {
    vec3 q = local / form.x; float s = q.x * q.y * q.z, w = max(fwidth(s), 1e-4);
    base = mix(base, base * .25 + .62, smoothstep(-w, w, s) * .85);
  }
  float slope = clamp(dot(m, sun), 0., 1.), s = lit(shade, 1. - slope) * slope;
  vec3 ambient = mix(earth, sky, .5 + .5 * m.y);
  vec3 h = normalize(v + sun); float gloss = pow(max(dot(m, h), 0.), 40.) * .22 * s + pow(1. - max(dot(m, v), 0.), 4.) * .10;
  vec3 c = base * (ambient + vec3(1.75, 1.62, 1.42) * s) + gloss;
  result = vec4(mix(tone(c), fog, smoothstep(.6 * reach, reach, distance(eye, world))), 1);
}`;
const groundVertex = common + `
uniform mat4 camera, light; uniform vec3 center; uniform float reach; uniform float level; out vec3 world; out vec4 shade;
void main() {
  vec2 c = vec2(gl_VertexID >> 1, gl_VertexID & 1) * 2. - 1.;
  world = vec3(center.x + c.x * 2. * reach, level, center.z + c.y * 2. * reach); shade = light * vec4(world, 1); gl_Position = camera * vec4(world, 1);
}`;
const groundFragment = common + lighting + `
in vec3 world; in vec4 shade; uniform vec3 floorColor; uniform float ink; out vec4 result;
float grid(float pitch, float width) {
  vec2 p = world.xz / pitch, w = fwidth(p), d = abs(fract(p - .5) - .5); vec2 l = 1. - smoothstep(width / pitch - w * .5, width / pitch + w, d);
  return max(l.x, l.y) * clamp(.6 - max(w.x, w.y), 0., .6) / .6;
}
void main() {
  float s = lit(shade, .3) * sun.y; float line = max(.45 * grid(1., .012), grid(5., .022));
  vec3 c = mix(floorColor, vec3(ink), .22 * line) * (mix(earth, sky, .9) + vec3(1.75, 1.66, 1.50) * s);
  result = vec4(mix(tone(c), fog, smoothstep(.12 * reach, .8 * reach, distance(eye, world))), 1);
}`;
const depthFragment = common + "void main() {}";

function program(vertex, fragment) {
  const p = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const s = gl.createShader(type); gl.shaderSource(s, source); gl.compileShader(s);
    if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
    gl.attachShader(p, s);
  }
  gl.linkProgram(p);
  if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(p));
  const at = {};
  for (let i = 0; i < gl.getProgramParameter(p, gl.ACTIVE_UNIFORMS); i++) {
    const name = gl.getActiveUniform(p, i).name; at[name] = gl.getUniformLocation(p, name);
  }
  return { p, at };
}

// ---- state ------------------------------------------------------------------------------------------------------
let scene, poses, frame = 0, clock = 0, playing = true, speed = 1, last = 0, dirty = true;
const view = { yaw: 0, pitch: 0, distance: 10, target: [0, 0, 0] };
let programs, meshes, depth;
const SHADOW = 2048, FLOATS = 14;

function start() {
  programs = { body: program(bodyVertex, bodyFragment), depth: program(bodyVertex, depthFragment), ground: program(groundVertex, groundFragment) };
  const mesh = vertices => {
    const array = gl.createVertexArray(), instances = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer()); gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    for (const k of [0, 1]) { gl.enableVertexAttribArray(k); gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 24, 12 * k); }
    gl.bindBuffer(gl.ARRAY_BUFFER, instances);
    let offset = 0;
    [3, 4, 4, 3].forEach((n, i) => {
      gl.enableVertexAttribArray(2 + i); gl.vertexAttribPointer(2 + i, n, gl.FLOAT, false, 4 * FLOATS, offset); gl.vertexAttribDivisor(2 + i, 1);
      offset += 4 * n;
    });
    return { array, instances, vertices: vertices.length / 6, count: 0 };
  };
  meshes = { box: mesh(cube()), sphere: mesh(ball(28)) };
  const map = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, map);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.DEPTH_COMPONENT24, SHADOW, SHADOW);
  for (const [k, v] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
    [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE], [gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE], [gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL]])
    gl.texParameteri(gl.TEXTURE_2D, k, v);
  depth = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, depth);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, map, 0);
  gl.drawBuffers([gl.NONE]); gl.readBuffer(gl.NONE);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.enable(gl.DEPTH_TEST);
}

function choose(name) {
  scene = scenes.find(s => s.name === name) || scenes[0];
  scene.poses = scene.poses || decode(scene);
  poses = scene.poses; frame = 0; clock = 0; dirty = true;
  Object.assign(view, { yaw: scene.camera.yaw, pitch: scene.camera.pitch, distance: scene.camera.distance, target: [...scene.camera.target] });
  $("about").textContent = scene.about; $("scrub").max = scene.frames - 1;
  for (const b of $("scenes").children) b.setAttribute("aria-pressed", b.dataset.name === scene.name);
}

function fill() {
  const lists = { box: [], sphere: [] }, n = scene.bodies.length;
  for (const b of scene.fixed) lists.box.push(...b.at, 0, 0, 0, 1, ...b.half, 0, ...b.color);
  for (let i = 0; i < n; i++) {
    const b = scene.bodies[i], p = poses.subarray((frame * n + i) * 7, (frame * n + i) * 7 + 7);
    const l = Math.hypot(p[3], p[4], p[5], p[6]);
    if (l < .5) continue; // not there yet
    const round = b.radius !== undefined, size = round ? [b.radius, b.radius, b.radius, 1] : [...b.half, 0];
    lists[round ? "sphere" : "box"].push(p[0], p[1], p[2], p[3] / l, p[4] / l, p[5] / l, p[6] / l, ...size, ...b.color);
  }
  for (const kind of ["box", "sphere"]) {
    meshes[kind].count = lists[kind].length / FLOATS;
    gl.bindBuffer(gl.ARRAY_BUFFER, meshes[kind].instances);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(lists[kind]), gl.DYNAMIC_DRAW);
  }
}

function bodies() {
  for (const m of Object.values(meshes)) if (m.count) {
    gl.bindVertexArray(m.array); gl.drawArraysInstanced(gl.TRIANGLES, 0, m.vertices, m.count);
  }
}

function draw() {
  fill();
  const scale = Math.min(devicePixelRatio || 1, 2), w = Math.round(canvas.clientWidth * scale), h = Math.round(canvas.clientHeight * scale);
  if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
  const look = dark.matches
    ? { fog: [.082, .102, .13], sky: [.22, .28, .40], earth: [.10, .09, .09], floor: [.055, .066, .086], ink: .75 }
    : { fog: [.875, .905, .935], sky: [.40, .49, .64], earth: [.25, .23, .22], floor: [.66, .69, .73], ink: .08 };
  const c = Math.cos(view.pitch), t = view.target, aspect = w / h;
  // On a narrow screen step back so that the scene still fits.
  const far = view.distance * Math.max(1, 1.15 / aspect);
  const eye = [t[0] + far * c * Math.sin(view.yaw), t[1] + far * Math.sin(view.pitch), t[2] + far * c * Math.cos(view.yaw)];
  const reach = Math.max(90, 6 * far), sun = unit([.60, .64, .46]), r = scene.radius, o = scene.camera.target;
  const camera = multiply(perspective(.62, aspect, far / 60, 4 * reach), lookAt(eye, t, [0, 1, 0]));
  const light = multiply(orthographic(r, 1, 4 * r), lookAt([o[0] + 2 * r * sun[0], o[1] + 2 * r * sun[1], o[2] + 2 * r * sun[2]], o, [0, 1, 0]));

  gl.bindFramebuffer(gl.FRAMEBUFFER, depth); gl.viewport(0, 0, SHADOW, SHADOW); gl.clear(gl.DEPTH_BUFFER_BIT);
  gl.useProgram(programs.depth.p); gl.uniformMatrix4fv(programs.depth.at.camera, false, light);
  bodies();

  gl.bindFramebuffer(gl.FRAMEBUFFER, null); gl.viewport(0, 0, w, h);
  gl.clearColor(...look.fog, 1); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  for (const { p, at } of [programs.body, programs.ground]) {
    gl.useProgram(p);
    gl.uniformMatrix4fv(at.camera, false, camera); gl.uniformMatrix4fv(at.light, false, light);
    gl.uniform3fv(at.eye, eye); gl.uniform3fv(at.sun, sun); gl.uniform3fv(at.fog, look.fog);
    gl.uniform3fv(at.sky, look.sky); gl.uniform3fv(at.earth, look.earth); gl.uniform1f(at.reach, reach);
    gl.uniform1i(at.shadow, 0);
    if (at.level) {
      gl.uniform1f(at.level, scene.ground); gl.uniform3fv(at.center, t); gl.uniform3fv(at.floorColor, look.floor); gl.uniform1f(at.ink, look.ink);
      gl.bindVertexArray(null); gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    } else bodies();
  }
}

function show() {
  $("scrub").value = frame;
  $("clock").innerHTML = `<b>${(frame * scene.dt).toFixed(2)} s</b><span class="frame"> · frame ${frame}</span>`;
  $("icon").setAttribute("d", playing ? "M7 5h4v14H7zM13 5h4v14h-4z" : "M7 4.5v15l12-7.5z");
}
function seek(f, keep) {
  frame = Math.max(0, Math.min(scene.frames - 1, Math.round(f))); clock = frame * scene.dt; dirty = true;
  if (!keep) playing = false;
}
function toggle() {
  playing = !playing; dirty = true;
  if (playing && frame >= scene.frames - 1) seek(0, true);
}
function tick(now) {
  const dt = Math.min(.1, (now - last) / 1000); last = now;
  if (playing) {
    clock += dt * speed;
    const f = Math.min(scene.frames - 1, Math.floor(clock / scene.dt + 1e-6));
    if (f !== frame) { frame = f; dirty = true; }
    if (frame >= scene.frames - 1) { playing = false; dirty = true; }
  }
  if (dirty) { dirty = false; draw(); show(); }
  requestAnimationFrame(tick);
}

// ---- controls -----------------------------------------------------------------------------------------------------
const fingers = new Map();
canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, [e.clientX, e.clientY]); $("hint").hidden = true; });
for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, e => fingers.delete(e.pointerId));
canvas.addEventListener("contextmenu", e => e.preventDefault());
const spread = () => { const [a, b] = [...fingers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
function pan(dx, dy) {
  const k = view.distance * .62 / canvas.clientHeight, s = Math.sin(view.yaw), c = Math.cos(view.yaw), p = Math.sin(view.pitch);
  view.target[0] += k * (-dx * c - dy * p * s); view.target[2] += k * (dx * s - dy * p * c); view.target[1] += k * dy * Math.cos(view.pitch);
}
canvas.addEventListener("pointermove", e => {
  const old = fingers.get(e.pointerId);
  if (!old) return;
  const dx = e.clientX - old[0], dy = e.clientY - old[1], before = fingers.size === 2 ? spread() : 0;
  fingers.set(e.pointerId, [e.clientX, e.clientY]);
  if (fingers.size === 2) { zoom(before / Math.max(1, spread())); pan(dx / 2, dy / 2); }
  else if (e.buttons & 2 || e.shiftKey) pan(dx, dy);
  else { view.yaw -= dx * .006; view.pitch = Math.max(-.05, Math.min(1.54, view.pitch + dy * .006)); }
  dirty = true;
});
function zoom(k) { view.distance = Math.max(1.5, Math.min(400, view.distance * k)); dirty = true; }
canvas.addEventListener("wheel", e => { e.preventDefault(); zoom(Math.exp(e.deltaY * (e.deltaMode ? .04 : .0012))); }, { passive: false });
canvas.addEventListener("dblclick", () => { const f = frame; choose(scene.name); seek(f, true); });
$("play").onclick = toggle; $("back").onclick = () => seek(frame - 1); $("forward").onclick = () => seek(frame + 1);
$("scrub").oninput = e => seek(+e.target.value);
$("speed").onclick = () => { speed = { 1: .25, .25: .1, .1: 1 }[speed]; $("speed").textContent = { 1: "1×", .25: "¼×", .1: "⅒×" }[speed]; };
addEventListener("keydown", e => {
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const far = e.shiftKey ? 10 : 1;
  const action = { " ": toggle, ArrowLeft: () => seek(frame - far), ArrowRight: () => seek(frame + far), Home: () => seek(0), End: () => seek(scene.frames - 1) }[e.key];
  if (action) { e.preventDefault(); action(); }
});
addEventListener("resize", () => { dirty = true; });
dark.addEventListener("change", () => { dirty = true; });
canvas.addEventListener("webglcontextlost", e => e.preventDefault());
canvas.addEventListener("webglcontextrestored", () => { start(); dirty = true; });

// ---- #scene=pyramid&frame=120&paused&yaw=0.5&pitch=0.3&distance=20&bare --------------------------------------------
function fromHash() {
  const h = new URLSearchParams(location.hash.slice(1));
  choose(h.get("scene"));
  if (h.has("frame")) seek(+h.get("frame"), true);
  playing = !h.has("paused");
  for (const k of ["yaw", "pitch", "distance"]) if (h.has(k)) view[k] = +h.get(k);
  document.body.classList.toggle("bare", h.has("bare"));
}
for (const s of scenes) {
  const b = document.createElement("button");
  b.textContent = s.title; b.dataset.name = s.name; b.onclick = () => { choose(s.name); playing = true; };
  $("scenes").append(b);
}
if (!gl) {
  $("problem").hidden = false; $("problem").textContent = "This page draws with WebGL 2, which this browser does not offer.";
} else {
  start(); fromHash(); addEventListener("hashchange", fromHash);
  requestAnimationFrame(now => { last = now; tick(now); });
}
