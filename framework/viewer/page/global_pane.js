import { paintGrid, paintScaleBar } from './brush.js';
import { element } from './dom.js';
import { distanceTo, anchorOf } from './geometry.js';
import * as hypothesis from './hypothesis_layers.js';
import { MapLayer, featureWords } from './map_layer.js';
import { Marks } from './marks.js';
import { Pane } from './pane.js';
import { listenToPointers } from './pan_zoom.js';
import * as placed from './placed_layers.js';
import * as track from './track_layers.js';
import { fitView, zoomed } from './view_transform.js';
import { poseWords, probabilityWords } from './words_of.js';

const kHelp =
  'Arrow keys move, plus and minus zoom, 0 fits, brackets go from hypothesis to hypothesis, semicolon and comma from object to object.';
const kReach_px = 14,
  kFeatureReach_px = 8;
const kPaintingOrder = [
  ['free', placed.paintFreeSpace],
  ['truth', track.paintTruth],
  ['trajectory', track.paintTrajectory],
  ['associations', placed.paintAssociations],
  ['features', placed.paintLocalFeatures],
  ['scan', placed.paintScan],
  ['ended', hypothesis.paintEnded],
  ['hypotheses', hypothesis.paintHypotheses],
  ['findings', hypothesis.paintFindings],
  ['labels', hypothesis.paintLabels],
];

/// The global map of one run, with hypotheses and all that they place. Frame: map.
export class GlobalPane {
  constructor(run, title, state) {
    this.run = run;
    this.state = state;
    this.pane = new Pane('global', title, kHelp, state.view);
    this.mapLayer = null;
    this.stillMarks = new Marks();
    this.marks = new Marks();
    this.stillFor = '';
    this.scene = null;
    this.paints = 0;
    this.stillContext = this.pane.still.getContext('2d');
    this.context = this.pane.moving.getContext('2d');
    this.listen();
    this.pane.tools.append(
      this.tool('+', 'Zoom in', () => this.zoom(1.4)),
      this.tool('\u2212', 'Zoom out', () => this.zoom(1 / 1.4)),
      this.tool('Fit', 'Fit the map into the pane', () => this.fit()),
    );
  }

  get root() {
    return this.pane.root;
  }
  get transform() {
    return this.pane.transform;
  }

  tool(words, help, act) {
    return element('button', { type: 'button', class: 'tool', text: words, title: help, 'aria-label': help, onclick: act });
  }

  setMap(map) {
    if (this.mapLayer?.map === map) return;
    this.mapLayer = new MapLayer(map);
    this.stillFor = '';
    this.offerStoreys(map.storeys);
  }

  /// A map that holds several storeys is looked at sheet by sheet.
  offerStoreys(storeys) {
    this.storeyChoice?.remove();
    this.storeyChoice = null;
    if (storeys.length === 0) return;
    const options = [{ id: '', name: 'All storeys' }, ...storeys].map(({ id, name }) => element('option', { value: id, text: name }));
    this.storeyChoice = element('select', { class: 'tool storeys', title: 'Look at one storey', 'aria-label': 'Storey' });
    this.storeyChoice.append(...options);
    this.storeyChoice.addEventListener('change', () => this.showStorey(this.storeyChoice.value));
    this.pane.tools.prepend(this.storeyChoice);
  }

  showStorey(id) {
    const storey = this.mapLayer.map.storeys.find((one) => one.id === id);
    if (!storey) return this.fit();
    this.state.set({ follow: false });
    this.pane.resize();
    this.look({ ...fitView(storey.bounds, this.transform.width, this.transform.height), auto: false });
  }

  fit() {
    if (!this.mapLayer) return;
    this.pane.resize();
    this.look(this.fitted());
  }

  fitted() {
    return fitView(this.mapLayer.map.bounds, this.transform.width, this.transform.height);
  }

  look(view) {
    this.state.set({ view });
  }

  zoom(factor, x = this.transform.width / 2, y = this.transform.height / 2) {
    this.look(zoomed(this.transform, factor, x, y));
  }

  move(dx_px, dy_px) {
    const { view } = this.state;
    this.state.set({ follow: false });
    this.look({ ...view, x: view.x - dx_px / view.scale, y: view.y + dy_px / view.scale, auto: false });
  }

  listen() {
    listenToPointers(this.pane.moving, {
      pan: (dx, dy) => this.move(dx, dy),
      zoom: (factor, x, y) => this.zoom(factor, x, y),
      click: (x, y) => this.pick(x, y),
      hover: (x, y) => this.hover(x, y),
      leave: () => this.pane.showTip('', 0, 0),
    });
  }

