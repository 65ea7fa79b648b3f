'use strict';
// The energies of a run: each by its name, whether they add up, and what is wrong where they do not.

const energyNames = {
  kinetic: 'of motion', internal: 'work of the stresses: elastic and plastic', hourglass: 'work of hourglass forces',
  bulk_viscosity: 'work of bulk viscosity', folding: 'stored by corners of elements that are about to turn over',
  contact_stored: 'in the springs of contact',
  contact_damped: 'taken by contact: damping, impulses, friction', eroded: 'gone with eroded elements',
  external: 'work done from outside, by walls, pressures, gravity and prescribed motion'};

/// Who makes energy, or lets the balance go astray, is named in red with what to try.
function energyChecks(checks) {
  const verdict = ({warning}) => warning === null ? make('span', {class: 'done', text: 'sound'})
      : make('span', {class: 'failed', text: 'not sound'});
  const advised = checks.some((c) => c.warning !== null);  // else there is nothing to try
  return table({caption: 'Whether the energies can be trusted', id: 'energy_checks', numbers: [1, 2],
    head: ['what', 'largest', 'sound up to', 'verdict', ...(advised ? ['what happened, and what to try'] : [])],
    rows: checks.map((c) => [c.what, percent(c.share), percent(c.bound), verdict(c),
      ...(advised ? [make('span', {class: 'bad', text: c.warning ?? ''})] : [])])});
}

/// Each energy at the start and the end, and the sum that is kept: all less the work from outside.
function energyTable(e, unit, valuesOf) {
  const present = Object.keys(energyNames).filter((name) => e[name] !== 0 || largestOf(valuesOf(name) ?? []) > 0);
  const all = e.final_total + e.external;  // what the energies are shares of
  const row = (name, note, start, end, largest) => [words(name), figure(start, 5), figure(end, 5), figure(largest, 5),
    all > 0 && end !== null ? percent(end / all) : '–', note];
  const largestOver = (values, end) => values.reduce((m, v) => isNumber(v) && Math.abs(v) > Math.abs(m) ? v : m, end);
  const of = (name, note) => {
    const values = valuesOf(name) ?? [];
    return row(name, note, values.length > 0 ? values[0] : null, e[name], largestOver(values, e[name]));
  };
  const rows = present.map((name) => of(name, energyNames[name]));
  rows.push(row('total', 'all of them, less the work from outside: it has to stay', e.initial_total, e.final_total,
                largestOver([e.initial_total, ...(valuesOf('total') ?? [])], e.final_total)));
  const least = Object.keys(energyNames).filter((name) => !present.includes(name));
  return [table({caption: named('Energies', unit), id: 'energy_table', numbers: [1, 2, 3, 4],
                 head: ['energy', 'at the start', 'at the end', 'largest', 'share at the end', 'what it is'], rows}),
          least.length === 0 ? '' : make('p', {class: 'note', text: `Zero throughout: ${least.map(words).join(', ')}.`})];
}

function energies() {
  const names = Object.keys(energyNames), e = summary.energy;
  const error = series(['balance_error'], () => 'balance error').map((curve) => chart({
    title: 'Error of the balance, of the initial total', unit: '%', ...overTime,
    series: [{...curve, values: curve.values.map((v) => v === null ? null : 100 * v)}]}));
  fill('energies', energyChecks(block('checks')), ...energyTable(e, units.energy, column));
  const [panels] = panelsBySize({title: 'Energy', small: 'Small energies', unit: units.energy, more: error,
                                 series: [...series(names), ...series(['total'])], ...overTime});
  fill('energies', panels);
}
