import { crossPath, dartPath, geometryPath, label } from './brush.js';
import { anchorOf, nearestOn } from './geometry.js';
import { kMark } from './marks.js';
import { transformPoint } from './pose.js';
import { probabilityWords } from './words_of.js';

/// The layers of the global map that change with time, in painting order. Each takes the pane's painter: `{context, view,
/// palette, marks, scene, state}`.

const kBest_px = 17, kScanDot_px = 2, kMatched_px = 7, kLocalFeature_px = 2.2;
const kLabels = 6, kJump_m = 1, kMinStep_px = 1.5;
/// What has ended or was refused stays on show this long [s].
export const kAfterglow_s = 1;

/// The more probable, the larger and the more opaque, as in the static pictures.
export const rivalSize_px = (probability) => 9 + 6 * Math.sqrt(Math.min(1, Math.max(0, probability)));
const rivalOpacity = (probability) => 0.42 + 0.58 * Math.sqrt(Math.min(1, Math.max(0, probability)));

export function paintFreeSpace({ context, view, palette, marks, scene }) {
  const { free } = scene.recording, T = scene.T_map_base;
  const begin = free.begin(scene.frame), end = free.end(scene.frame);
  if (!T || end - begin < 6) return;
  const c = Math.cos(T[2]), s = Math.sin(T[2]), xy = free.xy.values;
  context.beginPath();
  for (let k = begin; k < end; k += 2) {
    const x = T[0] + c * xy[k] - s * xy[k + 1], y = T[1] + s * xy[k] + c * xy[k + 1];
    context.lineTo(view.x(x), view.y(y));
    marks.add(kMark.free_space, scene.shown, x, y);
  }
  context.closePath();
  context.fillStyle = palette.free;
  context.globalAlpha = 0.15;
  context.fill();
  context.globalAlpha = 1;
}

export function paintScan({ context, view, palette, marks, scene }) {
  const { scan } = scene.recording, T = scene.T_map_base;
  if (!T) return;
  const c = Math.cos(T[2]), s = Math.sin(T[2]), xy = scan.xy.values;
  context.fillStyle = palette.scan;
  for (let k = scan.begin(scene.frame), end = scan.end(scene.frame); k < end; k += 2) {
    const x = T[0] + c * xy[k] - s * xy[k + 1], y = T[1] + s * xy[k] + c * xy[k + 1];
    context.fillRect(view.x(x) - kScanDot_px / 2, view.y(y) - kScanDot_px / 2, kScanDot_px, kScanDot_px);
    marks.add(kMark.scan, scene.shown, x, y);
  }
}

/// A line through the places that `placeOf(frame)` gives, up to now; broken where it jumps. Returns nothing; `out` is reused.
function paintTrack({ context, view, marks, scene }, kind, placeOf) {
  const { recording, frame } = scene, out = [0, 0];
  const { begin } = recording.windows[recording.window.values[frame]];
  let drawn = false, lastX = 0, lastY = 0, mapX = 0, mapY = 0;
  context.beginPath();
  for (let f = begin; f <= frame; ++f) {
    if (!placeOf(f, out)) {
      drawn = false;
      continue;
    }
    const x = view.x(out[0]), y = view.y(out[1]);
    const jump = drawn && Math.hypot(out[0] - mapX, out[1] - mapY) > kJump_m;
    mapX = out[0];
    mapY = out[1];
    if (!drawn || jump) context.moveTo(x, y);
    else if (f < frame && Math.abs(x - lastX) + Math.abs(y - lastY) < kMinStep_px) continue;
    else context.lineTo(x, y);
    drawn = true;
    lastX = x;
    lastY = y;
  }
  context.stroke();
  if (drawn) marks.add(kind, -1, mapX, mapY);
}

export function paintTrajectory(painter) {
  const { context, palette, scene: { recording } } = painter;
  const rows = recording.bestRow.values, xs = recording.rows.x.values, ys = recording.rows.y.values;
  context.strokeStyle = palette.trajectory;
  context.lineWidth = 1.8;
  paintTrack(painter, kMark.trajectory, (f, out) => {
    const row = rows[f];
    if (row < 0) return false;
    out[0] = xs[row];
    out[1] = ys[row];
    return true;
  });
}

