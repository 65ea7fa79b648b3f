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
  canvas.addEventListener('keydown', (event) => this.key(event));
};

Viewer.prototype.key = function (event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const {camera} = this, arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]};
  const views = Object.keys(standardViews), view = views[Number(event.key) - 1], [right, up] = arrows[event.key] ?? [0, 0];
  const acts = {
    '+': () => this.zoom(1.25), '=': () => this.zoom(1.25), '-': () => this.zoom(0.8), 'r': () => this.reset(),
    ' ': () => this.play(), ',': () => { this.pause(); this.step(this.frame - 1); }, '.': () => { this.pause(); this.step(this.frame + 1); },
    Escape: () => this.pick(null)};
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

/// Once its numbers are unpacked. Without WebGL 2, or where these cannot be shown, a sentence stands in its place.
let viewer = null;
async function showSurface(place, packed, units) {
  const tell = (text) => place.append(make('p', {class: 'note', text}));
  if (packed.error) return tell(`The bodies cannot be shown here: ${packed.error}.`);
  if (!document.createElement('canvas').getContext('webgl2') || typeof DecompressionStream === 'undefined') {
    return tell('The bodies could be turned here in a browser with WebGL 2, which this one does not have; pictures by pinball view stay.');
  }
  try {
    viewer = new Viewer(place, await unpackedSurface(packed), units);
    charts.push(viewer);
  } catch (error) {
    place.querySelectorAll(':scope > :not(h2)').forEach((part) => part.remove());
    tell(`The bodies cannot be shown in this browser: ${error.message}.`);
  }
}
