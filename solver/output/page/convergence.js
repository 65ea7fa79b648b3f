'use strict';
// The page of `pinball converge`: what each quantity is on each mesh, what finer ones would say, and what an error costs.

const units = unitsOf('units'), study = block('study');
const place = (id) => document.getElementById(id);
const fill = (id, ...children) => place(id).append(...children);
const sizeOf = (factor) => { const [n, d = '1'] = factor.split('/'); return Number(d) / Number(n); };
const sizes = study.meshes.map(({factor}) => sizeOf(factor));
const nameOf = (quantity) => named(quantity.name, raised(quantity.unit));
const range = (pair) => `${figure(pair[0], 6)} to ${figure(pair[1], 6)}`;

function keyFigures() {
  const own = study.meshes.find(({factor}) => factor === '1') ?? study.meshes[0];
  const figures = [['meshes', whole(study.meshes.length)], ['runs', whole(study.points.length)], ['quantities', whole(study.quantities.length)],
    ['elements of mesh ' + own.factor, whole(own.elements)], ['version', study.version]];
  fill('figures', ...figures.map(([name, value]) => make('div', {class: 'figure'},
    make('div', {class: 'name', text: name}), make('div', {class: 'value', text: value}))));
}

function failures() {
  const runs = [...study.meshes.map((mesh) => [`mesh ${mesh.factor}`, mesh]),
    ...study.sources.flatMap((source) => source.runs.map((run) => [source.name, run]))];
  const failed = runs.flatMap(([name, run]) => run.failure !== null ? [make('p', {class: 'error', text: `${name}: ${run.failure}`})]
      : run.left_out !== null ? [make('p', {class: 'note', text: `${name} left out: ${run.left_out}`})] : []);
  if (failed.length === 0) return;
  place('failures').hidden = false;
  fill('failures', ...failed);
}

function quantities() {
  const error = (q) => q.own_error === null || q.own_error === undefined ? '–' : figure(q.own_error, 3);
  const list = table({caption: `${study.quantities.length} quantities on ${study.meshes.length} meshes`, id: 'quantity_table',
    head: ['quantity', ...study.meshes.map(({factor}) => `mesh ${factor}`), 'order', 'extrapolated', 'band (or spread)', 'error of mesh 1', 'verdict'],
    numbers: [...study.meshes.map((_, i) => i + 1), ...[1, 2, 3, 4].map((i) => i + study.meshes.length)],
    rows: study.quantities.map((q) => [nameOf(q), ...q.values.map((v) => figure(v, 6)), figure(q.observed_order, 3), figure(q.extrapolated, 6),
      q.band ? range(q.band) : q.spread ? `(${range(q.spread)})` : '–', error(q), q.verdict ?? '–'])});
  fill('quantities', filter(list, 'Search quantities', [{label: 'only what has a band', keep: (row) => !row.textContent.includes('(')}]), list);
}

/// The curve extrapolated + C h^p through the finest mesh, from h = 0 to the coarsest.
function extrapolation(q) {
  const fine = q.values.reduce((best, v, i) => v !== null && (best < 0 || sizes[i] < sizes[best]) ? i : best, -1);
  const coarse = Math.max(...sizes.filter((_, i) => q.values[i] !== null));
  const c = (q.values[fine] - q.extrapolated) / sizes[fine] ** q.order;
  return Array.from({length: 41}, (_, i) => coarse * i / 40).map((h) => [h, q.extrapolated + c * h ** q.order]);
}

function valuePanel(q) {
  const points = q.values.map((v, i) => ({x: sizes[i], y: v, kind: 'run', text: `mesh ${study.meshes[i].factor}: ${figure(v, 6)}`})).filter((p) => p.y !== null);
  const converges = q.band && q.order;
  if (q.band) points.push({x: 0, y: q.extrapolated, kind: 'extrapolated', text: `extrapolated: ${figure(q.extrapolated, 6)}`});
  return plot({title: q.name, along: {name: 'size of elements, of that of mesh 1'}, upward: {name: nameOf(q)}, points,
    lines: converges ? [{at: extrapolation(q), kind: 'dashed'}] : [],
    band: q.band ? {to: Math.max(...sizes), low: q.band[0], high: q.band[1]} : null,
    more: [make('p', {class: 'note', text: q.band ? `${q.verdict}; band ${range(q.band)}` : q.verdict ?? 'too few meshes'})]});
}

