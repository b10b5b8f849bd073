/// A run that goes on for hours: the page keeps a window of it. Records of the program's own live feed: OPAL_SYNTHETIC_RUN.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { test } from 'node:test';
import { KeptWindow } from '../../../framework/viewer/page/live_feed.js';
import { pairsAt } from '../../../framework/viewer/page/hypothesis_log.js';
import { Recording } from '../../../framework/viewer/page/recording.js';
import { kMaker, kUpdatesASecond, recordsOfWindow } from './long_run.js';

const skip = existsSync(kMaker) ? false : 'OPAL_SYNTHETIC_RUN does not name the built program';
const kWindow_s = 60;

/// What the page shows of a frame.
function shownAt(recording, frame) {
  const rows = [];
  for (let row = recording.rows.begin(frame); row < recording.rows.end(frame); ++row) {
    const id = recording.rows.id.values[row];
    const pairs = pairsAt(recording.hypotheses.byId.get(id), frame).sort();
    rows.push({ id, pose: recording.rows.poseOf(row).map((v) => v.toFixed(3)), pairs });
  }
  const features = [];
  recording.features.forEach(frame, ({ id, stable }) => features.push([id, stable]));
  return {
    rows: rows.sort((a, b) => a.id - b.id),
    features: features.sort(([a], [b]) => a - b),
    words: recording.wordsAt(frame),
    best: recording.best.values[frame],
    time: recording.time.values[frame],
  };
}

/// How many numbers, hypotheses and characters a recording holds.
function weightOf(recording) {
  const { rows, scan, free, features, hypotheses, written } = recording;
  const columns = [rows.id, rows.tops, scan.xy, free.xy, features.alive, recording.time, recording.eventFrame];
  return {
    numbers: columns.reduce((sum, column) => sum + column.length, 0),
    hypotheses: hypotheses.inOrder.length,
    versions: features.versions.length,
    lines: written.lines.length,
  };
}

test('over hours the page keeps as much as after minutes, and at least the window', { skip }, () => {
  const kept = new KeptWindow('live');
  let replaced = 0,
    early = {},
    late = {};
  recordsOfWindow({ seconds: 2 * 3600, window_s: kWindow_s }).forEach((line, k) => {
    replaced += kept.append(line) ? 1 : 0;
    const most = k < 600 * kUpdatesASecond ? early : late;
    for (const [name, value] of Object.entries(weightOf(kept.recording))) most[name] = Math.max(most[name] ?? 0, value);
    if (k <= 2 * kWindow_s * kUpdatesASecond) return;
    const { lasts_s } = kept.recording;
    assert.ok(lasts_s >= kWindow_s && lasts_s < 2.2 * kWindow_s, `${lasts_s} s at record ${k}`);
  });
  assert.ok(replaced > 80);
  for (const name of Object.keys(early)) assert.ok(late[name] < 1.2 * early[name], `${name}: ${early[name]}, later ${late[name]}`);
});

test('a recording that begins in the middle shows what one shows that has everything', { skip }, () => {
  const whole = new Recording('whole'),
    kept = new KeptWindow('live');
  let compared = 0;
  recordsOfWindow({ seconds: 400, window_s: kWindow_s, hypotheses: 12 }).forEach((line) => {
    whole.append(line);
    kept.append(line);
    if (kept.recording.frames === whole.frames || kept.recording.frames % 7 !== 0) return;
    compared += 1;
    assert.deepEqual(shownAt(kept.recording, kept.recording.frames - 1), shownAt(whole, whole.frames - 1));
  });
  assert.ok(compared > 100);
  assert.ok(kept.recording.earlierPath[0].length > 20);
  assert.deepEqual(whole.earlierPath, []);
});

test('time lines that are over go with their windows', { skip }, () => {
  const kept = new KeptWindow('live');
  for (const line of recordsOfWindow({ seconds: 600, window_s: kWindow_s, timeLines: 3 })) kept.append(line);
  assert.equal(kept.recording.windows.length, 1);
  assert.equal(kept.recording.windows[0].name, 'q2');
});
