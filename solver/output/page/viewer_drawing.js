'use strict';
// Draws a surface with WebGL 2. The places, values and normals of the corners of all faces lie in a buffer that another time
// fills anew, the faces that are there in a list; light and colours are those of python/view/render.py.
// No library is behind this: of one only matrices and the making of shaders would be used, and each page would hold 700 kB.

const vertexShader = `#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in float share;  // of the range of colours; below 0: no value
layout(location = 2) in vec3 outward;
layout(location = 3) in vec4 colourOfBody;  // and whether the face is a triangle
layout(location = 4) in uint element;
uniform mat3 view;  // from x, y, z to right, up, toward the viewer
uniform vec3 centre, size;
uniform uint chosen;
out vec3 place, normal;
out vec2 along;
out float value;
flat out vec3 bodyColour;
flat out float isChosen, isTriangle;

void main() {
  int corner = gl_VertexID & 3;
  along = vec2(corner == 1 || corner == 2, corner > 1);
  place = position;
  normal = view * outward;
  value = share;
  bodyColour = colourOfBody.rgb;
  isTriangle = colourOfBody.a;
  isChosen = element == chosen ? 1.0 : 0.0;
  gl_Position = vec4((view * (position - centre)) * size, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec3 place, normal;
in vec2 along;
in float value;
flat in vec3 bodyColour;
flat in float isChosen, isTriangle;
uniform sampler2D colours;
uniform vec4 cut;  // kept is what has (place, -1) . cut >= 0
uniform bool byBody, lit, isCut;
uniform float edges;
uniform vec3 accent;
out vec4 colour;

// Pixels to the nearest edge of the element, and how many it is wide.
vec2 toEdge() {
  vec2 change = max(fwidth(along), vec2(1e-9));
  vec2 near = min(along, 1.0 - along) / change;
  float across = along.x - along.y, diagonal = isTriangle > 0.5 ? abs(across) / max(fwidth(across), 1e-9) : 1e9;
  return vec2(min(min(near.x, near.y), diagonal), 1.0 / max(change.x, change.y));
}

void main() {
  vec2 edge = toEdge();
  if (isCut && dot(place, cut.xyz) < cut.w) discard;
  vec3 n = normalize(normal);
  if (isCut && !gl_FrontFacing) {  // seen from inside: there the plane goes through the body
    float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / 9.0) - 0.5);
    vec3 section = mix(bodyColour, vec3(0.55), 0.35);
    colour = vec4(mix(section * 0.72, section, smoothstep(0.06, 0.16, stripe)), 1.0);
    return;
  }
  if (n.z < 0.0) n = -n;
  vec3 base = byBody ? bodyColour : value < 0.0 ? vec3(0.6)
      : texelFetch(colours, ivec2(min(int(value * 256.0), 255), 0), 0).rgb;
  float light = 0.85 * max(0.0, dot(n, normalize(vec3(-0.35, 0.6, 1.0)))) + 0.25 * max(0.0, dot(n, normalize(vec3(0.7, -0.2, 0.8))));
  base *= lit ? 0.36 + 0.62 * light : 1.0;
  float line = 1.0 - smoothstep(0.3, 1.1 * max(edges, 0.5), edge.x);
  base = mix(base, vec3(0.22, 0.22, 0.25), 0.55 * line * smoothstep(4.0, 14.0, edge.y) * step(0.01, edges));
  if (isChosen > 0.5) base = mix(base, accent, edge.x < 3.0 ? 1.0 : 0.25);
  colour = vec4(base, 1.0);
}`;

