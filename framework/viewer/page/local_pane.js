import { paintGrid, paintScaleBar } from './brush.js';
import { element } from './dom.js';
import { distanceTo } from './geometry.js';
import * as layer from './local_layers.js';
import { Marks } from './marks.js';
import { Pane } from './pane.js';
import { listenToPointers } from './pan_zoom.js';
import { clampScale } from './view_transform.js';
import { shortName } from './words_of.js';

const kHelp = 'Plus and minus zoom; the robot stays in the middle.';
const kReach_px = 9,
  kLeastRadius_m = 3,
  kShownPart = 0.9;

const kPaintingOrder = [
  ['free', layer.paintFreeSpace],
  ['trajectory', layer.paintPoses],
  ['scan', layer.paintScan],
  ['observed', layer.paintObserved],
  ['features', layer.paintFeatures],
  ['features', layer.paintIds],
];

/// The local map of one run, with the robot in the middle. Frame: local.
export class LocalPane {
  constructor(run, title, state) {
    this.run = run;
    this.state = state;
    this.pane = new Pane('local', title, kHelp, { x: 0, y: 0, scale: 20 });
    this.marks = new Marks();
    this.scene = null;
    this.radius_m = kLeastRadius_m;
    this.context = this.pane.moving.getContext('2d');
    listenToPointers(this.pane.moving, {
      pan: () => {},
      zoom: (factor) => this.zoom(factor),
      click: (x, y) => this.hover(x, y),
      hover: (x, y) => this.hover(x, y),
      leave: () => this.pane.showTip('', 0, 0),
    });
    const tool = (words, help, act) =>
      element('button', {
        type: 'button',
        class: 'tool',
        text: words,
        title: help,
        'aria-label': `Local map: ${help}`,
        onclick: act,
      });
    this.pane.tools.append(
      tool('+', 'zoom in', () => this.zoom(1.4)),
      tool('\u2212', 'zoom out', () => this.zoom(1 / 1.4)),
      tool('Fit', 'fit', () => state.set({ localScale: 0 })),
    );
  }

  get root() {
    return this.pane.root;
  }

  zoom(factor) {
    this.state.set({ localScale: clampScale(this.pane.transform.scale * factor) });
  }

  hover(x_px, y_px) {
    if (!this.scene) return;
    const t = this.pane.transform,
      x = t.mapX(x_px),
      y = t.mapY(y_px);
    let found = null,
      least = kReach_px / t.scale;
    this.scene.recording.features.forEach(this.scene.frame, (feature) => {
      const distance_m = distanceTo(feature.geometry, x, y);
      if (distance_m < least) [least, found] = [distance_m, feature];
    });
    this.pane.showTip(found ? this.wordsOf(found) : '', x_px, y_px);
  }

  wordsOf(feature) {
    const pair = this.scene.pairs.find(([local]) => local === feature.id);
    const taken = pair ? `\ntaken for ${this.scene.recording.map.nameOf(pair[1])}` : '';
    return (
      `Local feature ${feature.id} · ${shortName(feature.type)}\n${feature.stable ? 'stable' : 'candidate'}, ` +
      `${feature.measurements} measurements${taken}`
    );
  }

  paint(scene, palette) {
    this.scene = scene;
    this.pane.resize();
    this.pane.clear(this.pane.moving, this.context);
    this.marks.clear();
    if (!scene) return;
    const t = this.pane.transform,
      [x, y] = scene.recording.localPose(scene.frame);
    t.view.x = x;
    t.view.y = y;
    t.view.scale = this.state.localScale || this.fittingScale(scene);
    paintGrid(this.context, t, palette.grid);
    const painter = { context: this.context, view: t, palette, marks: this.marks, scene, state: this.state };
    for (const [name, paint] of kPaintingOrder) if (this.state.layers.has(name)) paint(painter);
    layer.paintRobot(painter);
    paintScaleBar(this.context, t, palette);
  }

  /// So that nine tenths of the scan fit; the radius only grows within a time line, for a calm picture.
  fittingScale({ recording, frame }) {
    const window = recording.window.values[frame];
    if (this.radiusFor !== window || this.radiusOf !== recording)
      [this.radiusFor, this.radiusOf, this.radius_m] = [window, recording, kLeastRadius_m];
    const { scan } = recording,
      xy = scan.xy.values,
      ranges = [];
    for (let k = scan.begin(frame); k < scan.end(frame); k += 2) ranges.push(Math.hypot(xy[k], xy[k + 1]));
    ranges.sort((a, b) => a - b);
    if (ranges.length > 0) this.radius_m = Math.max(this.radius_m, 1.1 * ranges[Math.floor(kShownPart * (ranges.length - 1))]);
    const t = this.pane.transform;
    return clampScale((Math.min(t.width, t.height) / 2 - 10) / this.radius_m);
  }

  drawn() {
    return this.marks.list();
  }
}
