import { element, setText } from './dom.js';
import { EventStrip } from './event_strip.js';
import { Plot, kAxisWidth_px, kPlots, kRightGap_px } from './plots.js';
import { fixed, seconds } from './words_of.js';

const kWheelStep = 0.002,
  kShortest_s = 0.5;

/// Everything over time: status band, events, plots, a playhead over them all, and the slider, on one axis. Click or drag
/// goes to a moment, the wheel stretches time.
export class TimePanel {
  constructor(state, seekTime) {
    this.state = state;
    this.seekTime = seekTime;
    this.range = null; ///< [from, to] if only a part is on show
    this.strip = new EventStrip();
    this.plots = kPlots.map((definition, k) => new Plot(definition, k === kPlots.length - 1));
    this.playhead = element('div', { class: 'playhead', 'aria-hidden': 'true' });
    this.tip = element('div', { class: 'tip', hidden: true });
    this.whole = element('button', {
      type: 'button',
      class: 'tool whole',
      text: 'All',
      title: 'Show the whole time',
      hidden: true,
      onclick: () => this.setRange(null),
    });
    this.area = element(
      'div',
      { class: 'time-area' },
      this.strip.root,
      ...this.plots.map((plot) => plot.root),
      this.playhead,
      this.tip,
    );
    this.slider = element('input', {
      type: 'range',
      class: 'slider',
      min: '0',
      max: '1',
      step: 'any',
      'aria-label': 'Time',
      oninput: () => this.slid(),
      onkeydown: (event) => this.sliderKey(event),
    });
    this.root = element(
      'section',
      { class: 'time-panel', 'aria-label': 'Over time' },
      this.area,
      element('div', { class: 'slider-row' }, this.whole, this.slider),
    );
    this.listen();
    new ResizeObserver(() => this.repaint()).observe(this.area);
  }

  get left() {
    return kAxisWidth_px;
  }
  get width() {
    return Math.max(20, this.area.clientWidth - kAxisWidth_px - kRightGap_px);
  }

  get from() {
    return this.range ? this.range[0] : this.timeLine.begin;
  }
  get to() {
    return Math.max(this.range ? this.range[1] : this.timeLine.end, this.from + 1e-3);
  }

  /// After data, window or colours have changed.
  show(timeLine, palette) {
    this.timeLine = timeLine;
    this.palette = palette;
    if (this.range && (this.range[1] <= timeLine.begin || this.range[0] >= timeLine.end)) this.range = null;
    for (const plot of this.plots) plot.show(timeLine, palette, [this.from, this.to]);
    this.repaint();
  }

  repaint() {
    if (!this.timeLine || this.area.clientWidth === 0) return;
    this.whole.hidden = this.range === null;
    this.slider.min = String(this.from);
    this.slider.max = String(this.to);
    this.slider.value = String(this.state.time);
    this.strip.paint(this.timeLine, this.state.run, [this.from, this.to], this.left, this.width, this.palette);
    this.movePlayhead();
  }

  /// Shows a part of the time, or all of it.
  setRange(range) {
    const { begin, end } = this.timeLine;
    const from = Math.max(begin, range?.[0] ?? begin),
      to = Math.min(end, range?.[1] ?? end);
    if (range && to - from < Math.min(kShortest_s, end - begin)) return;
    this.range = from <= begin && to >= end ? null : [from, to];
    for (const plot of this.plots) plot.setRange([this.from, this.to]);
    this.repaint();
  }

  /// The part on show becomes longer by a factor; what is at `time` stays where it is.
  stretch(factor, time = this.state.time) {
    if (this.timeLine) this.setRange([time - (time - this.from) * factor, time + (this.to - time) * factor]);
  }

  /// A moment that is not on show brings its part of the time with it.
  keepInRange() {
    const { time } = this.state;
    if (!this.range || (time >= this.from && time <= this.to)) return;
    const span = this.to - this.from,
      from = Math.min(Math.max(this.timeLine.begin, time - 0.1 * span), this.timeLine.end - span);
    this.setRange([from, from + span]);
  }

  /// To the moment: the playhead moves, nothing is drawn anew.
  follow() {
    if (!this.timeLine) return;
    this.keepInRange();
    this.movePlayhead();
  }

