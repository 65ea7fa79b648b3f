'use strict';
// Curves over time, drawn by dygraphs. Hovering shows the values of all curves of the panel in its legend, and the same
// time in the other panels; the arrow keys do the same; dragging zooms, a double click zooms out.

// Colours that the colour-blind can tell apart (Okabe and Ito), and dashes where there are more curves than colours.
const dark = matchMedia('(prefers-color-scheme: dark)');
const colours = () => dark.matches
    ? ['#56b4e9', '#e69f00', '#2fc79a', '#e58fbf', '#f0e442', '#ff8f4d', '#b7bec6']
    : ['#0072b2', '#d55e00', '#009e73', '#b8578f', '#a87900', '#3a9bd0', '#444444'];
const dashes = [null, [7, 3], [2, 3], [9, 3, 2, 3]];
const look = (i) => ({colour: colours()[i % 7], dash: dashes[Math.floor(i / 7) % 4]});

const isNumber = (v) => v !== null && v !== undefined;
const largestOf = (values) => values.reduce((m, v) => isNumber(v) ? Math.max(m, Math.abs(v)) : m, 0);

const charts = [];
let selecting = false;

/// Shows the same time in all charts. The one under the pointer has its own row already.
function select(time, from) {
  if (selecting) return;
  selecting = true;
  for (const chart of charts) chart.show(time, chart === from);
  selecting = false;
}

function nearest(times, time) {
  let low = 0, high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle; else high = middle;
  }
  return time - times[low] < times[high] - time ? low : high;
}

/// {title, unit, times, timeUnit, series: [{name, values}], look: index of the first look}: a panel with curves. Series
/// have one value per time, or their own {times}; then all are drawn over the union of times.
function chart({title, unit, times, timeUnit, series, first = 0, zero = true}) {
  const panel = make('figure', {class: 'panel'});
  const all = merged(times, series);
  const upward = axisOf(Math.max(0, ...all.values.map(largestOf)), unit), along = axisOf(largestOf(all.times), timeUnit);
  const heading = make('h3', {text: title});
  const axis = make('p', {class: 'axis', text: named(title, upward.label)});
  const place = make('div', {class: 'chart', tabindex: 0, role: 'img', 'aria-label':
      `${named(title, upward.label)} over time${along.label ? ` in ${along.label}` : ''}: ${series.map((s) => s.name).join(', ')}. Arrow keys move through time; values in the list below.`});
  const below = make('p', {class: 'axis below', text: named('time', along.label)});
  const legend = make('ul', {class: 'legend'});
  const now = make('p', {class: 'now', 'aria-live': 'polite'});
  const inFigures = extremesTable(title, upward, along, all, series);
  panel.append(heading, axis, place, below, legend, now, ...noNumbers(all, series, along), inFigures);
  if (typeof Dygraph === 'undefined' || all.times.length === 0) {
    place.replaceWith(make('p', {class: 'note', text: all.times.length === 0 ? 'No rows.'
        : 'This program was built without dygraphs (Debian: libjs-dygraphs), so that there are no curves here.'}));
    for (const part of [axis, below, legend, now]) part.remove();
    inFigures.open = true;
    return panel;
  }
  // For dygraphs null is a value that is not there, which curves pass over, and NaN one that is no number: a gap.
  const drawn = (v) => v === null ? NaN : v === undefined ? null : v / 10 ** upward.power;
  const rows = all.times.map((t, r) => [t / 10 ** along.power, ...all.values.map((v) => drawn(v[r]))]);
  const constant = zero ? null : rangeOfConstant(rows.flatMap((row) => row.slice(1)));
  const shown = series.map(() => true);
  const entries = series.map((s, i) => legendEntry(s, () => {
    shown[i] = !shown[i];
    entries[i].button.setAttribute('aria-pressed', shown[i]);
    graph.setVisibility(i, shown[i]);
  }));
  legend.append(...entries.map((e) => e.item));
  let graph = null, labelWidth = 58;
  const self = {
    row: -1,
    show(time, own) {
      self.row = nearest(all.times, time);
      if (!own && graph) graph.setSelection(self.row);
      now.textContent = `at ${along.figure(all.times[self.row])} ${along.unit}`.trim();
      entries.forEach((e, i) => { e.value.textContent = upward.figure(all.values[i][self.row]); });
    },
    light(name) { entries.forEach((e, i) => e.item.classList.toggle('lit', series[i].name === name)); },
    draw() {
      const ink = getComputedStyle(document.documentElement);
      entries.forEach((e, i) => e.sample(look(first + i)));
      graph?.destroy();
      graph = new Dygraph(place, rows, {
        labels: ['time', ...series.map((s) => s.name)],
        colors: series.map((s, i) => look(first + i).colour),
        series: Object.fromEntries(series.map((s, i) => [s.name, {strokePattern: look(first + i).dash}])),
        visibility: shown, strokeWidth: 1.8, legend: 'never', includeZero: zero, connectSeparatedPoints: true,
        gridLineColor: ink.getPropertyValue('--line'), axisLineColor: ink.getPropertyValue('--line'),
        highlightCircleSize: 4, highlightSeriesBackgroundAlpha: 1, highlightSeriesOpts: {strokeWidth: 3},
        axes: {x: {pixelsPerLabel: 70, ticker: ticks}, y: {axisLabelWidth: labelWidth, pixelsPerLabel: 32, ticker: ticks}},
        ...(constant ? {valueRange: constant} : {}),
        drawCallback: (drawnGraph) => {  // long numbers get their room
          const longest = Math.max(0, ...[...place.querySelectorAll('.dygraph-axis-label-y')].map((l) => l.textContent.length));
          const wanted = Math.max(58, 7 * longest + 8);
          if (wanted <= labelWidth) return;
          labelWidth = wanted;
          drawnGraph.updateOptions({axes: {y: {axisLabelWidth: labelWidth}}});
        },
        highlightCallback: (event, x, points, row, name) => { select(all.times[row], self); self.light(name); },
        unhighlightCallback: () => self.light(null),
      });
    },
  };
  place.addEventListener('keydown', (event) => {
    const step = {ArrowLeft: -1, ArrowRight: 1, PageUp: -10, PageDown: 10, Home: -Infinity, End: Infinity}[event.key];
    if (!step) return;
    event.preventDefault();
    const row = Math.min(all.times.length - 1, Math.max(0, self.row + step));
    select(all.times[row], null);
  });
  charts.push(self);
  return panel;
}