export function paintTruth(painter) {
  const { context, view, palette, scene: { recording, frame } } = painter;
  const xs = recording.truthX.values, ys = recording.truthY.values;
  context.strokeStyle = palette.truth;
  context.lineWidth = 1.2;
  context.setLineDash([4, 4]);
  paintTrack(painter, kMark.truth, (f, out) => {
    out[0] = xs[f];
    out[1] = ys[f];
    return !Number.isNaN(out[0]);
  });
  context.setLineDash([]);
  const truth = recording.truthPose(frame);
  if (!truth) return;
  context.beginPath();
  dartPath(context, view.x(truth[0]), view.y(truth[1]), truth[2], 22);
  context.stroke();
}

export function paintLocalFeatures({ context, view, palette, marks, scene }) {
  const T = scene.T_map_local;
  if (!T) return;
  const c = Math.cos(T[2]), s = Math.sin(T[2]);
  for (const stable of [false, true]) {
    context.strokeStyle = stable ? palette.local : palette.candidate;
    context.lineWidth = stable ? kLocalFeature_px : 1.2;
    context.setLineDash(stable ? [] : [2, 3]);
    context.beginPath();
    scene.recording.features.forEach(scene.frame, (feature) => {
      if (feature.stable !== stable) return;
      geometryPath(context, view, feature.geometry, c, s, T[0], T[1]);
      const [x, y] = transformPoint(T, ...anchorOf(feature.geometry));
      marks.add(kMark.local_feature, feature.id, x, y, NaN, NaN, stable ? 1 : 0);
    });
    context.stroke();
  }
  context.setLineDash([]);
}

/// Lines from the robot to what it is associated with; a broad line under each mapped feature of the shown hypothesis.
export function paintAssociations(painter) {
  const { scene, state } = painter, { recording, frame } = scene;
  paintMatched(painter);
  if (state.associations !== 'all') {
    const id = state.associations === 'best' ? scene.best : scene.shown;
    const row = recording.rows.find(frame, id);
    if (row >= 0 || id === scene.shown) paintAssociationsOf(painter, id, 0.75);
    return;
  }
  for (let row = recording.rows.begin(frame); row < recording.rows.end(frame); ++row)
    paintAssociationsOf(painter, recording.rows.id.values[row], 0.3);
}

function paintMatched({ context, view, palette, scene }) {
  context.strokeStyle = palette.match;
  context.globalAlpha = 0.32;
  context.lineWidth = kMatched_px;
  context.beginPath();
  for (const [, mapped] of scene.pairs)
    if (mapped >= 0) geometryPath(context, view, scene.recording.map.features[mapped].geometry);
  context.stroke();
  context.globalAlpha = 1;
}

function paintAssociationsOf({ context, view, palette, marks, scene }, id, opacity) {
  const { recording, frame } = scene;
  if (id < 0) return;
  const pose = recording.poseAt(frame, id), hypothesis = recording.hypotheses.byId.get(id);
  if (!pose || !hypothesis) return;
  const T = recording.registrationAt(frame, pose);
  context.strokeStyle = palette.association;
  context.globalAlpha = opacity;
  context.lineWidth = 1;
  context.beginPath();
  for (const { local, mapped, from, to } of hypothesis.links) {
    if (mapped < 0 || from > frame || frame >= to) continue;
    const seen = recording.features.find(frame, local), target = recording.map.features[mapped].geometry;
    const [sx, sy] = seen ? transformPoint(T, ...anchorOf(seen.geometry)) : pose;
    const [x, y] = nearestOn(target, sx, sy);
    context.moveTo(view.x(pose[0]), view.y(pose[1]));
    context.lineTo(view.x(x), view.y(y));
    marks.add(kMark.association, id, pose[0], pose[1], x, y, local, mapped);
  }
  context.stroke();
  context.globalAlpha = 1;
}

/// Crosses where hypotheses have ended, and small hollow squares where places were refused, a moment ago.
export function paintEnded({ context, view, palette, marks, scene }) {
  const { recording, frame } = scene, now = recording.time.values[frame];
  const { begin } = recording.windows[recording.window.values[frame]];
  context.strokeStyle = palette.finding;
  context.lineWidth = 1.4;
  for (let f = frame; f >= begin && now - recording.time.values[f] <= kAfterglow_s; --f) {
    const part = 1 - (now - recording.time.values[f]) / (kAfterglow_s + 1e-9);
    context.globalAlpha = 0.25 + 0.6 * part;
    context.beginPath();
    for (const hypothesis of recording.endedAt(f)) {
      const [x, y] = hypothesis.end.pose;
      crossPath(context, view.x(x), view.y(y), 4);
      marks.add(kMark.ended, hypothesis.id, x, y);
    }
    for (const [x, y] of recording.refusedAt(f)) {
      context.rect(view.x(x) - 2.5, view.y(y) - 2.5, 5, 5);
      marks.add(kMark.rejected, -1, x, y);
    }
    context.stroke();
  }
  context.globalAlpha = 1;
}

