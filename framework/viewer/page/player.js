import { kSpeeds } from './app_state.js';

/// Time that runs by itself: state.time goes on with the wall clock, times speed, until the end.
export class Player {
  constructor(state, timeLine) {
    this.state = state;
    this.timeLine = timeLine;
    this.before = 0;
  }

  toggle(playing = !this.state.playing) {
    if (playing && this.state.time >= this.timeLine.end - 1e-6) this.state.set({ time: this.timeLine.begin });
    this.before = 0;
    this.state.set({ playing, newest: false });
  }

  faster(step) {
    const k = kSpeeds.indexOf(this.state.speed) + step;
    this.state.set({ speed: kSpeeds[Math.min(kSpeeds.length - 1, Math.max(0, k))] });
  }

  /// Once per picture; `now` in ms.
  tick(now) {
    if (!this.state.playing) return;
    const passed_s = this.before > 0 ? (now - this.before) / 1000 : 0;
    this.before = now;
    const time = Math.min(this.timeLine.end, this.state.time + passed_s * this.state.speed);
    this.state.set(time >= this.timeLine.end ? { time, playing: false } : { time });
  }
}
