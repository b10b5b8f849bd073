import { lowerBound } from './recording.js';

const kSameTime_s = 1e-4; ///< updates are never closer; deep links round to half of it

/// One time axis [s] for the runs on show: the first run's time since the start of its window. A second run goes by stamp
/// if the two overlap in stamps, else by time since its own start.
export class TimeLine {
  constructor(recordings) {
    this.recordings = recordings;
    this.window = 0;
    this.parts = [];
  }

  /// Windows of the first run that have updates: [position, name].
  windows() {
    const all = this.recordings[0]?.windows ?? [];
    return all.map((w, k) => [k, w]).filter(([, w]) => w.end > w.begin);
  }

  select(window) {
    this.window = Math.max(0, Math.min(window, (this.recordings[0]?.windows.length ?? 1) - 1));
    this.refresh();
  }

  /// After a recording has grown.
  refresh() {
    const name = this.recordings[0]?.windows[this.window]?.name;
    this.parts = this.recordings.map((recording, run) => {
      const sameName = recording.windows.findIndex((w) => w.name === name);
      const window = run === 0 ? this.window : sameName >= 0 ? sameName : Math.min(this.window, recording.windows.length - 1);
      const { begin, end } = recording.windows[window] ?? { begin: 0, end: 0 };
      return { recording, window, begin, end, shift: 0 };
    });
    for (const part of this.parts.slice(1)) part.shift = this.shiftOf(part);
    const filled = this.parts.filter((part) => part.end > part.begin);
    this.begin = filled.length ? Math.min(...filled.map((part) => this.timeOf(part, part.begin))) : 0;
    this.end = filled.length ? Math.max(...filled.map((part) => this.timeOf(part, part.end - 1))) : 0;
  }

  shiftOf(part) {
    const first = this.parts[0];
    if (part.end === part.begin || first.end === first.begin) return 0;
    const stamp = (p, frame) => p.recording.stamp.values[frame];
    const overlap =
      stamp(part, part.begin) <= stamp(first, first.end - 1) && stamp(first, first.begin) <= stamp(part, part.end - 1);
    this.byStamp = overlap;
    const zero = (p) => stamp(p, p.begin) - p.recording.time.values[p.begin];
    return overlap ? zero(part) - zero(first) : 0;
  }

  timeOf(part, frame) {
    return part.recording.time.values[frame] + part.shift;
  }

  /// The update that is on show at a time, per run; -1 before the first.
  frameAt(run, time) {
    const part = this.parts[run];
    if (!part || part.end === part.begin) return -1;
    const times = part.recording.time.values.subarray(part.begin, part.end);
    const later = lowerBound(times, times.length, time - part.shift + kSameTime_s);
    return later === 0 ? -1 : part.begin + later - 1;
  }

  /// The nearest update of a run.
  frameNear(run, time) {
    const part = this.parts[run],
      frame = this.frameAt(run, time);
    if (frame < 0) return part && part.end > part.begin ? part.begin : -1;
    if (frame + 1 >= part.end) return frame;
    return time - this.timeOf(part, frame) <= this.timeOf(part, frame + 1) - time ? frame : frame + 1;
  }

  /// The time of the next (1) or previous (-1) update of any run.
  step(time, direction) {
    let found = direction > 0 ? Infinity : -Infinity;
    this.parts.forEach((part, run) => {
      if (part.end === part.begin) return;
      let frame = this.frameAt(run, time);
      const here = frame >= part.begin ? this.timeOf(part, frame) : -Infinity;
      frame = direction > 0 ? frame + 1 : here < time - kSameTime_s ? frame : frame - 1;
      if (direction > 0 && frame < part.begin) frame = part.begin;
      if (frame < part.begin || frame >= part.end) return;
      const t = this.timeOf(part, frame);
      found = direction > 0 ? Math.min(found, t) : Math.max(found, t);
    });
    return Number.isFinite(found) ? found : time;
  }

  /// The time of the next or previous event of a kind (-1: any) of any run, or null.
  event(time, direction, kind) {
    let found = null;
    this.parts.forEach((part, run) => {
      const at = this.frameAt(run, time);
      if (at < 0 && direction < 0) return;
      const frame = part.recording.eventFrom(Math.max(at, part.begin), direction, kind);
      if (frame < 0) return;
      const t = this.timeOf(part, frame);
      if (found === null || (direction > 0 ? t < found : t > found)) found = t;
    });
    return found;
  }
}
