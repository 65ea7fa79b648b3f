'use strict';
// What stands at the axes of a panel: the unit in which its numbers are read best, and ticks that differ from each other.

/// The power of 1000 in which numbers of this size are read best.
const scaleOf = (largest) => largest > 0 && Number.isFinite(largest) && (largest >= 1e5 || largest < 0.1)
    ? Math.max(3 * Math.floor(Math.log10(largest) / 3), -300) : 0;
const shorter = {s: ['ms', 'µs', 'ns'], ms: ['µs', 'ns'], us: ['ns'], 'µs': ['ns']};

/// {power, label, figure(value), unit}: numbers are drawn divided by 10^power, which `label` says. What is read under the
/// pointer has the axis' unit where that has a name of its own (µs), else all its digits and the unit of the scene.
function axisOf(largest, unit = '') {
  const power = scaleOf(largest), named = shorter[unit]?.[-power / 3 - 1];
  const label = power === 0 ? unit : named ?? `10${superscript(power)}${unit ? ` ${unit}` : ''}`;
  const factor = named ? 10 ** power : 1;
  return {power, label, unit: named ?? unit,
          figure: (value, digits = 5) => figure(value === null || value === undefined ? null : value / factor, digits)};
}

/// Numbers of ticks with as many digits as make neighbours differ.
function tickTexts(values) {
  const steps = values.slice(1).map((v, i) => Math.abs(v - values[i])).filter((step) => step > 0);
  const largest = values.reduce((m, v) => Math.max(m, Math.abs(v)), 0);
  const digits = steps.length > 0 ? Math.min(15, Math.max(2, Math.ceil(Math.log10(largest / Math.min(...steps))) + 2)) : 5;
  return values.map((v) => figure(Math.abs(v) < 1e-12 * largest ? 0 : v, digits));
}

/// For dygraphs: its own ticks, with our texts.
function ticks(low, high, pixels, options, graph, values) {
  const all = Dygraph.numericTicks(low, high, pixels, options, graph, values);
  const texts = tickTexts(all.map((tick) => tick.v));
  return all.map((tick, i) => ({...tick, label: texts[i]}));
}

/// The block of numbers has seven digits: what differs by less is constant, and drawn so.
function rangeOfConstant(values) {
  let low = Infinity, high = -Infinity;
  for (const v of values) {
    if (!Number.isFinite(v)) continue;
    low = Math.min(low, v);
    high = Math.max(high, v);
  }
  const size = Math.max(Math.abs(low), Math.abs(high));
  return low <= high && size > 0 && high - low < 2e-6 * size ? [low - 0.1 * size, high + 0.1 * size] : null;
}
