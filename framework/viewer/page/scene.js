import { pairsAt } from './hypothesis_log.js';

/// What the panes of one run show at a moment. `shown` is the hypothesis that places scan and features: the selected one if
/// it is alive then (or ends then), else the best; -1 if there is none.
export function sceneAt(recording, frame, selected) {
  const { rows, hypotheses } = recording;
  const best = recording.best.values[frame];
  const picked = hypotheses.byId.get(selected);
  const usable = picked && (rows.find(frame, selected) >= 0 || picked.endFrame === frame);
  const shown = usable ? selected : rows.find(frame, best) >= 0 ? best : -1;
  const T_map_base = shown < 0 ? null : recording.poseAt(frame, shown);
  return {
    recording,
    frame,
    best,
    selected: picked ? selected : -1,
    shown,
    T_map_base,
    T_map_local: T_map_base && recording.registrationAt(frame, T_map_base),
    pairs: shown < 0 ? [] : pairsAt(hypotheses.byId.get(shown), frame),
    picked: picked && picked.spawnedFrame <= frame ? picked : null,
  };
}
