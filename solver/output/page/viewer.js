'use strict';
// The bodies of a run, to be turned, cut and played; tied to the curves, which show the same time.

const fieldLabels = {von_mises: 'von Mises stress', plastic_strain: 'effective plastic strain'};

class Viewer {
  frame = 0;
  field = -1;       ///< index; -1: bodies by their colours
  hidden = new Set();
  camera = new ViewerCamera();
  cut = {axis: '', at: 0, other: false};  ///< at: along the axis [length]
  picked = null;    ///< {element, node}, either of them -1
  lit = true;
  edges = true;
  timer = null;
  followers = [];   ///< viewers of other runs beside this one

  /// places: {tools, stage, facts}; surface: as of unpackedSurface; leader: the viewer whose tools, camera and cut this one
  /// follows, null: it has its own; name: of what is seen, if there are several. Throws where WebGL 2 is not there.
  constructor(places, surface, units, leader = null, name = '') {
    Object.assign(this, {places, surface, units, leader, name});
    if (leader) [this.camera, this.cut, this.hidden] = [leader.camera, leader.cut, leader.hidden];
    const unitOf = {velocity: units.velocity, displacement: units.length, contact_force: units.force, von_mises: units.stress,
                    pressure: units.stress, pinball_radius: units.length};
    this.fieldNames = surface.fields.map(({name}) => [fieldLabels[name] ?? words(name), unitOf[name] ?? '']);
    const all = surface.times.map((_, k) => k), axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    this.box = boxOf(surface, axes, all, () => true);
    this.middle = this.box.map(([low, high]) => 0.5 * (low + high));
    this.reach = Math.hypot(...this.box.map(([low, high]) => high - low));
    this.timeAxis = axisOf(largestOf(surface.times), units.time);
    this.canvas = make('canvas', {tabindex: 0, role: 'img', 'aria-label': 'The bodies. Arrow keys turn, with shift move, + and - zoom, '
      + '1 to 7 are standard views, space plays, comma and full stop step through time, f fits, r resets.'});
    const begin = () => new SurfaceDrawing(this.canvas, surface, this.middle, (body) => redGreenBlue(bodyColour(body)));
    this.drawing = begin();
    this.canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    this.canvas.addEventListener('webglcontextrestored', () => {
      this.drawing = begin();
      this.drawing.isShown = this.isShown;
      this.chooseField(this.field);
    });
    this.build();
    this.listen();
    this.field = this.defaultField();
    this.frame = surface.times.length - 1;
    leader?.followers.push(this);
    this.chooseField(leader ? this.ownField(leader) : this.field);
    if (!leader) this.reset();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /// As `pinball view` chooses: plastic strain where there is any, else stress, else motion.
  defaultField() {
    const find = (name) => this.surface.fields.findIndex((field) => field.name === name && (name !== 'plastic_strain' || !field.zero));
    return ['plastic_strain', 'von_mises', 'velocity'].map(find).find((f) => f >= 0) ?? -1;
  }

  build() {
    const {surface} = this, button = (text, title, onclick) => make('button', {type: 'button', text, title, onclick});
    this.fieldChoice = make('select', {'aria-label': 'field', onchange: () => this.chooseField(Number(this.fieldChoice.value))},
      ...surface.fields.map((_, f) => make('option', {value: f, text: this.fieldNames[f][0]})), make('option', {value: -1, text: 'bodies'}));
    const edges = make('input', {type: 'checkbox', checked: true, onchange: () => { this.edges = edges.checked; this.draw(); }});
    const views = make('div', {class: 'buttons', role: 'group', 'aria-label': 'standard views'},
      ...Object.keys(standardViews).map((name, i) => button(name, `view: key ${i + 1}`, () => this.look(name))),
      button('+', 'zoom in: key +', () => this.zoom(1.25)), button('−', 'zoom out: key -', () => this.zoom(0.8)),
      button('fit', 'what is there at this time: key f', () => this.fit()), button('reset', 'all of the bodies, nothing cut or hidden: key r', () => this.reset()));
    this.bar = make('div', {class: 'colour_bar'});
    this.axes = svg('svg', {class: 'axes', viewBox: '-34 -34 68 68', width: 76, height: 76, 'aria-hidden': 'true'});
    this.measure = make('div', {class: 'measure', 'aria-hidden': 'true'}, make('div'), make('span'));
    this.marker = make('div', {class: 'marker', hidden: true});
    this.title = make('p', {class: 'title', 'aria-live': 'off'});
    this.stage = make('div', {class: 'surface'}, make('div', {class: 'drawing'}, this.canvas, this.title, this.axes, this.measure, this.marker), this.bar);
    this.slider = make('input', {type: 'range', min: 0, max: surface.times.length - 1, value: 0, 'aria-label': 'time',
                                 oninput: () => { this.pause(); this.step(Number(this.slider.value)); }});
    this.playButton = button('Play', 'key: space', () => this.play());
    const one = surface.times.length === 1;
    this.player = make('div', {class: 'player', hidden: one}, this.playButton, this.slider);
    this.facts = make('div', {class: 'picked'});
    const {tools, stage, facts} = this.places;
    stage.append(this.stage);
    facts.append(this.facts);
    if (this.leader) return;
    tools.append(make('div', {class: 'tools'}, make('label', {}, 'Colours: ', this.fieldChoice), make('label', {}, edges, ' edges of elements'), views));
    facts.before(this.player, make('div', {class: 'tools'}, this.cutTools(), this.findTools()), this.bodyLegend());
    facts.after(this.hint());
  }

  hint() {
    const {times, all_times: all} = this.surface, fewer = times.length < all
      ? ` ${whole(times.length)} of ${whole(all)} output times are here; the files have all.` : '';
    return make('p', {class: 'note', text: 'Drag to turn, with shift or the right button to move; the wheel zooms once the picture has been '
      + 'clicked, or with ctrl. A click picks the element and the node under the pointer. Keys: arrows turn, with shift they move, + and − zoom, 1 to 7 are '
      + 'the standard views, space plays, comma and full stop step through time, f fits what is there, r resets. Where a body is cut its inside is hatched: '
      + `only surfaces are here, pinball view --cut draws what is inside.${fewer}`});
  }

  cutTools() {
    const axis = make('select', {'aria-label': 'cut', onchange: () => this.cutAlong(axis.value)},
      ...[['', 'nothing cut'], ['x', 'cut at x'], ['y', 'cut at y'], ['z', 'cut at z'], ['view', 'cut towards you']].map(([value, text]) => make('option', {value, text})));
    const slider = make('input', {type: 'range', step: 'any', 'aria-label': 'place of the cut', oninput: () => { this.cut.at = Number(slider.value); update(); }});
    const other = make('input', {type: 'checkbox', onchange: () => { this.cut.other = other.checked; update(); }});
    const label = make('output', {class: 'note'}), more = make('span', {class: 'cut'}, slider, label, make('label', {}, other, ' other side'));
    const update = this.updateCut = () => {
      const {axis: name, at} = this.cut, [low, high] = this.cutRange();
      Object.assign(slider, {min: low, max: high, value: at});
      [axis.value, other.checked, more.hidden] = [name, this.cut.other, name === ''];
      label.textContent = name === 'view' ? '' : `${name} = ${figure(at, 4)} ${this.units.length}`.trim();
      this.draw();
    };
    return make('span', {class: 'cut'}, axis, more);
  }

  findTools() {
    const kind = make('select', {'aria-label': 'kind'}, make('option', {value: 'elements', text: 'element'}), make('option', {value: 'nodes', text: 'node'}));
    const number = make('input', {type: 'number', min: 0, step: 1, 'aria-label': 'number', placeholder: 'number'});
    const told = make('output', {class: 'note'});
    return make('form', {class: 'find', onsubmit: (event) => {
      event.preventDefault();
      let none = true;
      for (const one of this.all) {
        const found = number.value === '' ? -1 : placeOfNumber(one.surface[kind.value], Number(number.value));
        none &&= found < 0;
        one.pick(found < 0 ? null : kind.value === 'elements' ? {element: found, node: -1} : {element: -1, node: found});
      }
      told.textContent = none ? `no ${kind.value.slice(0, -1)} ${number.value} at a surface` : '';
    }}, kind, number, make('button', {type: 'submit', text: 'Find'}), told);
  }

  bodyLegend() {
    this.bodyButtons = this.surface.bodies.map((name, b) => make('button', {type: 'button', 'aria-pressed': 'true', title: 'show or hide', onclick: () => {
      if (!this.hidden.delete(b)) this.hidden.add(b);
      this.showBodies();
    }}, make('span', {class: 'swatch', style: `background:${bodyColour(b)}`}), make('span', {text: name})));
    return make('ul', {class: 'legend bodies', 'aria-label': 'bodies'}, ...this.bodyButtons.map((b) => make('li', {}, b)));
  }

  // ---- What is shown ----

  isShown = (body) => !this.hidden.has(body);
  get all() { return [this, ...this.followers]; }

  showBodies() {
    this.bodyButtons.forEach((button, b) => button.setAttribute('aria-pressed', this.isShown(b)));
    for (const one of this.all) one.drawing.showBodies(one.isShown);
    this.draw();
  }

  /// The field of the same name as another viewer's.
  ownField({surface, field}) { return this.surface.fields.findIndex(({name}) => name === surface.fields[field]?.name); }

  chooseField(f) {
    [this.field, this.fieldChoice.value] = [f, f];
    for (const one of this.followers) one.chooseField(one.ownField(this));
    const field = this.surface.fields[f] ?? null;
    this.drawing.showColours(tables[field?.signed ?? false]);
    fillColourBar(this.bar, field, ...(this.fieldNames[f] ?? ['', '']));
    this.showFrame(this.frame);
  }

  showFrame(frame) {
    this.frame = frame;
    this.slider.value = frame;
    const time = `t = ${this.timeAxis.figure(this.surface.times[frame], 4)} ${this.timeAxis.unit}`.trim();
    const codes = this.surface.frames[frame].fields[this.field], none = codes?.every((code) => code === noValue);
    this.title.textContent = [this.name, time, none ? 'no values at this time' : ''].filter(Boolean).join(', ');
    this.slider.setAttribute('aria-valuetext', time);
    this.drawing.showFrame(frame, this.field);
    this.tellPicked();
    this.draw();
  }

  /// A frame, and its time in all curves.
  step(frame) {
    const within = Math.min(this.surface.times.length - 1, Math.max(0, frame));
    this.showFrame(within);
    select(this.surface.times[within], this);
  }

  // As one of the charts (curves.js).
  show(time, own) {
    if (own) return;
    const frame = nearest(this.surface.times, time);
    if (frame !== this.frame) this.showFrame(frame);
  }

  play() {
    if (this.timer) return this.pause();
    const last = this.surface.times.length - 1;
    this.playButton.textContent = 'Pause';
    if (this.frame === last) this.step(0);
    this.timer = setInterval(() => {
      this.step(this.frame + 1);
      if (this.frame === last) this.pause();
    }, Math.min(250, Math.max(40, 5000 / (last + 1))));
  }

  pause() {
    clearInterval(this.timer);
    this.timer = null;
    this.playButton.textContent = 'Play';
  }

  // ---- Camera ----

  get aspect() { return this.canvas.clientWidth / this.canvas.clientHeight || 1; }

  zoom(factor) {
    this.camera.zoom(factor);
    this.draw();
  }

  /// From where it stands: all that is there at any time.
  look(name) {
    [this.camera.azimuth, this.camera.elevation] = standardViews[name];
    this.fit(({times}) => times.map((_, k) => k));
  }

  /// All that is shown at some times of each surface; else at the time that it shows.
  fit(framesOf = null) {
    const boxes = this.all.map(({surface, frame}) => boxOf(surface, this.camera.axes, framesOf ? framesOf(surface) : [frame], this.isShown));
    const box = boxes[0].map((_, a) => [Math.min(...boxes.map((b) => b[a][0])), Math.max(...boxes.map((b) => b[a][1]))]);
    if (Number.isFinite(box[0][0])) this.camera.fit(box, this.aspect);
    this.draw();
  }

  reset() {
    this.hidden.clear();
    this.cutAlong('');
    this.showBodies();
    this.look('iso');
  }

  get cutNormal() {
    const {axis} = this.cut;
    return axis === 'view' ? this.camera.axes[2].map((c) => -c) : ['x', 'y', 'z'].map((name) => name === axis ? 1 : 0);
  }

  /// Between which places there is something to cut; towards the viewer all around the middle.
  cutRange() {
    const {axis} = this.cut, middle = dot(this.cutNormal, this.middle);
    return axis === 'view' || axis === '' ? [middle - 0.5 * this.reach, middle + 0.5 * this.reach] : this.box[['x', 'y', 'z'].indexOf(axis)];
  }

  /// Begins in the middle of what is seen now, and takes away the side of the viewer.
  cutAlong(axis) {
    this.cut.axis = axis;
    this.cut.other = axis !== 'view' && dot(this.cutNormal, this.camera.axes[2]) > 0;
    const [[low, high]] = boxOf(this.surface, [this.cutNormal], [this.frame], this.isShown);
    this.cut.at = low <= high ? 0.5 * (low + high) : dot(this.cutNormal, this.middle);
    this.updateCut();
  }

  /// {normal, at}: kept is what has place . normal >= at; null: nothing is cut.
  cutPlane() {
    const {axis, at, other} = this.cut, sign = other ? -1 : 1;
    return axis === '' ? null : {normal: this.cutNormal.map((c) => sign * c), at: sign * at};
  }

  // ---- Picking ----

  pick(picked) {
    this.picked = picked;
    this.tellPicked();
    this.draw();
  }

  tellPicked() {
    const {picked, surface} = this, tables = [];
    if (picked) {
      for (const [kind, place] of [['elements', picked.element], ['nodes', picked.node]]) {
        if (place >= 0) tables.push(pickedTable(surface, this.frame, kind, place, this.fieldNames, this.units.length, this.name));
      }
    }
    this.facts.replaceChildren(...tables);
  }

  /// [right, up] of the middle of the picture, in parts of its height.
  partsOf(event) {
    const {left, top, width, height} = this.canvas.getBoundingClientRect();
    return [(event.clientX - left - 0.5 * width) / height, (0.5 * height + top - event.clientY) / height];
  }

  pickAt(event) {
    const parts = this.partsOf(event).map((p) => p * this.camera.height);
    this.pick(pickedAt(this.surface, this.frame, this.camera, parts, this.isShown, this.cutPlane()));
  }

  // ---- Drawing ----

  /// With the next picture of the browser, once, however often it is called; all that are beside each other.
  draw() {
    if (this.leader) return this.leader.draw();
    for (const one of this.all) one.wait();
  }

  wait() {
    this.waiting ??= requestAnimationFrame(() => {
      this.waiting = undefined;
      this.drawNow();
    });
  }

  drawNow() {
    const {canvas, camera} = this, ratio = window.devicePixelRatio || 1;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((pixels) => Math.max(1, Math.round(ratio * pixels)));
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    const depth = 0.51 * this.reach + Math.hypot(...camera.centre.map((c, i) => c - this.middle[i])) || 1;
    const accent = redGreenBlue(dark.matches ? '#56b4e9' : '#0072b2').map((c) => c / 255);
    this.drawing.draw(camera, {cut: this.cutPlane(), edges: (this.leader ?? this).edges ? Math.max(1, 0.8 * ratio) : 0, depth, chosen: this.picked?.element ?? -1,
                               accent, lit: this.lit});
    drawAxes(this.axes, camera);
    drawMeasure(this.measure, camera, canvas.clientHeight, this.units.length);
    this.drawMarker();
  }

  drawMarker() {
    const node = this.picked?.node ?? -1, {camera, canvas, surface} = this;
    this.marker.hidden = node < 0 || !this.isShown(surface.nodes.body[node]) || !isSeen(surface, this.frame, 'nodes', node);
    if (this.marker.hidden) return;
    const place = placeOf(surface, this.frame, node).map((c, i) => c - camera.centre[i]), [right, up] = camera.axes;
    const parts = [dot(right, place), dot(up, place)].map((p) => p / camera.height);
    this.marker.style.left = `${canvas.clientWidth / 2 + parts[0] * canvas.clientHeight}px`;
    this.marker.style.top = `${canvas.clientHeight / 2 - parts[1] * canvas.clientHeight}px`;
  }
}
