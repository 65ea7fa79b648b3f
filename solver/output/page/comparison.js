'use strict';
// The page of `pinball compare`: variants in columns, and their curves over each other.

const units = unitsOf('units'), comparison = block('comparison'), curves = block('curves');
const place = (id) => document.getElementById(id);
const fill = (id, ...children) => place(id).append(...children);
const variants = comparison.variants;
// As it is, without a key. With one key, which the heading names, its values; else all pairs of key and value.
const names = variants.map(({settings}) => Object.keys(settings).length === 0 ? 'here' : Object.keys(settings).length === 1 ? Object.values(settings)[0]
    : Object.entries(settings).map(([key, value]) => `${key}=${value}`).join(', '));

function keyFigures() {
  const first = variants[0].summary, {machine} = comparison;
  const figures = [['variants', whole(variants.length)], ['repeats', whole(comparison.repeats)], ['elements', whole(first.elements)],
    ['threads', whole(machine.threads)], ['processor', machine.cpu], ['version', comparison.version]];
  fill('figures', ...figures.map(([name, value]) => make('div', {class: 'figure'},
    make('div', {class: 'name', text: name}), make('div', {class: 'value', text: value}))));
}

function failures() {
  const failed = variants.map((v, i) => [names[i], v.failure]).filter(([, failure]) => failure !== null);
  if (failed.length === 0) return;
  place('failures').hidden = false;
  fill('failures', ...failed.map(([name, text]) => make('p', {class: 'error', text: `${name}: ${text}`})));
}

/// A row per variant, with bars of the medians.
function times() {
  const medians = variants.map((v) => v.seconds.total.median), most = Math.max(...medians);
  const spread = (s) => comparison.repeats === 1 ? figure(s.median) : `${figure(s.median)} (${figure(s.min, 3)} to ${figure(s.max, 3)})`;
  const ratio = (r) => r === null ? '–' : figure(r, 4);
  fill('times', table({
    caption: `Seconds${comparison.repeats === 1 ? '' : `: median of ${comparison.repeats} (smallest to largest)`}`, id: 'variant_times',
    numbers: [1, 3, 4, 5, 6],
    head: ['variant', 'all', '', 'contact', 'share of contact', 'first / this', 'contact, first / this'],
    rows: variants.map((v, i) => [names[i], spread(v.seconds.total), bar(medians[i] / most), spread(v.seconds.contact),
      percent(v.contact_share, 3), ratio(v.first_over_this.total), ratio(v.first_over_this.contact)])}));
}

/// What is compared of the results: [name, text of a variant].
function quantities() {
  const rows = [
    ['steps', ({summary: s}) => whole(s.steps)],
    [named('time reached', units.time), ({summary: s}) => figure(s.end_time)],
    ['largest balance error', ({summary: s}) => percent(s.energy.balance_error_max)],
    ['momentum error', (v) => v.momentum_error === null ? '–' : percent(v.momentum_error)],
    ['deepest penetration, of the two radii', ({summary: s}) => percent(s.contact.max_penetration_ratio)],
    ['most pairs in contact', ({summary: s}) => whole(s.contact.pairs_max)],
    ['searches', ({summary: s}) => whole(s.contact.searches)],
  ];
  for (const key of ['kinetic', 'internal', 'hourglass', 'bulk_viscosity', 'folding', 'contact', 'eroded', 'external']) {
    rows.push([named(`${words(key)} energy at the end`, units.energy), ({summary: s}) => figure(s.energy[key], 5)]);
  }
  variants[0].summary.bodies.forEach(({name}) => {
    const body = ({summary: s}) => s.bodies.find((b) => b.name === name);
    rows.push([`${name}: mass remaining`, (v) => percent(body(v).mass_remaining / body(v).mass_initial, 4)],
              [named(`${name}: velocity`, units.velocity), (v) => vector(body(v).velocity)],
              [`${name}: eroded elements`, (v) => whole(body(v).eroded_elements)],
              [`${name}: largest plastic strain`, (v) => figure(body(v).max_plastic_strain)]);
  });
  rows.push(['warnings', ({summary: s}) => whole(s.warnings.length)], ['state', ({summary: s}) => s.state_hash]);
  return rows;
}

function results() {
  const list = table({caption: 'Results, the same in all repeats', id: 'variant_results', head: ['quantity', ...names],
    rows: quantities().map(([name, text]) => [name, ...variants.map(text)]), numbers: names.map((_, i) => i + 1)});
  const differs = (row) => new Set([...row.querySelectorAll('td')].map((cell) => cell.textContent)).size > 1;
  fill('results', filter(list, 'Search quantities', [{label: 'only what differs', keep: differs}]), list);
  const warned = variants.flatMap((v, i) => v.summary.warnings.map((text) => make('li', {text: `${names[i]}: ${text}`})));
  if (warned.length) fill('results', make('details', {}, make('summary', {text: `Warnings (${warned.length})`}), make('ul', {}, ...warned)));
}

