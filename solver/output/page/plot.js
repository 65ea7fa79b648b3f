'use strict';
// Points and lines over an axis that is no time, linear or logarithmic, as SVG.

const plotSize = {width: 480, height: 300, left: 66, right: 14, top: 12, bottom: 44};

function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/// Round numbers from low to high, five or so.
function roundTicks(low, high) {
  const rough = (high - low) / 5, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough);
  const first = Math.ceil(low / step - 1e-9);
  return Array.from({length: Math.floor(high / step + 1e-9) - first + 1}, (_, i) => (first + i) * step);
}

/// Powers of ten from low to high, with 2 and 5 times these where there would be few.
function logTicks(low, high) {
  const ticks = [], parts = high / low < 300 ? [1, 2, 5] : [1];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power) {
    ticks.push(...parts.map((k) => k * 10 ** power));
  }
  return ticks.filter((t) => t >= low * (1 - 1e-9) && t <= high * (1 + 1e-9));
}

/// {place(value) in 0 to 1, ticks} for these values; log: logarithmic, where all are above 0.
function scaleFor(values, log) {
  let low = Math.min(...values), high = Math.max(...values);
  if (log) {
    [low, high] = [low / 1.3, high * 1.3];
    return {place: (v) => Math.log(v / low) / Math.log(high / low), ticks: logTicks(low, high)};
  }
  const room = 0.05 * (high - low) || 0.1 * Math.abs(high) || 1;
  if (low !== 0) low -= room;
  high += room;
  return {place: (v) => (v - low) / (high - low), ticks: roundTicks(low, high)};
}

/// {title, along: {name, log}, upward: {name, log}, points: [{x, y, text, kind}], lines: [{at: [[x, y]], kind}], band: {to,
/// low, high}}: a panel; kinds are classes of page.css. Texts are shown where the pointer is. Points that an axis cannot
/// have (not above 0 where it is logarithmic) are left out.
function plot({title, along, upward, points, lines = [], band = null, more = []}) {
  const has = (axis, v) => Number.isFinite(v) && (!axis.log || v > 0), shown = points.filter((p) => has(along, p.x) && has(upward, p.y));
  const panel = make('figure', {class: 'panel plot'}, make('h3', {text: title}));
  if (shown.length === 0) return panel.append(make('p', {class: 'note', text: 'No points.'})), panel;
  const {width, height, left, right, top, bottom} = plotSize;
  const all = [...shown.map((p) => [p.x, p.y]), ...lines.flatMap((l) => l.at), ...(band ? [[band.to, band.low], [band.to, band.high]] : [])];
  const x = scaleFor(all.map((p) => p[0]), along.log), y = scaleFor(all.map((p) => p[1]), upward.log);
  const across = (v) => left + x.place(v) * (width - left - right), down = (v) => height - bottom - y.place(v) * (height - top - bottom);
  const drawing = svg('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': `${upward.name} over ${along.name}`});
  if (band) {
    drawing.append(svg('rect', {class: 'band', x: across(0), y: down(band.high), width: across(band.to) - across(0), height: down(band.low) - down(band.high)}));
  }
  tickTexts(y.ticks).forEach((text, i) => {
    const at = down(y.ticks[i]);
    drawing.append(svg('line', {class: 'grid', x1: left, x2: width - right, y1: at, y2: at}), svg('text', {x: left - 6, y: at + 4, 'text-anchor': 'end'}, text));
  });
  tickTexts(x.ticks).forEach((text, i) => {
    const at = across(x.ticks[i]);
    drawing.append(svg('line', {class: 'grid', x1: at, x2: at, y1: top, y2: height - bottom}), svg('text', {x: at, y: height - bottom + 16, 'text-anchor': 'middle'}, text));
  });
  drawing.append(svg('text', {class: 'name', x: width - right, y: height - 8, 'text-anchor': 'end'}, along.name));
  for (const {at, kind} of lines) {
    drawing.append(svg('polyline', {class: `line ${kind}`, points: at.map(([u, v]) => `${across(u).toFixed(1)},${down(v).toFixed(1)}`).join(' ')}));
  }
  for (const p of shown) {
    drawing.append(svg('circle', {class: `point ${p.kind}`, cx: across(p.x).toFixed(1), cy: down(p.y).toFixed(1), r: 4.5, tabindex: 0}, svg('title', {}, p.text)));
  }
  panel.append(make('p', {class: 'axis', text: upward.name}), drawing, ...more);
  return panel;
}
