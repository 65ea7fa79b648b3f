'use strict';
// The page of a run, from summary.json, history.csv and the keys of the scene.

const units = unitsOf('units'), summary = block('summary'), recorded = block('history'), scene = block('scene');
const column = (name) => recorded.data[recorded.columns.indexOf(name)];
const times = column('time') ?? [];
const overTime = {times, timeUnit: units.time};
const series = (names, label = words) => names.filter(column).map((name) => ({name: label(name), values: column(name)}));
const place = (id) => document.getElementById(id);
const fill = (id, ...children) => place(id).append(...children);
const drop = (id) => { place(id).hidden = true; };
/// What round-off leaves of what is zero: velocities of 1e-19 m/s look like a motion where an axis follows them.
const fastest = () => {
  const mass = summary.bodies.reduce((m, b) => m + b.mass_initial, summary.point_mass ?? 0);
  return mass > 0 ? Math.sqrt(2 * largestOf(column('kinetic') ?? []) / mass) : 0;
};
const isRoundOff = (list, scale) => list.length > 0 && list.every((s) => s.values.every((v) => v !== null && Math.abs(v) <= 1e-10 * scale));
const roundOff = (what) => make('p', {class: 'note', text: `${what}: zero but for round-off.`});
const hasValues = (list) => list.some((s) => largestOf(s.values) > 0);

/// A run that was stopped is neither done nor failed; the summary says so.
function status() {
  if (summary.status !== 'stopped') return;
  Object.assign(place('status'), {textContent: 'stopped', className: 'status stopped'});
  place('contents').before(make('p', {class: 'note', text: `Stopped at ${figure(summary.end_time)} ${units.time}, before its end.`}));
}

function keyFigures() {
  const s = summary;
  const figures = [
    ['elements', whole(s.elements)], ['nodes', whole(s.nodes)], ['steps', whole(s.steps)],
    ['time reached', figure(s.end_time), units.time], ['wall time', seconds(s.wall_seconds)],
    ['element steps per second', figure(s.element_steps_per_second, 3)],
    ['largest balance error', percent(s.energy.balance_error_max)],
    ...(s.inside_out.most > 0 ? [['elements inside out, at most', whole(s.inside_out.most)]] : []),
    ['precision', s.precision],
    ['threads', whole(s.threads)], ['version', s.version], ['state', s.state_hash],
  ];
  fill('figures', ...figures.map(([name, value, unit]) => make('div', {class: 'figure'},
    make('div', {class: 'name', text: name}),
    make('div', {class: 'value', text: value}, unit ? make('span', {class: 'unit', text: ` ${unit}`}) : ''))));
  if (recorded.all_rows > times.length) {
    place('figures').after(make('p', {class: 'note', text: `Curves show ${whole(times.length)} of ${whole(recorded.all_rows)} `
        + 'rows of history.csv; no smallest or largest value is lost.'}));
  }
}

function warnings() {
  if (summary.warnings.length === 0) return;
  const atOnce = summary.warnings.length > 8 ? 6 : summary.warnings.length;  // more would push all else away
  const list = (texts) => make('ul', {}, ...texts.map((text) => make('li', {text})));
  const [first, rest] = [summary.warnings.slice(0, atOnce), summary.warnings.slice(atOnce)];
  place('warnings').hidden = false;
  place('warnings').querySelector('h2').textContent = summary.warnings.length === 1 ? 'One warning' : `${summary.warnings.length} warnings`;
  fill('warnings', list(first));
  if (rest.length > 0) fill('warnings', make('details', {}, make('summary', {text: `${rest.length} more warnings`}), list(rest)));
}

/// What `pinball converge --keep` has found of this scene.
function converged() {
  const bands = block('converged');
  if (!bands || bands.length === 0) return;
  place('bands').hidden = false;
  fill('bands', make('p', {class: 'note', text: 'This scene was run on finer and coarser meshes: where the answer of elements of no size is expected.'}),
    table({caption: 'Values of this run with their bands', id: 'band_table', numbers: [1, 2, 3, 4],
      head: ['quantity', 'this run', 'errs by at most', 'band', 'extrapolated', 'on finer meshes it'],
      rows: bands.map((q) => [named(q.name, raised(q.unit)), figure(q.value, 6), figure(q.error, 2), `${figure(q.low, 6)} to ${figure(q.high, 6)}`,
        figure(q.extrapolated, 6), q.verdict])}));
}

