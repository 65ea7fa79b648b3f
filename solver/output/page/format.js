'use strict';
// What all pages have in common: the blocks of numbers, elements, figures for readers, tables.

const block = (id) => JSON.parse(document.getElementById(id).textContent);

/// An element with attributes (class, text and listeners among them) and children.
function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'text') element.textContent = value;
    else if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== false) element.setAttribute(key, value === true ? '' : value);
  }
  element.append(...children);
  return element;
}

/// "mm^2" with the exponents raised.
const raised = (unit) => unit.replace(/\^(-?\d+)/g, (_, n) => superscript(n));
const superscript = (n) => String(n).replace(/./g, (c) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(c)]);

/// The names of units as a page shows them.
const unitsOf = (id) => Object.fromEntries(Object.entries(block(id)).map(([name, unit]) => [name, raised(unit)]));

/// A number with so many digits; very large and small ones as 1.23×10⁻⁵. Null is what was not finite.
function figure(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split('e');
    return `${mantissa.replace(/\.?0+$/, '').replace('-', '−')}×10${superscript(Number(exponent))}`;
  }
  const rounded = Number(value.toPrecision(digits));
  return rounded.toLocaleString('en-US', {maximumFractionDigits: 12, useGrouping: size >= 1e4}).replace('-', '−');
}
const whole = (value) => Number.isFinite(value) ? value.toLocaleString('en-US') : '–';
const percent = (share, digits = 3) => `${figure(100 * share, digits)} %`;
const vector = (v, digits = 5) => `(${v.map((c) => figure(c, digits)).join(', ')})`;
const seconds = (s) => !Number.isFinite(s) ? '–'
    : s < 120 ? `${figure(s, 3)} s`
    : s < 7200 ? `${Math.floor(s / 60)} min ${Math.round(s % 60)} s`
    : `${Math.floor(s / 3600)} h ${Math.round(s % 3600 / 60)} min`;
const words = (name) => name.replaceAll('_', ' ');
const named = (text, unit) => unit ? `${text} [${unit}]` : text;

/// {caption, head: [names], rows: [[cells]], numbers: [indices of columns]}; a cell is a text or an element.
function table({caption, head, rows, numbers = [], id}) {
  const kind = (column) => numbers.includes(column) ? 'number' : undefined;
  const cell = (content, column) => {
    const name = column === 0 ? 'th' : 'td';
    const element = make(name, {class: kind(column) ?? 'wrap', scope: column === 0 ? 'row' : undefined});
    element.append(content instanceof Node ? content : String(content));
    return element;
  };
  return make('div', {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': caption},
    make('table', {id}, make('caption', {text: caption}),
      make('thead', {}, make('tr', {}, ...head.map((h, i) => make('th', {scope: 'col', class: kind(i), text: h})))),
      make('tbody', {}, ...rows.map((row) => make('tr', {}, ...row.map(cell))))));
}

/// A bar of a share of its column's width, for tables; what it shows stands in figures beside it.
function bar(share, over = false) {
  const width = Math.min(100, Math.max(0, 100 * share));
  return make('div', {class: 'track', 'aria-hidden': 'true'},
    make('div', {class: over ? 'bar over' : 'bar', style: `width:${width.toFixed(2)}%`}));
}

/// A field that hides the rows that lack what is typed, and boxes {label, keep(row)} that hide others.
function filter(tableOf, label, boxes = []) {
  const rows = [...tableOf.querySelectorAll('tbody tr')];
  const count = make('output', {class: 'note', 'aria-live': 'polite'});
  const search = make('input', {type: 'search', 'aria-label': label, placeholder: label});
  const checks = boxes.map((box) => make('input', {type: 'checkbox'}));
  const apply = () => {
    const wanted = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    for (const row of rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !wanted.every((w) => text.includes(w)) || boxes.some((box, i) => checks[i].checked && !box.keep(row));
    }
    count.textContent = `${rows.filter((row) => !row.hidden).length} of ${rows.length} rows`;
  };
  search.addEventListener('input', apply);
  checks.forEach((check) => check.addEventListener('change', apply));
  apply();
  return make('div', {class: 'tools'}, search,
    ...boxes.map((box, i) => make('label', {}, checks[i], ` ${box.label}`)), count);
}

/// Links to the parts that are there.
function contents() {
  const nav = document.getElementById('contents');
  for (const section of document.querySelectorAll('main > section:not([hidden])')) {
    const heading = section.querySelector('h2');
    if (heading) nav.append(make('a', {href: `#${section.id}`, text: heading.textContent}));
  }
}
