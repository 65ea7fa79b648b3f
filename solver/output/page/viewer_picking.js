'use strict';
// Which element and node of a drawing lie at a point, and what there is to say of them.

/// The foremost {element, node} at (right, up) of the camera's centre [length], or null. cut as for SurfaceDrawing.draw.
function pickedAt(surface, frame, camera, [right, up], showsBody, cut) {
  const {faces, nodes, elements} = surface, axes = camera.axes, zero = axes.map((axis) => dot(axis, camera.centre));
  const seen = [0, 1, 2].map(() => new Float64Array(nodes.count)), kept = new Float64Array(nodes.count);
  for (let i = 0; i < nodes.count; ++i) {
    const place = placeOf(surface, frame, i);
    for (let a = 0; a < 3; ++a) seen[a][i] = dot(axes[a], place) - zero[a];
    kept[i] = cut ? dot(cut.normal, place) - cut.at : 1;
  }
  const [x, y, z] = seen;
  let found = null, foremost = -Infinity;
  for (let f = 0; f < faces.count; ++f) {
    if (!faceIsThere(faces, f, frame) || !showsBody(elements.body[faces.element[f]])) continue;
    const corners = faces.corners.subarray(4 * f, 4 * f + 4);
    for (const [a, b, c] of [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]) {
      const area = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
      if (area === 0) continue;
      const v = ((right - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (up - y[a])) / area;
      const w = ((x[b] - x[a]) * (up - y[a]) - (right - x[a]) * (y[b] - y[a])) / area;
      if (v < 0 || w < 0 || v + w > 1) continue;
      const at = (values) => values[a] + v * (values[b] - values[a]) + w * (values[c] - values[a]);
      if (at(z) <= foremost || at(kept) < 0) continue;
      foremost = at(z);
      const far = (node) => (x[node] - right) ** 2 + (y[node] - up) ** 2;
      // What is seen from inside is the section of a cut: nothing of the surface is there.
      found = area < 0 ? null : {element: faces.element[f], node: [...corners].reduce((m, n) => far(n) < far(m) ? n : m)};
    }
  }
  return found;
}

/// The place in the list of a kind ("nodes", "elements") of what has this number in its file, else in the scene; -1: it is not
/// among what is seen at any time.
function placeOfNumber(list, number) {
  const found = list.number.indexOf(number);
  return found >= 0 ? found : list.place.findIndex((place, i) => place === number && list.number[i] < 0);
}

const numberOf = (list, i) => list.number[i] >= 0 ? list.number[i] : list.place[i];

/// Whether a face of a node or an element is there.
function isSeen({faces}, frame, kind, place) {
  for (let f = 0; f < faces.count; ++f) {
    if (!faceIsThere(faces, f, frame)) continue;
    if (kind === 'elements' ? faces.element[f] === place : faces.corners.subarray(4 * f, 4 * f + 4).includes(place)) return true;
  }
  return false;
}

/// A table of what is known of a node or an element at the time of a frame. fieldNames: [name, unit] of each field; run: its
/// name, if there are several.
function pickedTable(surface, frame, kind, place, fieldNames, lengthUnit, run) {
  const list = surface[kind], name = kind === 'nodes' ? 'Node' : 'Element';
  const numbered = list.number[place] >= 0 ? `in its mesh file; ${whole(list.place[place])} in the scene` : 'in the scene';
  const rows = [['number', `${numberOf(list, place)}`, numbered], ['body', surface.bodies[list.body[place]], '']];
  if (!isSeen(surface, frame, kind, place)) {
    rows.push(['at this time', 'not at the surface', '']);
  } else {
    if (kind === 'nodes') ['x', 'y', 'z'].forEach((axis, c) => rows.push([axis, figure(placeOf(surface, frame, place)[c], 5), lengthUnit]));
    surface.fields.forEach((field, f) => {
      if (field.of === kind) rows.push([fieldNames[f][0], figure(valueOf(surface, frame, f, place), 4), fieldNames[f][1]]);
    });
  }
  return table({caption: `${name} ${numberOf(list, place)} of ${surface.bodies[list.body[place]]}${run && `, ${run}`}`, id: run ? undefined : `picked_${kind}`,
                head: [name.toLowerCase(), '', ''], numbers: [1], rows});
}