function shaderProgram(gl) {
  const program = gl.createProgram();
  for (const [kind, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (gl.getProgramParameter(program, gl.LINK_STATUS)) return program;
  throw new Error(gl.getAttachedShaders(program).map((shader) => gl.getShaderInfoLog(shader)).join(' ') || gl.getProgramInfoLog(program));
}

/// For each node the faces that it is a corner of: those of node i are faces[begin[i]] to faces[begin[i + 1] - 1].
function facesOfNodes({faces, nodes}) {
  const begin = new Uint32Array(nodes.count + 2), list = new Uint32Array(4 * faces.count);
  for (const node of faces.corners) ++begin[node + 2];
  for (let i = 2; i < begin.length; ++i) begin[i] += begin[i - 1];
  faces.corners.forEach((node, c) => { list[begin[node + 1]++] = c >> 2; });
  return {begin, faces: list};
}

const twoTriangles = [0, 1, 2, 0, 2, 3];
const floatsOfCorner = 7;  // place, share, normal
const cosineOfEdge = Math.cos(30 * Math.PI / 180);  // sharper ones are seen as edges

class SurfaceDrawing {
  /// Throws where this computer cannot draw it. colourOf(body): [r, g, b], 0 to 255.
  constructor(canvas, surface, centre, colourOf) {
    const gl = canvas.getContext('webgl2', {antialias: true, alpha: true, preserveDrawingBuffer: true});
    if (!gl) throw new Error('no WebGL 2');
    Object.assign(this, {canvas, gl, surface, centre, ofNode: facesOfNodes(surface), isShown: () => true, program: shaderProgram(gl)});
    gl.useProgram(this.program);
    this.uniform = new Proxy({}, {get: (known, name) => known[name] ??= gl.getUniformLocation(this.program, name)});
    const {faces: {count, element}, elements: {body}} = surface;
    this.numbers = new Float32Array(4 * count * floatsOfCorner);
    this.faceNormals = new Float32Array(3 * count);
    gl.bindVertexArray(gl.createVertexArray());
    this.corners = this.attributes(this.numbers.byteLength, [[0, 3], [1, 1], [2, 3]], 4 * floatsOfCorner);
    const colours = Array.from({length: count}, (_, f) => [...colourOf(body[element[f]]), new Set(surface.faces.corners.subarray(4 * f, 4 * f + 4)).size < 4 ? 255 : 0]);
    this.attributes(Uint8Array.from({length: 16 * count}, (_, i) => colours[i >> 4][i % 4]), [[3, 4, gl.UNSIGNED_BYTE]], 4);
    this.attributes(Uint32Array.from({length: 4 * count}, (_, i) => element[i >> 2]), [[4, 1, gl.UNSIGNED_INT]], 4);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    this.colours = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
  }

  /// A buffer with attributes [location, components, type] one behind the other, records of `stride` bytes.
  attributes(content, list, stride) {
    const {gl} = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, content, typeof content === 'number' ? gl.DYNAMIC_DRAW : gl.STATIC_DRAW);
    let offset = 0;
    for (const [location, components, type = gl.FLOAT] of list) {
      gl.enableVertexAttribArray(location);
      if (type === gl.UNSIGNED_INT) gl.vertexAttribIPointer(location, components, type, stride, offset);
      else gl.vertexAttribPointer(location, components, type, type === gl.UNSIGNED_BYTE, stride, offset);
      offset += 4 * components;
    }
    return buffer;
  }

  showColours(table) {
    const {gl} = this;
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, 256, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.from(table.flatMap((colour) => [...colour, 255])));
  }

  showBodies(isShown) {
    this.isShown = isShown;
    this.sendFaces();
  }

  /// The list of the faces that are there and shown, two triangles each.
  sendFaces() {
    const {gl, surface: {faces, elements}} = this, list = new Uint32Array(6 * faces.count);
    this.count = 0;
    for (let f = 0; f < faces.count; ++f) {
      if (!faceIsThere(faces, f, this.frame) || !this.isShown(elements.body[faces.element[f]])) continue;
      for (let i = 0; i < 6; ++i) list[this.count++] = 4 * f + twoTriangles[i];
    }
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, list.subarray(0, this.count), gl.DYNAMIC_DRAW);
  }

  /// The places at the time of a frame, and the values of a field (-1: bodies by their colours).
  showFrame(frame, field) {
    const {gl, surface, numbers} = this, {faces} = surface, {of} = surface.fields[field] ?? {of: ''};
    this.byBody = of === '';
    if (frame !== this.frame) {
      this.frame = frame;
      this.placeCorners();
      this.turnNormals();
      this.sendFaces();
    }
    const {low = 0, step = 1, range = [0, 1]} = surface.fields[field] ?? {}, codes = surface.frames[frame].fields[field];
    const begin = (low - range[0]) / (range[1] - range[0]), each = step / (range[1] - range[0]);
    for (let f = 0; f < faces.count && codes; ++f) {
      let none = false;
      for (let c = 4 * f; c < 4 * f + 4; ++c) {
        const code = codes[of === 'nodes' ? faces.corners[c] : faces.element[f]];
        none ||= code === noValue;
        numbers[floatsOfCorner * c + 3] = begin + each * code;
      }
      if (none) for (let c = 4 * f; c < 4 * f + 4; ++c) numbers[floatsOfCorner * c + 3] = -1;
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.corners);
    gl.bufferSubData(gl.ARRAY_BUFFER, 0, numbers);
  }

  placeCorners() {
    const {surface: {faces, nodes, frames, steps}, centre, numbers} = this, {origins, positions} = frames[this.frame];
    const places = new Float32Array(3 * nodes.count);
    for (let i = 0; i < nodes.count; ++i) {
      const body = nodes.body[i];
      for (let k = 0; k < 3; ++k) places[3 * i + k] = (origins[3 * body + k] + positions[k][i]) * steps[body][k] - centre[k];
    }
    for (let c = 0; c < 4 * faces.count; ++c) {
      for (let k = 0; k < 3; ++k) numbers[floatsOfCorner * c + k] = places[3 * faces.corners[c] + k];
    }
  }

  /// Of each corner the mean of the faces that meet there without a sharp edge: curved bodies look curved.
  turnNormals() {
    const {surface: {faces, elements}, numbers, faceNormals: n, ofNode} = this, stride = floatsOfCorner, isThere = new Uint8Array(faces.count);
    for (let f = 0; f < faces.count; ++f) {
      isThere[f] = faceIsThere(faces, f, this.frame);
      if (!isThere[f]) continue;
      const p = 4 * f * stride, q = p + stride, r = q + stride, s = r + stride;
      const ax = numbers[r] - numbers[p], ay = numbers[r + 1] - numbers[p + 1], az = numbers[r + 2] - numbers[p + 2];
      const bx = numbers[s] - numbers[q], by = numbers[s + 1] - numbers[q + 1], bz = numbers[s + 2] - numbers[q + 2];
      const x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx, size = Math.sqrt(x * x + y * y + z * z) || 1;
      n[3 * f] = x / size;
      n[3 * f + 1] = y / size;
      n[3 * f + 2] = z / size;
    }
    for (let c = 0; c < 4 * faces.count; ++c) {
      const f = 3 * (c >> 2), node = faces.corners[c];
      if (!isThere[c >> 2]) continue;
      let x = 0, y = 0, z = 0;
      for (let i = ofNode.begin[node]; i < ofNode.begin[node + 1]; ++i) {
        const other = ofNode.faces[i], g = 3 * other;
        if (!isThere[other] || n[f] * n[g] + n[f + 1] * n[g + 1] + n[f + 2] * n[g + 2] < cosineOfEdge) continue;
        if (elements.body[faces.element[other]] !== elements.body[faces.element[c >> 2]]) continue;
        x += n[g];
        y += n[g + 1];
        z += n[g + 2];
      }
      numbers[stride * c + 4] = x;
      numbers[stride * c + 5] = y;
      numbers[stride * c + 6] = z;
    }
  }

  /// cut: {normal, at} keeps what has place . normal >= at, or null; edges: width of lines between elements [pixel]; depth:
  /// how far from the camera's centre anything is [length]; chosen: an element, or -1.
  draw(camera, {cut, edges, depth, chosen, accent, lit = true}) {
    const {gl, canvas, uniform, centre} = this, aspect = canvas.width / canvas.height;
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix3fv(uniform.view, true, camera.axes.flat());
    gl.uniform3fv(uniform.centre, camera.centre.map((c, i) => c - centre[i]));
    gl.uniform3f(uniform.size, 2 / (camera.height * aspect), 2 / camera.height, -1 / depth);
    gl.uniform1ui(uniform.chosen, chosen < 0 ? 0xffffffff : chosen);
    gl.uniform1i(uniform.byBody, this.byBody);
    gl.uniform1i(uniform.lit, lit);
    gl.uniform1i(uniform.isCut, cut !== null);
    if (cut) gl.uniform4f(uniform.cut, ...cut.normal, cut.at - dot(centre, cut.normal));
    gl.uniform1f(uniform.edges, edges);
    gl.uniform3fv(uniform.accent, accent);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
  }
}
