'use strict';
// The numbers of a surface, as solver/output/page/surface/packing.hpp has packed them.

/// Bytes of base64, and what they are compressed from. Throws where the browser cannot do that.
async function unpackedBytes(text, encoding) {
  const characters = atob(text), bytes = new Uint8Array(characters.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
  if (encoding === 'none') return bytes;
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(encoding));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/// Reads one list after the other.
class Unpacker {
  constructor(bytes) { this.bytes = bytes; this.at = 0; }

  integers(count) {
    const {bytes, at} = this, numbers = new Float64Array(count);
    let last = 0;
    for (let i = 0; i < count; ++i) {
      let code = 0;
      for (let k = 5; k >= 0; --k) code = 256 * code + bytes[at + k * count + i];
      last += code % 2 === 0 ? code / 2 : -(code + 1) / 2;
      numbers[i] = last;
    }
    this.at += 6 * count;
    return numbers;
  }

  codes(count, before) {
    const {bytes, at} = this, codes = new Uint16Array(count);
    let since = 0;
    for (let i = 0; i < count; ++i) {
      const code = bytes[at + i] | bytes[at + count + i] << 8;
      since += code >> 1 ^ -(code & 1);
      codes[i] = since + (before ? before[i] : 0);
    }
    this.at += 2 * count;
    return codes;
  }
}

const noValue = 0xffff;

/// The block `surface` with its numbers: faces {corners (4 each), element, from, until}, nodes and elements {place, number,
/// body}, frames [{origins (3 a body), positions [x, y, z], fields}] of codes.
async function unpackedSurface(packed) {
  const {data, ...surface} = packed, count = {faces: packed.faces, nodes: packed.nodes, elements: packed.elements};
  const unpacker = new Unpacker(await unpackedBytes(data, packed.encoding));
  const corners = [0, 1, 2, 3].map(() => unpacker.integers(count.faces));
  const [element, from, until] = [0, 1, 2].map(() => unpacker.integers(count.faces));
  surface.faces = {count: count.faces, element, from, until,
                   corners: Uint32Array.from({length: 4 * count.faces}, (_, i) => corners[i % 4][i >> 2])};
  for (const kind of ['nodes', 'elements']) {
    const [place, number, body] = [0, 1, 2].map(() => unpacker.integers(count[kind]));
    surface[kind] = {count: count[kind], place, number, body};
  }
  surface.frames = [];
  for (let k = 0; k < surface.times.length; ++k) {
    const before = surface.frames[k - 1];
    surface.frames.push({
      origins: unpacker.integers(3 * surface.bodies.length),
      positions: [0, 1, 2].map((c) => unpacker.codes(count.nodes, before?.positions[c])),
      fields: surface.fields.map((field, f) => unpacker.codes(count[field.of], before?.fields[f])),
    });
  }
  return surface;
}

/// Where a node is at the time of a frame [length].
function placeOf(surface, frame, node) {
  const body = surface.nodes.body[node], {origins, positions} = surface.frames[frame];
  return [0, 1, 2].map((c) => (origins[3 * body + c] + positions[c][node]) * surface.steps[body][c]);
}

/// The value of a field at a node or an element; null: none.
function valueOf(surface, frame, field, place) {
  const code = surface.frames[frame].fields[field][place], {low, step} = surface.fields[field];
  return code === noValue ? null : low + step * code;
}

const faceIsThere = ({from, until}, face, frame) => from[face] <= frame && frame < until[face];

/// For each axis [lowest, highest] of all that is seen of some bodies at the times of some frames.
function boxOf(surface, axes, frames, showsBody) {
  const {faces, nodes, elements, steps} = surface, low = axes.map(() => Infinity), high = axes.map(() => -Infinity);
  const seen = new Uint8Array(nodes.count);
  for (const frame of frames) {
    const {origins, positions: [x, y, z]} = surface.frames[frame];
    seen.fill(0);
    for (let f = 0; f < faces.count; ++f) {
      if (!faceIsThere(faces, f, frame) || !showsBody(elements.body[faces.element[f]])) continue;
      for (let c = 4 * f; c < 4 * f + 4; ++c) seen[faces.corners[c]] = 1;
    }
    for (let i = 0; i < nodes.count; ++i) {
      if (seen[i] === 0) continue;
      const b = nodes.body[i], step = steps[b];
      const px = (origins[3 * b] + x[i]) * step[0], py = (origins[3 * b + 1] + y[i]) * step[1], pz = (origins[3 * b + 2] + z[i]) * step[2];
      for (let a = 0; a < axes.length; ++a) {
        const at = axes[a][0] * px + axes[a][1] * py + axes[a][2] * pz;
        if (at < low[a]) low[a] = at;
        if (at > high[a]) high[a] = at;
      }
    }
  }
  return axes.map((_, a) => [low[a], high[a]]);
}