function values() {
  const [banded, others] = [study.quantities.filter((q) => q.band), study.quantities.filter((q) => !q.band)];
  const panels = (list) => make('div', {class: 'panels'}, ...list.map(valuePanel));
  if (banded.length) fill('values', make('p', {class: 'note', text: 'Dots are runs; the ring is the value extrapolated to elements of no size, the dashed curve the way to it, '
      + 'and the band is where the answer is expected.'}), panels(banded));
  if (others.length) fill('values', make('details', {open: banded.length === 0}, make('summary', {text: `Without a band (${others.length})`}), panels(others)));
}

const bytes = (n) => n < 1e6 ? `${figure(n / 1e3, 3)} kB` : n < 1e9 ? `${figure(n / 1e6, 3)} MB` : `${figure(n / 1e9, 3)} GB`;

function costPanel(cost, index) {
  const points = study.points.map((p, i) => ({x: p.seconds, y: 100 * p.errors[index], kind: p.of_chance ? 'chance' : cost.frontier.includes(i) ? 'best' : 'run',
    text: `${p.settings}: ${seconds(p.seconds)}, ${bytes(p.bytes)}, errs by ${percent(p.errors[index])}`}));
  return plot({title: cost.name, along: {name: 'seconds of a run', log: true}, upward: {name: `error of ${cost.name} [%]`, log: true}, points,
    lines: [{at: cost.frontier.map((i) => [study.points[i].seconds, 100 * study.points[i].errors[index]]).filter(([, e]) => e > 0), kind: 'solid'}],
    more: [make('p', {class: 'note', text: cost.sentence})]});
}

function costs() {
  const stated = study.costs.map((cost, i) => [cost, i]).filter(([cost]) => cost.sentence !== null);
  if (study.points.length === 0) return place('costs').hidden = true;
  fill('costs', ...(study.search_sentence ? [make('p', {text: study.search_sentence})] : []),
    make('p', {class: 'note', text: 'The line joins the runs that no other is both faster and better than, by errors against the extrapolated value.'}),
    make('div', {class: 'panels'}, ...stated.map(([cost, i]) => costPanel(cost, i))),
    make('details', {open: study.quantities.length <= 4}, make('summary', {text: `All runs (${study.points.length})`}),
      table({caption: 'Runs', id: 'run_table', head: ['run', 'seconds', 'memory', ...stated.map(([cost]) => `error of ${cost.name}`)],
        numbers: [1, 2, ...stated.map((_, i) => i + 3)],
        rows: study.points.map((p) => [make('span', {text: p.settings, title: p.what}), figure(p.seconds, 3), bytes(p.bytes),
          ...stated.map(([, i]) => p.errors[i] === null ? '–' : percent(p.errors[i]))])})));
}

function sources() {
  if (study.sources.length === 0) return place('sources').hidden = true;
  const names = study.sources.map(({name}) => name);
  fill('sources', table({caption: `On mesh ${study.sources_mesh}: value with each less the value without; of chance the standard deviation`, id: 'source_table',
    head: ['quantity', 'mesh', ...names, 'together', 'largest'], numbers: [1, ...names.map((_, i) => i + 2), names.length + 2],
    rows: study.quantities.map((q) => [nameOf(q), ...['mesh', ...names].map((name) => figure(q.moved_by[name], 3)), figure(q.together, 3), q.largest_source])}),
    ...study.quantities.filter((q) => q.refine).map((q) => make('p', {text: `${q.name}: ${q.refine}`})),
    make('ul', {class: 'note'}, ...study.sources.map(({name, what}) => make('li', {text: `${name}: ${what}`}))));
}

/// The coarsest and the finest run beside each other.
function surfaces() {
  const shown = block('surfaces').filter(({surface}) => surface !== null);
  if (shown.length === 0) return place('viewer').append(make('p', {class: 'note', text: 'No run has left fields of its bodies.'}));
  const nameOfMesh = (factor) => `mesh ${factor}, ${whole(study.meshes.find((mesh) => mesh.factor === factor).elements)} elements`;
  showSurfaces(place('viewer'), shown.map(({surface}) => surface), units, shown.map(({mesh}) => nameOfMesh(mesh)));
}

makePage([keyFigures, failures, quantities, values, surfaces, costs, sources], surfaces);