function bodies() {
  const velocities = summary.bodies.map(({name}) => ({title: `Velocity of ${name}`, unit: units.velocity, ...overTime,
    series: series(['x', 'y', 'z'].map((k) => `${name}_velocity_${k}`), (c) => c.slice(-1))}));
  const isStill = (panel) => isRoundOff(panel.series, fastest());
  const panels = velocities.filter((panel) => !isStill(panel)).map(chart);
  const ofAll = (quantity, value = (v) => v) => summary.bodies.filter(({name}) => column(`${name}_${quantity}`))
    .map((body) => ({name: body.name, values: column(`${body.name}_${quantity}`).map((v) => v === null ? null : value(v, body))}));
  const mass = ofAll('mass_remaining', (v, body) => 100 * v / body.mass_initial);
  if (mass.some((s) => s.values.some((v) => v < 100 - 1e-6))) {
    panels.push(chart({title: 'Mass remaining', unit: '%', ...overTime, series: mass}));
    panels.push(chart({title: 'Eroded elements', ...overTime, series: ofAll('eroded_elements')}));
  }
  for (const energy of ['kinetic', 'internal', 'hourglass', 'bulk_viscosity']) {  // with output.body_energies
    const each = ofAll(energy);
    if (hasValues(each)) panels.push(chart({title: `${words(energy)}: energy of each`, unit: units.energy, ...overTime, series: each}));
  }
  const strain = ofAll('max_plastic_strain');
  if (hasValues(strain)) panels.push(chart({title: 'Largest plastic strain', ...overTime, series: strain}));
  fill('bodies', table({
    caption: 'Bodies at the end', numbers: [1, 2, 3, 4, 6],
    head: ['body', 'elements', 'eroded', named('mass at the start', units.mass), 'mass remaining', named('velocity', units.velocity),
           'largest plastic strain'],
    rows: summary.bodies.map((b) => [b.name, whole(b.elements), whole(b.eroded_elements), figure(b.mass_initial, 5),
      percent(b.mass_remaining / b.mass_initial, 4), vector(b.velocity), figure(b.max_plastic_strain)])}),
    ...velocities.filter(isStill).map((panel) => roundOff(panel.title)),
    make('div', {class: 'panels'}, ...panels));
}

function momentum() {
  const {initial, final} = summary.momentum;
  const curves = series(['x', 'y', 'z'].map((k) => `momentum_${k}`), (c) => c.slice(-1));
  const mass = summary.bodies.reduce((m, b) => m + b.mass_initial, summary.point_mass ?? 0);
  fill('momentum', isRoundOff(curves, mass * fastest()) ? roundOff('Momentum')
    : make('div', {class: 'panels'}, chart({title: 'Momentum', unit: units.momentum, ...overTime, series: curves})),
    table({caption: named('Momentum of all', units.momentum), head: ['component', 'at the start', 'at the end'], numbers: [1, 2],
           rows: ['x', 'y', 'z'].map((k, i) => [k, figure(initial[i], 6), figure(final[i], 6)])}));
}

function contactFacts() {
  const c = summary.contact;
  const facts = [['method', c.method], ['enforcement', c.enforcement], ['gap', c.gap], ['pinballs at the end', whole(c.pinballs)],
    ['most pairs in contact', whole(c.pairs_max)], ['searches', whole(c.searches)],
    ['deepest penetration', c.max_penetration_ratio > 0 ? `${percent(c.max_penetration_ratio)} of the two radii, at `
      + `${figure(c.max_penetration_time)} ${units.time}, ${c.max_penetration_place}` : 'none']];
  if (c.solves > 0) {
    facts.push(['systems of impulses', `${whole(c.solves)}, of which ${whole(c.unconverged)} (${percent(c.unconverged / c.solves, 3)}) did not converge`],
      ['most that a solution left', `${figure(c.residual_max)} ${units.velocity}, ${percent(c.residual_share_max)} of the largest velocity that it had to change`]);
  }
  if (c.sweeps?.solutions > 0) facts.push(['sweeps of a solution', `${figure(c.sweeps.mean, 3)} on average, ${whole(c.sweeps.largest)} at most`]);
  return table({caption: 'Contact', head: ['what', 'value'], rows: facts});
}

function forces() {
  const panels = summary.bodies.map(({name}) => [name, ['x', 'y', 'z'].map((k) => `${name}_contact_force_${k}`)])
    .filter(([, names]) => names.every(column) && hasValues(series(names)))
    .map(([name, names]) => chart({title: `Contact force on ${name}`, unit: units.force, ...overTime,
                                   series: series(names, (c) => c.slice(-1))}));
  for (const [quantity, unit] of [['force', units.force], ['impulse', units.momentum]]) {
    const walls = summary.rigid_walls.map(({name}) => name).filter((name) => column(`${name}_${quantity}`));
    if (walls.length) {
      panels.push(chart({title: `Rigid walls: ${quantity}`, unit, ...overTime,
                         series: walls.map((name) => ({name, values: column(`${name}_${quantity}`)}))}));
    }
  }
  if (summary.contact.method !== 'none') fill('forces', contactFacts());
  if (panels.length) fill('forces', make('p', {class: 'note', text: 'Forces are those of single steps, in which contact may be a '
      + 'knock: their peaks grow with shorter steps, impulses do not.'}));
  if (panels.length) fill('forces', make('div', {class: 'panels'}, ...panels));
  if (summary.rigid_walls.length) {
    fill('forces', table({caption: 'Rigid walls', numbers: [1, 2],
      head: ['wall', named('impulse', units.momentum), named('largest force of one step', units.force)],
      rows: summary.rigid_walls.map((w) => [w.name, figure(w.impulse, 6), figure(w.force_max, 5)])}));
  }
  if (summary.contact.method === 'none' && panels.length === 0) drop('forces');
}