  /// The hypothesis at a place of the pane, or -1.
  hypothesisAt(x, y) {
    if (!this.scene || !this.state.layers.has('hypotheses')) return -1;
    const { recording, frame } = this.scene,
      { rows } = recording,
      t = this.transform;
    let found = -1,
      least = kReach_px;
    const consider = (id, mx, my, bonus) => {
      const distance = Math.hypot(t.x(mx) - x, t.y(my) - y) - bonus;
      if (distance < least) [least, found] = [distance, id];
    };
    for (let row = rows.begin(frame); row < rows.end(frame); ++row)
      consider(rows.id.values[row], rows.x.values[row], rows.y.values[row], 3 * rows.probability.values[row]);
    if (this.state.layers.has('ended'))
      for (const { id, end } of recording.endedAt(frame)) consider(id, end.pose[0], end.pose[1], 0);
    return found;
  }

  featureAt(x, y) {
    if (!this.mapLayer || !this.state.layers.has('objects')) return -1;
    const t = this.transform;
    return this.mapLayer.at(t.mapX(x), t.mapY(y), kFeatureReach_px / t.scale, this.state.layers, distanceTo);
  }

  pick(x, y) {
    const id = this.hypothesisAt(x, y);
    if (id >= 0) return this.state.set({ run: this.run, selected: id });
    const feature = this.featureAt(x, y);
    this.state.set({ object: feature });
    this.pane.showTip(feature < 0 ? '' : featureWords(this.mapLayer.map, feature), x, y);
  }

  hover(x, y) {
    const id = this.hypothesisAt(x, y);
    if (id >= 0) return this.pane.showTip(this.hypothesisWords(id), x, y);
    const finding = this.findingAt(x, y);
    if (finding) return this.pane.showTip(finding.words, x, y);
    const feature = this.featureAt(x, y);
    this.pane.showTip(feature < 0 ? '' : featureWords(this.mapLayer.map, feature), x, y);
  }

  findingAt(x, y) {
    if (!this.scene || !this.state.layers.has('findings')) return null;
    const t = this.transform,
      place = [t.mapX(x), t.mapY(y)],
      within_m = kFeatureReach_px / t.scale;
    return hypothesis
      .findingsOfScene(this.scene)
      .findings.find(({ line }) => line.length === 4 && distanceTo({ kind: 'segment', numbers: line }, ...place) < within_m);
  }

  hypothesisWords(id) {
    const { recording, frame } = this.scene,
      row = recording.rows.find(frame, id);
    const state =
      row >= 0
        ? `probability ${probabilityWords(recording.rows.probability.values[row])}`
        : `ended: ${recording.hypotheses.byId.get(id)?.end?.reason ?? ''}`;
    return `Hypothesis #${id}\n${state}\n${poseWords(recording.poseAt(frame, id))}`;
  }

  /// Moves the view to a mapped feature and says what it is: what hovering is to the mouse.
  showFeature(number) {
    const feature = this.mapLayer?.map.features[number];
    if (!feature) return;
    const [x, y] = anchorOf(feature.geometry),
      t = this.transform;
    if (t.x(x) < 0 || t.x(x) > t.width || t.y(y) < 0 || t.y(y) > t.height) this.look({ ...this.state.view, x, y, auto: false });
    this.pane.transform.view = this.state.view;
    this.pane.showTip(featureWords(this.mapLayer.map, number), t.x(x), t.y(y));
  }

  /// Paints a scene, or the bare map if there is none at this moment.
  paint(scene, palette, theme) {
    this.scene = scene;
    const resized = this.pane.resize();
    if (resized && this.state.view.auto && this.run === 0 && this.mapLayer) this.state.view = this.fitted();
    this.transform.view = this.state.view;
    const { view, layers } = this.state;
    const stillFor = [view.x, view.y, view.scale, theme, [...layers].join()].join();
    if (resized || stillFor !== this.stillFor) this.paintStill(palette, stillFor);
    this.pane.clear(this.pane.moving, this.context);
    this.marks.clear();
    if (scene) this.paintMoving(scene, palette);
    this.paints += 1;
  }

  paintStill(palette, stillFor) {
    this.pane.clear(this.pane.still, this.stillContext);
    paintGrid(this.stillContext, this.transform, palette.grid);
    this.mapLayer?.paint(this.stillContext, this.transform, palette, this.state.layers, this.stillMarks);
    paintScaleBar(this.stillContext, this.transform, palette);
    this.stillFor = stillFor;
  }

  paintMoving(scene, palette) {
    const painter = { context: this.context, view: this.transform, palette, marks: this.marks, scene, state: this.state };
    placed.paintPicked(painter);
    for (const [name, paint] of kPaintingOrder) if (this.state.layers.has(name)) paint(painter);
    hypothesis.paintSelected(painter);
  }

  drawn() {
    return [...this.stillMarks.list(), ...this.marks.list()];
  }
}
