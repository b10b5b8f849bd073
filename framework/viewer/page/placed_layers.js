import { geometryPath } from './brush.js';
import { anchorOf, nearestOn } from './geometry.js';
import { kMark } from './marks.js';
import { transformPoint } from './pose.js';

/// What a hypothesis places on the global map: scan, free space, local features, associations. Each layer takes the pane's
/// painter: `{context, view, palette, marks, scene, state}`.

const kScanDot_px = 2,
  kMatched_px = 7,
  kLocalFeature_px = 2.2;

/// Visits what the sensor saw at a moment, as it lies from the pose T; frame: of the pane.
function eachPlaced(points, frame, T, visit) {
  const c = Math.cos(T[2]),
    s = Math.sin(T[2]),
    xy = points.xy.values;
  for (let k = points.begin(frame), end = points.end(frame); k < end; k += 2)
    visit(T[0] + c * xy[k] - s * xy[k + 1], T[1] + s * xy[k] + c * xy[k + 1]);
}

/// The free space of a moment, placed by T. `id`: of the hypothesis whose pose T is, or -1.
export function fillFreeSpace({ context, view, palette, marks, scene }, T, id, opacity) {
  context.beginPath();
  eachPlaced(scene.recording.free, scene.frame, T, (x, y) => {
    context.lineTo(view.x(x), view.y(y));
    marks.add(kMark.free_space, id, x, y);
  });
  context.closePath();
  context.fillStyle = palette.free;
  context.globalAlpha = opacity;
  context.fill();
  context.globalAlpha = 1;
}

/// The scan of a moment; T and id as in fillFreeSpace.
export function dotScan({ context, view, palette, marks, scene }, T, id) {
  context.fillStyle = palette.scan;
  eachPlaced(scene.recording.scan, scene.frame, T, (x, y) => {
    context.fillRect(view.x(x) - kScanDot_px / 2, view.y(y) - kScanDot_px / 2, kScanDot_px, kScanDot_px);
    marks.add(kMark.scan, id, x, y);
  });
}

export function paintFreeSpace(painter) {
  const { scene } = painter,
    { free } = scene.recording;
  if (scene.T_map_base && free.end(scene.frame) - free.begin(scene.frame) >= 6)
    fillFreeSpace(painter, scene.T_map_base, scene.shown, 0.15);
}

export function paintScan(painter) {
  const { T_map_base, shown } = painter.scene;
  if (T_map_base) dotScan(painter, T_map_base, shown);
}

export function paintLocalFeatures({ context, view, palette, marks, scene }) {
  const T = scene.T_map_local;
  if (!T) return;
  const c = Math.cos(T[2]),
    s = Math.sin(T[2]);
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
  const { scene, state } = painter,
    { recording, frame } = scene;
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
  const pose = recording.poseAt(frame, id),
    hypothesis = recording.hypotheses.byId.get(id);
  if (!pose || !hypothesis) return;
  const T = recording.registrationAt(frame, pose);
  context.strokeStyle = palette.association;
  context.globalAlpha = opacity;
  context.lineWidth = 1;
  context.beginPath();
  for (const { local, mapped, from, to } of hypothesis.links) {
    if (mapped < 0 || from > frame || frame >= to) continue;
    const seen = recording.features.find(frame, local),
      target = recording.map.features[mapped].geometry;
    const [sx, sy] = seen ? transformPoint(T, ...anchorOf(seen.geometry)) : pose;
    const [x, y] = nearestOn(target, sx, sy);
    context.moveTo(view.x(pose[0]), view.y(pose[1]));
    context.lineTo(view.x(x), view.y(y));
    marks.add(kMark.association, id, pose[0], pose[1], x, y, local, mapped);
  }
  context.stroke();
  context.globalAlpha = 1;
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