export function paintHypotheses({ context, view, palette, marks, scene }) {
  const { recording, frame } = scene, { rows } = recording;
  const best = recording.bestRow.values[frame];
  context.strokeStyle = palette.plot;
  context.lineWidth = 1;
  context.fillStyle = palette.rival;
  for (let row = rows.end(frame) - 1; row >= rows.begin(frame); --row)
    if (row !== best) paintDart(context, view, rows, row, rivalSize_px(rows.probability.values[row]), marks);
  if (best < 0) return;
  context.fillStyle = palette.best;
  paintDart(context, view, rows, best, kBest_px, marks);
  context.globalAlpha = 1;
}

function paintDart(context, view, rows, row, size_px, marks) {
  const x = rows.x.values[row], y = rows.y.values[row], heading = rows.heading.values[row], p = rows.probability.values[row];
  context.globalAlpha = size_px === kBest_px ? 1 : rivalOpacity(p);
  context.beginPath();
  dartPath(context, view.x(x), view.y(y), heading, size_px);
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
  marks.add(kMark.hypothesis, rows.id.values[row], x, y, heading, p);
}

export function paintLabels({ context, view, palette, scene }) {
  const { rows } = scene.recording, { frame } = scene;
  const begin = rows.topBegins.values[frame], end = Math.min(rows.topBegins.values[frame + 1], begin + kLabels);
  context.font = `600 11px ${palette.font}`;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  for (let k = begin; k < end; ++k) {
    const row = rows.tops.values[k];
    const words = `#${rows.id.values[row]}  ${probabilityWords(rows.probability.values[row])}`;
    label(context, words, view.x(rows.x.values[row]) + 13, view.y(rows.y.values[row]) - 9, palette.text, palette.plot);
  }
}

/// A ring around the selected hypothesis; one that is over, or not shown, is a hollow dart with a cross where it ended.
export function paintSelected({ context, view, palette, marks, scene }) {
  if (!scene.picked) return;
  const alive = scene.recording.rows.find(scene.frame, scene.selected) >= 0;
  const pose = scene.recording.poseAt(scene.frame, scene.selected);
  if (!pose) return;
  const x = view.x(pose[0]), y = view.y(pose[1]);
  context.strokeStyle = palette.selected;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 17, 0, 2 * Math.PI);
  context.stroke();
  if (!alive) {
    context.strokeStyle = palette.finding;
    context.lineWidth = 1.6;
    context.beginPath();
    dartPath(context, x, y, pose[2], kBest_px);
    crossPath(context, x, y, 7);
    context.stroke();
  }
  marks.add(kMark.selected, scene.selected, pose[0], pose[1], pose[2]);
}

/// The findings on show: about the selected hypothesis if it is over, else about the best one if that is shown.
export function findingsOfScene({ recording, frame, picked, shown, best }) {
  if (picked?.end && picked.endFrame <= frame) return { about: picked.id, findings: picked.end.findings };
  return { about: shown, findings: shown >= 0 && shown === best ? recording.findingsAt(frame) : [] };
}

/// Where scorers saw something against (or for) a hypothesis: numbered as in the details.
export function paintFindings({ context, view, palette, marks, scene }) {
  const { about, findings } = findingsOfScene(scene);
  context.font = `600 11px ${palette.font}`;
  context.textAlign = 'center';
  context.textBaseline = 'middle';
  findings.forEach(({ line, feature }, k) => {
    if (line.length !== 4) return;
    const [x, y, u, v] = line;
    context.strokeStyle = palette.finding;
    context.lineWidth = 2;
    context.setLineDash([7, 3]);
    context.beginPath();
    context.moveTo(view.x(x), view.y(y));
    context.lineTo(view.x(u), view.y(v));
    context.stroke();
    context.setLineDash([]);
    if (scene.picked) label(context, String(k + 1), view.x(u), view.y(v) - 9, palette.finding, palette.plot);
    marks.add(kMark.finding, about, x, y, u, v, k, feature);
  });
}

/// A broad line under the mapped feature that was picked from the list.
export function paintPicked({ context, view, palette, scene, state }) {
  const feature = scene.recording.map.features[state.object];
  if (!feature) return;
  context.strokeStyle = palette.selected;
  context.globalAlpha = 0.55;
  context.lineWidth = 9;
  context.lineCap = 'round';
  context.beginPath();
  geometryPath(context, view, feature.geometry);
  context.stroke();
  context.lineCap = 'butt';
  context.globalAlpha = 1;
}
