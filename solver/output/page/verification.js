'use strict';
// The page of `pinball verify`: every row against its reference, and how much of its tolerance its error takes.

const {version, rows} = block('verification');
const fill = (id, ...children) => document.getElementById(id).append(...children);
// A row that does not pass may have an error that is no number.
const share = (row) => row.error === null ? Infinity : row.tolerance > 0 ? row.error / row.tolerance : row.error > 0 ? Infinity : 0;
const shareText = (s) => Number.isFinite(s) ? figure(s, 2) : '–';
const verdict = (pass) => make('span', {class: pass ? 'pass' : 'FAIL', text: pass ? 'pass' : 'FAIL'});

const failed = rows.filter((row) => !row.pass);
const scenes = [...new Set(rows.map((row) => row.scene))];
fill('figures', ...[['rows', whole(rows.length)], ['pass', whole(rows.length - failed.length)], ['fail', whole(failed.length)],
  ['scenes', whole(scenes.length)], ['largest error over tolerance', shareText(Math.max(...rows.map(share)))], ['version', version]]
  .map(([name, value]) => make('div', {class: 'figure'}, make('div', {class: 'name', text: name}), make('div', {class: 'value', text: value}))));

fill('scenes', table({caption: 'The largest error of each scene, over its tolerance', id: 'scene_table', numbers: [1, 2, 3],
  head: ['scene', 'rows', 'pass', 'error / tolerance', ''],
  rows: scenes.map((scene) => {
    const own = rows.filter((row) => row.scene === scene), worst = Math.max(...own.map(share));
    return [scene, whole(own.length), whole(own.filter((row) => row.pass).length), shareText(worst), bar(worst, worst > 1)];
  })}));

const list = table({caption: 'Errors are relative to the reference where that is not zero; bars show error over tolerance',
  id: 'row_table', numbers: [2, 3, 4, 5], head: ['scene', 'quantity', 'value', 'reference', 'error', 'tolerance', 'error / tolerance', 'result', 'source'],
  rows: rows.map((row) => [row.scene, raised(row.quantity), figure(row.value, 6), figure(row.reference, 6), figure(row.error, 3),
    figure(row.tolerance, 2), make('div', {}, shareText(share(row)), bar(share(row), !row.pass)), verdict(row.pass), row.source])});
fill('rows', filter(list, 'Search scenes, quantities, sources', [
  {label: 'only what fails', keep: (row) => row.querySelector('.FAIL') !== null},
  {label: 'only errors above half of the tolerance', keep: (row) => share(rows[[...row.parentNode.children].indexOf(row)]) > 0.5},
]), list);
