// Solids in WebGL 2: one context for all explorers of a page, whose pictures are copied into their own canvases. A page may thus have any number.

import { MESHES } from "./meshes.js";

const STRIDE = 20; // floats per instance: a 4 by 4 matrix, colour, gloss
const GROW = 128; // pixels
const VERTEX = `#version 300 es
layout(location=0) in vec3 position;
layout(location=1) in vec3 normal;
layout(location=2) in mat4 model;
layout(location=6) in vec4 tint;
uniform mat4 view;
uniform mat3 turn;
out vec3 side;
out vec4 colour;
void main() {
  gl_Position = view * model * vec4(position, 1.0);
  mat3 M = mat3(model);
  side = turn * (M * (normal / vec3(dot(M[0], M[0]), dot(M[1], M[1]), dot(M[2], M[2]))));
  colour = tint;
}`;
const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 side;
in vec4 colour;
out vec4 dot_of_light;
void main() {
  vec3 n = normalize(side);
  float sun = max(dot(n, normalize(vec3(-0.45, 0.75, 0.62))), 0.0);
  float shade = 0.76 + 0.30 * sun;
  float rim = smoothstep(0.45, 1.0, 1.0 - abs(n.z));
  vec3 c = colour.rgb * shade * (1.0 - 0.30 * rim) + colour.a * pow(sun, 18.0);
  dot_of_light = vec4(min(c, 1.0), 1.0);
}`;

export class Renderer {
  constructor(restored) {
    this.canvas = document.createElement("canvas");
    this.canvas.width = this.canvas.height = 1;
    this.gl = this.canvas.getContext("webgl2", { antialias: true, alpha: true, premultipliedAlpha: true });
    if (!this.gl) return;
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.prepare();
      restored();
    });
    this.prepare();
  }

  get works() {
    return Boolean(this.gl) && !this.gl.isContextLost();
  }

  prepare() {
    const { gl } = this;
    this.program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    this.view = gl.getUniformLocation(this.program, "view");
    this.turn = gl.getUniformLocation(this.program, "turn");
    this.own = new Map(); // meshes that somebody brought, as they are drawn
    this.meshes = Object.fromEntries(Object.entries(MESHES).map(([name, mesh]) => [name, this.upload(mesh)]));
  }

  upload({ corners, triangles = null }) { // without triangles, every three corners are one
    const { gl } = this, array = gl.createVertexArray(), instances = gl.createBuffer();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, corners instanceof Float32Array ? corners : new Float32Array(corners.flat()), gl.STATIC_DRAW);
    for (const k of [0, 1]) {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, 3, gl.FLOAT, false, 24, 12 * k);
    }
    if (triangles) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint16Array(triangles), gl.STATIC_DRAW);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, instances);
    for (let k = 0; k < 5; k++) {
      gl.enableVertexAttribArray(2 + k);
      gl.vertexAttribPointer(2 + k, 4, gl.FLOAT, false, 4 * STRIDE, 16 * k);
      gl.vertexAttribDivisor(2 + k, 1);
    }
    return { array, instances, indexed: Boolean(triangles), count: triangles ? triangles.length : corners.length / 6 };
  }

  // Draw layers of solids {mesh, matrix, color, gloss} over each other for a camera, and copy the whole onto a 2D canvas of this many device pixels.
  paint(layers, camera, context, width, height, opacity) {
    const { gl, canvas } = this;
    if (!layers.some((solids) => solids.length)) return;
    const part = covered(layers.flat(), camera, width, height);
    if (canvas.width < part.width || canvas.height < part.height) {
      canvas.width = Math.max(canvas.width, GROW * Math.ceil(part.width / GROW)); // seldom, since it takes new memory
      canvas.height = Math.max(canvas.height, GROW * Math.ceil(part.height / GROW));
    }
    gl.viewport(-part.left, canvas.height - height + part.top, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.uniformMatrix4fv(this.view, false, camera.matrix());
    gl.uniformMatrix3fv(this.turn, false, camera.rotation());
    for (const solids of layers) this.draw(solids);
    context.globalAlpha = opacity;
    context.drawImage(canvas, 0, 0, part.width, part.height, part.left, part.top, part.width, part.height);
    context.globalAlpha = 1;
  }

  draw(solids) {
    const { gl } = this;
    gl.clear(gl.DEPTH_BUFFER_BIT);
    const brought = [...new Set(solids.map((solid) => solid.mesh).filter((mesh) => typeof mesh === "object"))];
    for (const mesh of brought) if (!this.own.has(mesh)) this.own.set(mesh, this.upload(mesh));
    for (const [name, mesh] of [...Object.entries(this.meshes), ...brought.map((one) => [one, this.own.get(one)])]) {
      const own = solids.filter((solid) => solid.mesh === name);
      if (!own.length) continue;
      const numbers = new Float32Array(own.length * STRIDE);
      own.forEach((solid, i) => numbers.set([...solid.matrix, ...solid.color, solid.gloss], i * STRIDE));
      gl.bindVertexArray(mesh.array);
      gl.bindBuffer(gl.ARRAY_BUFFER, mesh.instances);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      if (!mesh.indexed) gl.drawArraysInstanced(gl.TRIANGLES, 0, mesh.count, own.length);
      else gl.drawElementsInstanced(gl.TRIANGLES, mesh.count, gl.UNSIGNED_SHORT, 0, own.length);
    }
  }
}

// The part of a picture that solids cover, device pixels: what lies round it is neither drawn nor copied.
function covered(solids, camera, width, height) {
  const dots = width / camera.width, box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const { mesh, matrix: m } of solids) {
    const round = typeof mesh === "object" ? camera.scale * mesh.radius : camera.scale * Math.max(Math.hypot(m[0], m[1], m[2]), Math.hypot(m[4], m[5], m[6])) + 2;
    for (const end of typeof mesh === "object" ? [0] : mesh === "cylinder" || mesh === "cone" ? [0, 1] : [-1, 1]) {
      const [x, y] = camera.flat([m[12] + end * m[8], m[13] + end * m[9], m[14] + end * m[10]]);
      box.splice(0, 4, Math.min(box[0], x - round), Math.min(box[1], y - round), Math.max(box[2], x + round), Math.max(box[3], y + round));
    }
  }
  const [left, top, right, bottom] = box.map((v, k) => Math.max(0, Math.min(k % 2 ? height : width, Math.round(v * dots))));
  return { left, top, width: right - left || 1, height: bottom - top || 1 };
}
