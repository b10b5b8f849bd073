import { element, setText } from './dom.js';
import { EventStrip } from './event_strip.js';
import { Plot, kAxisWidth_px, kPlots, kRightGap_px } from './plots.js';
import { fixed, seconds } from './words_of.js';

/// Everything over time: status band, events, plots, a playhead over them all, and the slider, on one axis. Click or drag
/// goes to a moment.
export class TimePanel {
  constructor(state, seekTime) {
    this.state = state;
    this.seekTime = seekTime;
    this.strip = new EventStrip();
    this.plots = kPlots.map((definition, k) => new Plot(definition, k === kPlots.length - 1));
    this.playhead = element('div', { class: 'playhead', 'aria-hidden': 'true' });
    this.tip = element('div', { class: 'tip', hidden: true });
    this.area = element('div', { class: 'time-area' }, this.strip.root, ...this.plots.map((plot) => plot.root), this.playhead, this.tip);
    this.slider = element('input', { type: 'range', class: 'slider', min: '0', max: '1', step: 'any', 'aria-label': 'Time', oninput: () => this.slid(), onkeydown: (event) => this.sliderKey(event) });
    this.root = element('section', { class: 'time-panel', 'aria-label': 'Over time' }, this.area, element('div', { class: 'slider-row' }, this.slider));
    this.listen();
    new ResizeObserver(() => this.repaint()).observe(this.area);
  }

  get left() { return kAxisWidth_px; }
  get width() { return Math.max(20, this.area.clientWidth - kAxisWidth_px - kRightGap_px); }

  /// After data, window or colours have changed.
  show(timeLine, palette) {
    this.timeLine = timeLine;
    this.palette = palette;
    this.slider.min = String(timeLine.begin);
    this.slider.max = String(Math.max(timeLine.end, timeLine.begin + 1e-3));
    for (const plot of this.plots) plot.show(timeLine, palette);
    this.repaint();
  }

  repaint() {
    if (!this.timeLine || this.area.clientWidth === 0) return;
    this.strip.paint(this.timeLine, this.state.run, this.left, this.width, this.palette);
    this.movePlayhead();
  }

  /// To the moment: the playhead moves, nothing is drawn anew.
  update(frames) {
    this.movePlayhead();
    this.slider.value = String(this.state.time);
    this.slider.setAttribute('aria-valuetext', seconds(this.state.time));
    for (const plot of this.plots) plot.readOut(this.timeLine, frames);
  }

  movePlayhead() {
    const { begin, end } = this.timeLine, part = (this.state.time - begin) / Math.max(end - begin, 1e-9);
    this.playhead.style.transform = `translateX(${this.left + Math.min(1, Math.max(0, part)) * this.width}px)`;
  }

  timeAt(clientX) {
    const x = clientX - this.area.getBoundingClientRect().left - this.left, { begin, end } = this.timeLine;
    return begin + Math.min(1, Math.max(0, x / this.width)) * (end - begin);
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
    const box = this.area.getBoundingClientRect(), x = event.clientX - box.left, right = x + 18 + this.tip.offsetWidth > box.width;
    const y = Math.min(event.clientY - box.top, box.height) - this.tip.offsetHeight - 8;
    this.tip.style.transform = `translate(${Math.max(0, right ? x - 14 - this.tip.offsetWidth : x + 16)}px, ${y}px)`;
  }

  linesOf(recording, frame) {
    const values = kPlots.map(({ title, unit, digits, exact, value }) => [title, (exact ?? value)(recording, frame), unit, digits])
      .filter(([, value]) => !Number.isNaN(value)).map(([title, value, unit, digits]) => `${title} ${fixed(value, digits)} ${unit}`.trim());
    const stages = Object.entries(recording.detail(frame).cpu ?? {}).filter(([stage]) => stage !== 'total')
      .map(([stage, ms]) => `   ${stage.slice(0, 30)} ${fixed(ms, 2)} ms`);
    return [`${seconds(recording.time.values[frame])}, update ${recording.keyframe.values[frame]}`, ...values, ...stages];
  }

  slid() { this.seekTime(Number(this.slider.value)); }

  /// Arrow keys of the slider go from update to update: the browser's own step means nothing here.
  sliderKey(event) {
    const { timeLine } = this, tenth = (timeLine.end - timeLine.begin) / 10;
    const moves = {
      ArrowRight: () => timeLine.step(this.state.time, 1), ArrowUp: () => timeLine.step(this.state.time, 1),
      ArrowLeft: () => timeLine.step(this.state.time, -1), ArrowDown: () => timeLine.step(this.state.time, -1),
      PageUp: () => this.state.time + tenth, PageDown: () => this.state.time - tenth, Home: () => timeLine.begin, End: () => timeLine.end,
    };
    if (!Object.hasOwn(moves, event.key) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.seekTime(moves[event.key]());
  }
}
