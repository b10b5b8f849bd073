import { dartPath, geometryPath, label } from './brush.js';
import { anchorOf } from './geometry.js';
import { kMark } from './marks.js';
import { dotScan, fillFreeSpace } from './placed_layers.js';
import { shortName } from './words_of.js';

/// The layers of the local map, in painting order; painter as in placed_layers.js. Frame: local.

const kMostPoses = 120,
  kIdWidth_px = 26,
  kIdHeight_px = 14;
/// What was looked up in a search stays on show this long [s].
const kAfterglow_s = 1;

export function paintFreeSpace(painter) {
  const { context, palette, scene } = painter;
  fillFreeSpace(painter, scene.recording.localPose(scene.frame), -1, 0.14);
  context.globalAlpha = 0.55;
  context.strokeStyle = palette.free;
  context.lineWidth = 1;
  context.stroke();
  context.globalAlpha = 1;
}

export function paintScan(painter) {
  dotScan(painter, painter.scene.recording.localPose(painter.scene.frame), -1);
}

/// Where the robot was at the updates before.
export function paintPoses({ context, view, palette, scene: { recording, frame } }) {
  const { begin } = recording.windows[recording.window.values[frame]];
  context.fillStyle = palette.local;
  context.globalAlpha = 0.45;
  for (let f = Math.max(begin, frame - kMostPoses); f < frame; ++f)
    context.fillRect(view.x(recording.x.values[f]) - 1, view.y(recording.y.values[f]) - 1, 2, 2);
  context.globalAlpha = 1;
}

/// Candidates are thin and dotted, stable features solid; matched ones have a broad line under them and a filled disc,
/// those that the shown hypothesis calls "not on the map" a hollow one.
export function paintFeatures({ context, view, palette, marks, scene }) {
  const mapped = new Map(scene.pairs);
  const pass = (style, wanted) => {
    style();
    context.beginPath();
    scene.recording.features.forEach(scene.frame, (feature) => {
      if (wanted(feature)) geometryPath(context, view, feature.geometry);
    });
    context.stroke();
  };
  const matched = ({ id }) => mapped.get(id) >= 0;
  pass(() => setPen(context, palette.match, 7, 0.32, []), matched);
  pass(
    () => setPen(context, palette.candidate, 1.2, 1, [2, 3]),
    (feature) => !feature.stable,
  );
  pass(
    () => setPen(context, palette.local, 2.2, 1, []),
    (feature) => feature.stable && !matched(feature),
  );
  pass(
    () => setPen(context, palette.match, 2.6, 1, []),
    (feature) => feature.stable && matched(feature),
  );
  setPen(context, palette.local, 1.4, 1, []);
  scene.recording.features.forEach(scene.frame, (feature) => {
    const [x, y] = anchorOf(feature.geometry);
    marks.add(
      kMark.local_feature,
      feature.id,
      x,
      y,
      NaN,
      NaN,
      feature.stable ? 1 : 0,
      matched(feature) ? mapped.get(feature.id) : -1,
    );
    if (mapped.has(feature.id)) paintBadge(context, view.x(x), view.y(y), matched(feature), palette);
  });
}

function setPen(context, ink, width, opacity, dash) {
  context.strokeStyle = ink;
  context.lineWidth = width;
  context.globalAlpha = opacity;
  context.setLineDash(dash);
}

function paintBadge(context, x, y, matched, palette) {
  context.beginPath();
  context.arc(x, y, 3.5, 0, 2 * Math.PI);
  context.fillStyle = matched ? palette.match : palette.plot;
  context.fill();
  context.strokeStyle = matched ? palette.plot : palette.local;
  context.stroke();
}

export function paintIds({ context, view, palette, scene }) {
  context.font = `11px ${palette.font}`;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  const taken = new Set(); // no two ids on top of each other
  scene.recording.features.forEach(scene.frame, (feature) => {
    const [x, y] = anchorOf(feature.geometry);
    const cell = `${Math.round(view.x(x) / kIdWidth_px)},${Math.round(view.y(y) / kIdHeight_px)}`;
    if (!feature.stable || taken.has(cell)) return;
    taken.add(cell);
    label(context, String(feature.id), view.x(x) + 6, view.y(y) - 7, palette.text, palette.plot);
  });
}

/// Observed patterns that the last search looked up, for a moment: lines between their features, with template and number
/// of places that the index predicts.
export function paintObserved({ context, view, palette, marks, scene: { recording, frame } }) {
  const search = recording.searchFrame.values[frame];
  if (search < 0 || recording.time.values[frame] - recording.time.values[search] > kAfterglow_s) return;
  context.font = `11px ${palette.font}`;
  context.textAlign = 'center';
  (recording.searchAt(search).patterns ?? []).forEach(([template, locals, candidates], k) => {
    const places = locals
      .map((id) => recording.features.find(search, id))
      .filter(Boolean)
      .map((f) => anchorOf(f.geometry));
    if (places.length === 0) return;
    setPen(context, palette.pattern, 1.3, 1, [6, 3]);
    context.beginPath();
    places.forEach(([x, y]) => context.lineTo(view.x(x), view.y(y)));
    if (places.length > 2) context.closePath();
    context.stroke();
    const x = places.reduce((sum, p) => sum + p[0], 0) / places.length,
      y = places.reduce((sum, p) => sum + p[1], 0) / places.length;
    marks.add(kMark.observed_pattern, k, x, y);
    context.setLineDash([]);
    if (k < 4) label(context, `${shortName(template)} × ${candidates}`, view.x(x), view.y(y), palette.pattern, palette.plot);
  });
}

export function paintRobot({ context, view, palette, marks, scene: { recording, frame } }) {
  const [x, y, heading] = recording.localPose(frame);
  context.fillStyle = palette.best;
  context.strokeStyle = palette.plot;
  context.lineWidth = 1;
  context.beginPath();
  dartPath(context, view.x(x), view.y(y), heading, 17);
  context.fill();
  context.stroke();
  marks.add(kMark.robot, -1, x, y, heading);
}