  /// What the slider and the plots say of the moment.
  readOut(frames) {
    if (!this.timeLine) return;
    this.slider.value = String(this.state.time);
    this.slider.setAttribute('aria-valuetext', seconds(this.state.time));
    for (const plot of this.plots) plot.readOut(this.timeLine, frames);
  }

  movePlayhead() {
    const part = (this.state.time - this.from) / (this.to - this.from);
    this.playhead.style.transform = `translateX(${this.left + Math.min(1, Math.max(0, part)) * this.width}px)`;
  }

  timeAt(clientX) {
    const x = clientX - this.area.getBoundingClientRect().left - this.left;
    return Math.min(this.timeLine.end, this.from + Math.min(1, Math.max(0, x / this.width)) * (this.to - this.from));
  }

  listen() {
    let held = false;
    this.area.addEventListener('pointerdown', (event) => {
      if (event.button !== 0 || !this.timeLine) return;
      held = true;
      this.area.setPointerCapture(event.pointerId);
      this.seekTime(this.timeAt(event.clientX));
    });
    this.area.addEventListener('pointermove', (event) => {
      if (!this.timeLine) return;
      if (held) this.seekTime(this.timeAt(event.clientX));
      this.explain(event);
    });
    this.area.addEventListener(
      'wheel',
      (event) => {
        if (!this.timeLine || event.deltaY === 0) return;
        event.preventDefault();
        this.stretch(Math.exp(kWheelStep * event.deltaY), this.timeAt(event.clientX));
      },
      { passive: false },
    );
    const release = () => (held = false);
    this.area.addEventListener('pointerup', release);
    this.area.addEventListener('pointercancel', release);
    this.area.addEventListener('pointerleave', () => (this.tip.hidden = true));
  }

  /// What the plots say under the pointer, the cost by stage.
  explain(event) {
    const lines = this.timeLine.parts.flatMap(({ recording }, run) => {
      const frame = this.timeLine.frameNear(run, this.timeAt(event.clientX));
      return frame < 0 ? [] : [...(this.timeLine.parts.length > 1 ? ['AB'[run]] : []), ...this.linesOf(recording, frame)];
    });
    setText(this.tip, lines.join('\n'));
    this.tip.hidden = lines.length === 0;
    const box = this.area.getBoundingClientRect(),
      x = event.clientX - box.left,
      right = x + 18 + this.tip.offsetWidth > box.width;
    const y = Math.min(event.clientY - box.top, box.height) - this.tip.offsetHeight - 8;
    this.tip.style.transform = `translate(${Math.max(0, right ? x - 14 - this.tip.offsetWidth : x + 16)}px, ${y}px)`;
  }

  linesOf(recording, frame) {
    const values = kPlots
      .map(({ title, unit, digits, exact, value }) => [title, (exact ?? value)(recording, frame), unit, digits])
      .filter(([, value]) => !Number.isNaN(value))
      .map(([title, value, unit, digits]) => `${title} ${fixed(value, digits)} ${unit}`.trim());
    const stages = Object.entries(recording.detail(frame).cpu ?? {})
      .filter(([stage]) => stage !== 'total')
      .map(([stage, ms]) => `   ${stage.slice(0, 30)} ${fixed(ms, 2)} ms`);
    return [`${seconds(recording.time.values[frame])}, update ${recording.keyframe.values[frame]}`, ...values, ...stages];
  }

  slid() {
    this.seekTime(Number(this.slider.value));
  }

  /// Arrow keys of the slider go from update to update: the browser's own step means nothing here.
  sliderKey(event) {
    const { timeLine } = this,
      tenth = (timeLine.end - timeLine.begin) / 10;
    const moves = {
      ArrowRight: () => timeLine.step(this.state.time, 1),
      ArrowUp: () => timeLine.step(this.state.time, 1),
      ArrowLeft: () => timeLine.step(this.state.time, -1),
      ArrowDown: () => timeLine.step(this.state.time, -1),
      PageUp: () => this.state.time + tenth,
      PageDown: () => this.state.time - tenth,
      Home: () => timeLine.begin,
      End: () => timeLine.end,
    };
    if (!Object.hasOwn(moves, event.key) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.seekTime(moves[event.key]());
  }
}
