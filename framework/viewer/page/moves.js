import { hypothesesBestFirst } from './hypothesis_list.js';

/// The ways from one moment, window, hypothesis or object to another.
export class Moves {
  constructor(app) {
    this.app = app;
  }

  selectWindow(window) {
    this.app.timeLine.select(window);
    this.app.state.set({ window: this.app.timeLine.window, time: this.app.timeLine.begin, playing: false, selected: -1 });
    this.app.header.update();
    this.app.showPlots();
  }

  seekTime(time) {
    this.app.state.set({ time: Math.min(this.app.timeLine.end, Math.max(this.app.timeLine.begin, time)), newest: false });
  }

  /// To an update of a run, in whichever window it is.
  seek(frame, run = 0) {
    const recording = this.app.timeLine.recordings[run];
    if (!recording || !(frame >= 0 && frame < recording.frames)) return;
    const window = recording.window.values[frame];
    if (run === 0 && window !== this.app.timeLine.window) this.selectWindow(window);
    this.app.player.toggle(false);
    this.seekTime(this.app.timeLine.timeOf(this.app.timeLine.parts[run], frame));
  }

  step(by) {
    this.app.player.toggle(false);
    this.seekTime(this.app.timeLine.step(this.app.state.time, by));
  }

  jump(by) {
    const time = this.app.timeLine.event(this.app.state.time, by, this.app.state.eventKind);
    if (time === null) return;
    this.app.player.toggle(false);
    this.seekTime(time);
  }

  toNewest() {
    this.app.state.set({ newest: true, playing: false, time: this.app.timeLine.end });
  }

  /// To the next (1) or previous (-1) of the live hypotheses, best first.
  cycle(by) {
    const { scene } = this.app.views[this.app.state.run] ?? {};
    if (!scene) return;
    const ids = hypothesesBestFirst(scene).map(({ key }) => key),
      at = ids.indexOf(this.app.state.selected);
    if (ids.length > 0)
      this.app.state.set({ selected: ids[at < 0 ? (by > 0 ? 0 : ids.length - 1) : (at + by + ids.length) % ids.length] });
  }

  cycleObjects(by) {
    const count = this.app.views[0]?.recording.map?.features.length ?? 0;
    if (count > 0)
      this.app.state.set({
        object: (this.app.state.object + by + count + (this.app.state.object < 0 && by < 0 ? 1 : 0)) % count,
      });
  }
}
