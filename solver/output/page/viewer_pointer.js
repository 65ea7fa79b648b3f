'use strict';
// Pointer, touch and keys of the viewer.

Viewer.prototype.listen = function () {
  const {canvas, camera} = this, pointers = new Map();
  let moved = 0, spread = 0;
  const pair = () => {
    const [a, b] = [...pointers.values()];
    return {spread: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY),
            middle: {clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2}};
  };
  canvas.addEventListener('pointerdown', (event) => {
    pointers.set(event.pointerId, event);
    canvas.setPointerCapture(event.pointerId);
    moved = pointers.size > 1 ? Infinity : 0;
    if (pointers.size === 2) spread = pair().spread;
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    const old = pointers.size === 2 ? pair().middle : before;
    pointers.set(event.pointerId, event);
    const now = pointers.size === 2 ? pair().middle : event;
    const [right, up] = [now.clientX - old.clientX, old.clientY - now.clientY];
    moved += Math.hypot(right, up);
    if (moved < 4) return pointers.set(event.pointerId, before);
    if (pointers.size === 2) {
      const {spread: wide, middle} = pair();
      camera.zoom(wide / spread, ...this.partsOf(middle));
      spread = wide;
    }
    if (pointers.size === 2 || event.shiftKey || event.buttons & 6) camera.move(-right / canvas.clientHeight, -up / canvas.clientHeight);
    else camera.turn(-0.4 * right, -0.4 * up);
    this.draw();
  });
  const up = (event) => {
    if (!pointers.delete(event.pointerId)) return;
    if (event.type === 'pointerup' && moved < 4 && event.button === 0) this.pickAt(event);
  };
  for (const kind of ['pointerup', 'pointercancel']) canvas.addEventListener(kind, up);
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => {  // a reader who scrolls past is left alone
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), ...this.partsOf(event));
    this.draw();
  }, {passive: false});
  canvas.addEventListener('keydown', (event) => (this.leader ?? this).key(event));
};

Viewer.prototype.key = function (event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const {camera} = this, arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  const views = Object.keys(standardViews), view = views[Number(event.key) - 1], [right, up] = arrows[event.key] ?? [0, 0];
  const acts = {
    '+': () => this.zoom(1.25), '=': () => this.zoom(1.25), '-': () => this.zoom(0.8), 'r': () => this.reset(), 'f': () => this.fit(),
    ' ': () => this.play(), ',': () => { this.pause(); this.step(this.frame - 1); }, '.': () => { this.pause(); this.step(this.frame + 1); },
    Escape: () => this.all.forEach((one) => one.pick(null))};
  if (right !== 0 || up !== 0) {
    if (event.shiftKey) camera.move(-0.05 * right, -0.05 * up);
    else camera.turn(-5 * right, -5 * up);
  } else if (view) {
    this.look(view);
  } else if (acts[event.key]) {
    acts[event.key]();
  } else {
    return;
  }
  event.preventDefault();
  this.draw();
};

/// Of several surfaces the colours of a field have one range.
function uniteRanges(surfaces) {
  const fields = surfaces.flatMap((surface) => surface.fields);
  for (const field of fields) {
    const ranges = fields.filter(({name}) => name === field.name).map(({range}) => range);
    field.united = [Math.min(...ranges.map((r) => r[0])), Math.max(...ranges.map((r) => r[1]))];
  }
  for (const field of fields) field.range = field.united;
}

/// The first viewer of the page, once its numbers are unpacked. Without WebGL 2, or where numbers cannot be shown, a sentence
/// stands in its place. packed: of one run, or of several that are seen beside each other by their names.
let viewer = null;
async function showSurfaces(place, packed, units, names = ['']) {
  const tell = (text) => place.append(make('p', {class: 'note', text}));
  for (const {error} of packed) if (error) return tell(`The bodies cannot be shown here: ${error}.`);
  if (!document.createElement('canvas').getContext('webgl2') || typeof DecompressionStream === 'undefined') {
    return tell('The bodies could be turned here in a browser with WebGL 2, which this one does not have; pictures by pinball view stay.');
  }
  try {
    const surfaces = await Promise.all(packed.map(unpackedSurface));
    uniteRanges(surfaces);
    const tools = make('div'), stage = make('div', {class: 'beside'}), facts = make('div');
    place.append(tools, stage, facts);
    const places = {tools, stage, facts};
    const leader = new Viewer(places, surfaces[0], units, null, names[0]);
    const all = [leader, ...surfaces.slice(1).map((surface, i) => new Viewer(places, surface, units, leader, names[i + 1]))];
    leader.reset();
    charts.push(...all);
    viewer = leader;
  } catch (error) {
    place.querySelectorAll(':scope > :not(h2)').forEach((part) => part.remove());
    tell(`The bodies cannot be shown in this browser: ${error.message}.`);
  }
}