function probes() {
  if (summary.probes.length === 0) return drop('probes');
  const quantityOf = (name) => name.replace(/_(xx|yy|zz|xy|yz|zx|x|y|z)$/, '');
  const unitOf = {position: units.length, displacement: units.length, velocity: units.velocity, stress: units.stress,
                  effective_stress: units.stress};
  const panels = [], rows = [];
  for (const probe of summary.probes) {
    const columns = Object.keys(probe.values);
    for (const quantity of new Set(columns.map(quantityOf))) {
      const names = columns.filter((c) => quantityOf(c) === quantity);
      panels.push(chart({title: `${probe.name}: ${words(quantity)}`, unit: unitOf[quantity], ...overTime, zero: quantity !== 'position',
        series: series(names.map((c) => `${probe.name}_${c}`), (c) => words(c.slice(probe.name.length + 1)))}));
    }
    rows.push([probe.name, `${probe.kind} ${probe.number} of ${probe.body}`, vector(probe.point)]);
  }
  fill('probes', table({caption: 'Probes', head: ['probe', 'what it watches', named('place at the start', units.length)], rows}),
    make('div', {class: 'panels'}, ...panels));
}

function steps() {
  const dt = series(['dt'], () => 'time step');
  const {min, max, limited_by: by} = summary.dt;
  const axis = axisOf(Math.max(min, max), units.time), text = (step) => `${axis.figure(step)} ${axis.unit}`.trim();
  fill('steps', make('p', {text: `Steps were at most ${text(max)} long. The shortest that was stable is ${text(min)}`
      + (by ? `; it was set by ${by}.` : '.')}));
  if (dt.length) {
    fill('steps', make('div', {class: 'panels'}, chart({title: 'Time step', unit: units.time, series: dt, ...overTime})));
  }
}

function phaseTimes() {
  const phases = Object.entries(summary.phase_seconds);
  const sum = phases.reduce((all, [, s]) => all + s, 0);
  const wall = Math.max(summary.wall_seconds ?? 0, sum);
  if (wall - sum > 0.001 * wall) phases.push(['all else', wall - sum]);
  const most = Math.max(...phases.map(([, s]) => s));
  fill('times', table({caption: `Of ${seconds(wall)} wall time`, id: 'phases', head: ['phase', 'seconds', 'share', ''],
    rows: phases.map(([name, s]) => [words(name), figure(s, 3), percent(s / wall), bar(most > 0 ? s / most : 0)]), numbers: [1, 2]}));
}

function skipped() {
  const {skipped: counts, skipped_seconds: saved} = summary;
  const rows = [
    ['element steps of elements at rest', whole(counts.resting_element_steps), saved.resting],
    ['element steps of elements that make larger steps', whole(counts.subcycled_element_steps), saved.subcycling],
    ['searches for contact', whole(counts.searches), saved.searches],
    ['element steps in contact of elements that are inside', whole(counts.inner_element_steps), saved.inner_elements],
    ['element steps of eroded elements', whole(summary.element_steps_eroded), undefined],
    ['bytes of arrays that no feature needs', whole(counts.bytes_not_stored), undefined],
  ];
  const most = Math.max(...rows.map((row) => row[2] ?? 0));
  fill('skipped', make('p', {class: 'note', text: 'Seconds saved are estimates from what the run took for the same work.'}),
    table({caption: 'Left out, with the same results', head: ['what', 'how many', 'seconds saved', ''], numbers: [1, 2],
      rows: rows.map(([what, count, s]) => [what, count, s === undefined ? '' : figure(s, 3), s ? bar(s / most) : ''])}));
}

function sceneKeys() {
  if (scene.command) {
    fill('scene_keys', make('p', {text: 'This command repeats the run:'}), make('pre', {tabindex: 0}, make('code', {text: scene.command})));
  }
  const list = table({caption: 'Every key of the scene as it was run', id: 'keys', head: ['key', 'value', 'unit', ''],
    rows: scene.keys.map(([key, value, unit, isDefault]) => [make('code', {text: key}), make('code', {text: value}), raised(unit),
      isDefault ? 'default' : ''])});
  list.querySelectorAll('tbody tr').forEach((row, i) => row.classList.toggle('default', scene.keys[i][3]));
  fill('scene_keys', filter(list, 'Search keys and values',
    [{label: 'only what is not default', keep: (row) => !row.classList.contains('default')}]), list);
  if (scene.text) {
    fill('scene_keys', make('details', {}, make('summary', {text: `The file ${scene.path}`}), make('pre', {tabindex: 0, text: scene.text})));
  }
}

function surfaceOfRun() {
  const packed = block('surface');
  if (packed === null) {
    return fill('viewer', make('p', {class: 'note', text: 'Bodies are shown here at the times of the field output (output.field_interval, '
      + 'output.field_times); without it, the first and the last state of up to 100,000 elements.'}));
  }
  showSurfaces(place('viewer'), [packed], units);
}

makePage([status, surfaceOfRun, keyFigures, warnings, converged, energies, bodies, momentum, forces, probes, steps, phaseTimes, skipped, sceneKeys], surfaceOfRun);