/// Curves with times of their own on the union of all times; undefined where a curve has none.
function merged(times, series) {
  if (series.every((s) => !s.times)) return {times, values: series.map((s) => s.values)};
  const union = [...new Set(series.flatMap((s) => s.times))].sort((a, b) => a - b);
  const place = new Map(union.map((t, i) => [t, i]));
  return {times: union, values: series.map((s) => {
    const values = union.map(() => undefined);
    s.times.forEach((t, i) => { values[place.get(t)] = s.values[i]; });
    return values;
  })};
}

function legendEntry(series, toggle) {
  const line = make('span');
  const value = make('output');
  const button = make('button', {type: 'button', 'aria-pressed': 'true', title: 'show or hide', onclick: toggle},
    line, make('span', {text: series.name}), value);
  const sample = ({colour, dash}) => {
    line.innerHTML = '<svg width="22" height="8" aria-hidden="true"><line x1="0" y1="4" x2="22" y2="4" stroke-width="3"/></svg>';
    const stroke = line.firstChild.firstChild;
    stroke.setAttribute('stroke', colour);
    if (dash) stroke.setAttribute('stroke-dasharray', dash.join(' '));
  };
  return {item: make('li', {}, button), button, value, sample};
}

/// Where a curve ends because its values are no numbers.
function noNumbers(all, series, along) {
  return series.flatMap((s, i) => {
    const row = all.values[i].indexOf(null);
    return row < 0 ? [] : [make('p', {class: 'note bad', text:
        `${s.name} is no number at ${along.figure(all.times[row])} ${along.unit}`.trim() + '.'})];
  });
}

/// The curves in figures: for who cannot see them, and for what a curve does not show.
function extremesTable(title, upward, along, all, series) {
  const rows = series.map((s, i) => {
    const known = all.values[i].map((v, r) => [v, all.times[r]]).filter(([v]) => isNumber(v));
    if (known.length === 0) return [s.name, '–', '–', '–', '–'];
    const least = known.reduce((a, b) => b[0] < a[0] ? b : a), most = known.reduce((a, b) => b[0] > a[0] ? b : a);
    const at = ([v, t]) => `${upward.figure(v)} at ${along.figure(t, 4)}`;
    return [s.name, upward.figure(known[0][0]), at(least), at(most), upward.figure(known[known.length - 1][0])];
  });
  const head = ['curve', 'at the start', named('smallest, at time', along.unit), named('largest, at time', along.unit), 'at the end'];
  return make('details', {}, make('summary', {text: 'In figures'}),
    table({caption: named(title, upward.unit), head, rows, numbers: [1, 2, 3, 4]}));
}

/// Panels of one section, and `more` after them; curves that are small beside the largest get panels of their own, so that they can be read.
function panelsBySize({title, small, series, limit = 0.05, more = [], ...rest}) {
  const largest = (list) => Math.max(0, ...list.map((s) => largestOf(s.values)));
  const isZero = (s) => s.values.every((v) => v === 0), zero = series.filter(isZero);
  let left = series.filter((s) => !isZero(s)), first = 0;
  const panels = [];
  while (left.length > 0) {
    // In three panels, or they become too many.
    const here = panels.length === 2 ? left : left.filter((s) => largestOf(s.values) >= limit * largest(left));
    panels.push(chart({title: panels.length === 0 ? title : panels.length === 1 ? small : `${small}, smallest`,
                       series: here, first, ...rest}));
    first += here.length;
    left = left.filter((s) => !here.includes(s));
  }
  const place = make('div', {class: 'panels'}, ...panels, ...more);
  const note = zero.length === 0 ? '' : make('p', {class: 'note',
      text: `Zero throughout: ${zero.map((s) => s.name).join(', ')}.`});
  return [place, note];
}

/// Once all panels are in the page, and again where its colours change.
function drawCharts() {
  charts.forEach((c) => c.draw());
  dark.addEventListener('change', () => charts.forEach((c) => c.draw()));
}