/// All variants that have run, beside each other.
function surfaces() {
  const shown = block('surfaces').map((packed, i) => [packed, names[i]]).filter(([packed]) => packed !== null);
  if (shown.length === 0) return place('viewer').append(make('p', {class: 'note', text: 'Bodies are kept of variants that have 100,000 elements together.'}));
  showSurfaces(place('viewer'), shown.map(([packed]) => packed), units, shown.map(([, name]) => name));
}

const columnOf = (curve, name) => curve.data[curve.columns.indexOf(name)];
/// A panel in which the variants lie over each other; nothing where all are zero.
function overlay(column, title, unit, factor = 1) {
  const series = curves.map((curve, i) => ({name: names[i], times: columnOf(curve, 'time'),
      values: columnOf(curve, column)?.map((v) => v === null ? null : factor * v)})).filter((s) => s.values);
  if (!series.some((s) => largestOf(s.values) > 0)) return '';
  return chart({title, unit, times: [], timeUnit: units.time, series, zero: false});
}
const panels = (...all) => make('div', {class: 'panels'}, ...all);
const drawn = (id, ...all) => {
  if (all.some((panel) => panel !== '')) fill(id, panels(...all));
  else place(id).hidden = true;
};

function overlays() {
  const energies = ['kinetic', 'internal', 'contact_stored', 'contact_damped', 'eroded', 'hourglass', 'hourglass_plastic', 'bulk_viscosity', 'folding', 'external', 'total'];
  drawn('energies', ...energies.map((name) => overlay(name, `${words(name)} energy`, units.energy)),
        overlay('balance_error', 'Error of the balance', '%', 100));
  drawn('bodies', ...variants[0].summary.bodies.flatMap(({name}) => ['x', 'y', 'z'].map((k) =>
    overlay(`${name}_velocity_${k}`, `${name}: velocity ${k}`, units.velocity))));
  drawn('momentum', ...['x', 'y', 'z'].map((k) => overlay(`momentum_${k}`, `Momentum ${k}`, units.momentum)));
  // After those of all and of the bodies, of which the last is its largest plastic strain
  const {columns} = curves[0], bodies = variants[0].summary.bodies;
  const others = columns.slice(columns.indexOf(`${bodies[bodies.length - 1].name}_max_plastic_strain`) + 1);
  const unitOf = block('column_units');
  drawn('more', ...others.map((name) => overlay(name, words(name), unitOf[name])));
}

/// The run and the histories of other programs: how far they are apart, and their curves over each other.
function beside() {
  if (!comparison.beside) return place('beside').remove();
  const share = (s) => s === null ? '–' : percent(s, 3);
  comparison.beside.forEach((other, k) => {
    const rows = other.quantities.flatMap((q) => q.variants.map((v, i) => v && [q.name, q.columns, names[i], figure(v.time),
      figure(v.here, 5), figure(v.there, 5), share(v.difference), share(v.largest_difference), figure(v.largest_time), share(v.root_mean_square)])
      .filter((row) => row));
    const {file, there, here} = block('other_histories')[k];
    fill('beside', rows.length === 0 ? make('p', {class: 'note', text: `${file} has no quantity that this run has at the same times.`})
      : table({caption: `${file}: ${other.kind}, ${whole(other.times)} times; differences over the largest size there`, id: `beside_${k}`,
          numbers: [3, 4, 5, 6, 7, 8, 9], rows,
          head: ['quantity', 'here', 'variant', named('time', units.time), 'here', 'there', 'difference', 'largest', 'at', 'root mean square']}));
    if (other.not_compared.length) fill('beside', make('p', {class: 'note', text: `Not compared: ${other.not_compared.join(', ')}.`}));
    const series = (name) => [...here.map((curve, i) => ({name: names[i], times: columnOf(curves[i], 'time'), values: columnOf(curve, name)})),
      {name: file, times: columnOf(there, 'time'), values: columnOf(there, name)}];
    const shown = there.columns.slice(1).filter((name) => series(name).some((s) => largestOf(s.values) > 0));
    if (shown.length) fill('beside', panels(...shown.map((name) => chart({title: name, unit: '', times: [], timeUnit: units.time, series: series(name), zero: false}))));
  });
}

makePage([keyFigures, failures, times, results, surfaces, beside, overlays], surfaces);
