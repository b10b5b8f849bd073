import { dartPath } from './brush.js';
import { kMark } from './marks.js';

/// Where the robot has been so far, on the global map: as estimated, and as recorded by other means. Painter as in placed_layers.js.

const kJump_m = 1,
  kMinStep_px = 1.5;

/// A line through the places that `placeOf(frame)` gives, up to now; broken where it jumps. Returns nothing; `out` is reused.
function paintTrack({ context, view, marks, scene }, kind, placeOf) {
  const { recording, frame } = scene,
    out = [0, 0];
  const { begin } = recording.windows[recording.window.values[frame]];
  let drawn = false,
    lastX = 0,
    lastY = 0,
    mapX = 0,
    mapY = 0;
  context.beginPath();
  for (let f = begin; f <= frame; ++f) {
    if (!placeOf(f, out)) {
      drawn = false;
      continue;
    }
    const x = view.x(out[0]),
      y = view.y(out[1]);
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

/// The way before the first frame of the recording, which is all that is left of it.
function paintEarlierPath({ context, view, scene: { recording, frame } }) {
  if (recording.window.values[frame] !== 0) return;
  context.beginPath();
  for (const line of recording.earlierPath)
    for (let k = 0; k < line.length; k += 2) context[k === 0 ? 'moveTo' : 'lineTo'](view.x(line[k]), view.y(line[k + 1]));
  context.stroke();
}

export function paintTrajectory(painter) {
  const {
    context,
    palette,
    scene: { recording },
  } = painter;
  const rows = recording.bestRow.values,
    xs = recording.rows.x.values,
    ys = recording.rows.y.values;
  context.strokeStyle = palette.trajectory;
  context.lineWidth = 1.8;
  paintEarlierPath(painter);
  paintTrack(painter, kMark.trajectory, (f, out) => {
    const row = rows[f];
    if (row < 0) return false;
    out[0] = xs[row];
    out[1] = ys[row];
    return true;
  });
}

export function paintTruth(painter) {
  const {
    context,
    view,
    palette,
    scene: { recording, frame },
  } = painter;
  const xs = recording.truthX.values,
    ys = recording.truthY.values;
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
