import { crossPath, dartPath, label } from './brush.js';
import { kMark } from './marks.js';
import { probabilityWords } from './words_of.js';

/// Hypotheses on the global map: those that are alive, the selected one, those that have just ended, and what was found about
/// them. Painter as in placed_layers.js.

const kBest_px = 17,
  kLabels = 6;
/// What has ended or was refused stays on show this long [s].
const kAfterglow_s = 1;

/// The more probable, the larger and the more opaque, as in the static pictures.
const alternativeSize_px = (probability) => 9 + 6 * Math.sqrt(Math.min(1, Math.max(0, probability)));

const alternativeOpacity = (probability) => 0.42 + 0.58 * Math.sqrt(Math.min(1, Math.max(0, probability)));

/// Crosses where hypotheses have ended, and small hollow squares where places were refused, a moment ago.
export function paintEnded({ context, view, palette, marks, scene }) {
  const { recording, frame } = scene,
    now = recording.time.values[frame];
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
  const { recording, frame } = scene,
    { rows } = recording;
  const best = recording.bestRow.values[frame];
  context.strokeStyle = palette.plot;
  context.lineWidth = 1;
  context.fillStyle = palette.alternative;
  for (let row = rows.end(frame) - 1; row >= rows.begin(frame); --row)
    if (row !== best) paintDart(context, view, rows, row, alternativeSize_px(rows.probability.values[row]), marks);
  if (best < 0) return;
  context.fillStyle = palette.best;
  paintDart(context, view, rows, best, kBest_px, marks);
  context.globalAlpha = 1;
}

function paintDart(context, view, rows, row, size_px, marks) {
  const x = rows.x.values[row],
    y = rows.y.values[row],
    heading = rows.heading.values[row],
    p = rows.probability.values[row];
  context.globalAlpha = size_px === kBest_px ? 1 : alternativeOpacity(p);
  context.beginPath();
  dartPath(context, view.x(x), view.y(y), heading, size_px);
  context.fill();
  context.globalAlpha = 1;
  context.stroke();
  marks.add(kMark.hypothesis, rows.id.values[row], x, y, heading, p);
}

export function paintLabels({ context, view, palette, scene }) {
  const { rows } = scene.recording,
    { frame } = scene;
  const begin = rows.topBegins.values[frame],
    end = Math.min(rows.topBegins.values[frame + 1], begin + kLabels);
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
  const x = view.x(pose[0]),
    y = view.y(pose[1]);
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
