'use strict';
// What stands around the drawing of the bodies: the bar of colours, the directions of the axes, a measure. Colours are those of
// python/view/colours.py.

const fromGrey = [[0, '#e3e6ea'], [0.283, '#efc56a'], [0.459, '#e5823f'], [0.71, '#bb3553'], [1, '#451558']];
const bothSigns = ['#053061', '#2166ac', '#4393c3', '#92c5de', '#d1e5f0', '#f7f7f7', '#fddbc7', '#f4a582', '#d6604d', '#b2182b',
                   '#67001f'].map((colour, i) => [i / 10, colour]);
const bodyColours = ['#8fa3b8', '#d9a15b', '#7fb08a', '#c27b8e', '#9c8cc4', '#b8b06a', '#6fb3bd', '#b0a090'];
const redGreenBlue = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
const bodyColour = (body) => bodyColours[body % bodyColours.length];

/// 256 colours [r, g, b] between those of some places.
function colourTable(stops) {
  return Array.from({length: 256}, (_, i) => {
    const share = i / 255, next = Math.max(1, stops.findIndex(([place]) => place >= share));
    const [[low, first], [high, second]] = [stops[next - 1], stops[next]];
    const part = (share - low) / (high - low), [a, b] = [redGreenBlue(first), redGreenBlue(second)];
    return a.map((c, k) => Math.round(c + part * (b[k] - c)));
  });
}
const tables = {false: colourTable(fromGrey), true: colourTable(bothSigns)};

/// The bar of a field with its numbers, name and unit; of bodies (null) nothing: their legend has their colours.
function fillColourBar(place, field, name, unit) {
  place.replaceChildren();
  place.hidden = field === null;
  if (field === null) return;
  const [low, high] = field.range, axis = axisOf(Math.max(Math.abs(low), Math.abs(high)), unit);
  const ticks = roundTicks(low, high), texts = tickTexts(ticks.map((tick) => tick / 10 ** axis.power));
  const stops = tables[field.signed].map((colour, i) => `rgb(${colour}) ${(100 * i / 255).toFixed(2)}%`);
  const strip = make('div', {class: 'strip', style: `background:linear-gradient(to top, ${stops.join(',')})`});
  ticks.forEach((tick, i) => strip.append(make('span', {class: 'tick', text: texts[i], style: `bottom:${100 * (tick - low) / (high - low)}%`})));
  place.append(make('div', {class: 'name'}, `${name} `, make('span', {text: axis.label ? `[${axis.label}]` : ''})), strip);
}

/// Arrows of x, y and z as the camera sees them, those toward the viewer last.
function drawAxes(place, camera) {
  const [right, up, toward] = camera.axes, length = 20;
  const lines = ['x', 'y', 'z'].map((name, i) => ({name, x: right[i], y: -up[i], z: toward[i]})).sort((a, b) => a.z - b.z);
  place.replaceChildren(...lines.filter(({x, y}) => Math.hypot(x, y) > 0.05).flatMap(({name, x, y}) => {
    const size = Math.hypot(x, y), end = (l) => [l * x, l * y].map((v) => v.toFixed(1));
    const [[x2, y2], away] = [end(length), [length * x + 9 * x / size, length * y + 9 * y / size + 4].map((v) => v.toFixed(1))];
    return [svg('line', {class: name, x1: 0, y1: 0, x2, y2}), svg('text', {class: name, x: away[0], y: away[1], 'text-anchor': 'middle'}, name)];
  }));
}

/// A bar of a round length.
function drawMeasure(place, camera, pixels, unit) {
  const each = camera.height / pixels, rough = 130 * each, power = 10 ** Math.floor(Math.log10(rough));
  const length = [5, 2, 1].map((k) => k * power).find((l) => l <= rough * (1 + 1e-9));
  place.firstChild.style.width = `${(length / each).toFixed(1)}px`;
  place.lastChild.textContent = `${figure(length, 3)} ${unit}`.trim();
}
