import { pairsAt } from './hypothesis_log.js';
import { kStatuses } from './frame_check.js';

/// `window.opal`: the page from outside, for tests and for the curious. Numbers of runs and updates count from 0.
export function inspectionOf(app, ready, errors) {
  const view = (run) => app.views[run];
  return {
    ready,
    errors,
    get paints() {
      return app.paints;
    },
    frames: (run = 0) => app.timeLine.recordings[run]?.frames ?? 0,
    /// Shows an update; the promise is kept once it is painted.
    seek: (frame, run = 0) => {
      app.moves.seek(frame, run);
      return settled(app);
    },
    settled: () => settled(app),
    state: (run = 0) => (view(run)?.scene ? stateOf(view(run).scene) : null),
    /// What the last picture really has: marks, in the order of painting.
    drawn: (run = 0, pane = 'global') => view(run)?.[pane].drawn() ?? [],
    view: () => ({ ...app.state.view }),
    choices: () => ({
      time: app.state.time,
      selected: app.state.selected,
      window: app.state.window,
      run: app.state.run,
      playing: app.state.playing,
      layers: [...app.state.layers],
    }),
  };
}

function settled(app) {
  return new Promise((resolve) => {
    app.waiting.push(resolve);
    app.invalidate();
  });
}

function stateOf({ recording, frame, best, shown, T_map_base, pairs }) {
  const { rows, map } = recording,
    hypotheses = [],
    localFeatures = [];
  for (let row = rows.begin(frame); row < rows.end(frame); ++row) {
    const id = rows.id.values[row];
    hypotheses.push({
      id,
      pose: rows.poseOf(row),
      nat: rows.nat.values[row],
      probability: rows.probability.values[row],
      associations: named(map, pairsAt(recording.hypotheses.byId.get(id), frame)),
    });
  }
  recording.features.forEach(frame, (feature) => localFeatures.push({ ...feature }));
  const detail = recording.detail(frame);
  return {
    frame,
    keyframe: recording.keyframe.values[frame],
    stamp: recording.stamp.values[frame],
    time: recording.time.values[frame],
    window: recording.window.values[frame],
    status: kStatuses[recording.status.values[frame]],
    probability: recording.probability.values[frame],
    best,
    shown,
    T_map_base,
    associations: named(map, pairs),
    hypotheses,
    localFeatures,
    local: recording.localPose(frame),
    truth: recording.truthPose(frame),
    words: recording.wordsAt(frame),
    cpu: detail.cpu ?? {},
    search: detail.search ?? null,
  };
}

const named = (map, pairs) => pairs.map(([local, mapped]) => [local, mapped < 0 ? null : map.features[mapped].id]);
