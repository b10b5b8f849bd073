import { element } from './dom.js';
import { kStatuses } from './frame_check.js';
import { kEventKinds } from './recording.js';

const kBand_px = 16,
  kTicks_px = 14,
  kGap_px = 2,
  kNames_px = 9;
const kSpawned = kEventKinds.indexOf('spawned'),
  kEnded = kEventKinds.indexOf('ended'),
  kSearch = kEventKinds.indexOf('search');

/// Over the whole time line: the status of each run as a band with words; spawns (up), ends (down) and searches (dots) of
/// the first, or of the one that is worked with.
export class EventStrip {
  constructor() {
    this.canvas = element('canvas', { role: 'img', 'aria-label': 'Status over time, with spawns, ends and searches' });
    this.root = element('div', { class: 'event-strip' }, this.canvas);
    this.context = this.canvas.getContext('2d');
  }

  height(runs) {
    return runs * (kBand_px + kGap_px) + kTicks_px;
  }

  /// `range`: the time on show [s]; `left` and `width`: where the plots have their time axis [px].
  paint(timeLine, run, [from, to], left, width, palette) {
    const runs = Math.max(1, timeLine.parts.length),
      ratio = Math.min(window.devicePixelRatio || 1, 2),
      height = this.height(runs);
    const total = left + width + 2;
    this.canvas.width = Math.round(total * ratio);
    this.canvas.height = Math.round(height * ratio);
    this.canvas.style.width = `${total}px`;
    this.canvas.style.height = `${height}px`;
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.font = `11px ${palette.font}`;
    this.context.textBaseline = 'middle';
    const x = (time) => left + ((time - from) / (to - from)) * width;
    const rows = runs * (kBand_px + kGap_px);
    timeLine.parts.forEach((_, k) =>
      this.name(
        runs > 1 ? `Status ${'AB'[k]}` : 'Status',
        k * (kBand_px + kGap_px) + kBand_px / 2,
        runs > 1 ? [palette.runA, palette.runB][k] : palette.faint,
      ),
    );
    this.name(runs > 1 ? `Events ${'AB'[run]}` : 'Events', rows + kTicks_px / 2, palette.faint);
    this.context.beginPath();
    this.context.rect(left - 1, 0, width + 3, height);
    this.context.clip();
    timeLine.parts.forEach((part, k) => this.paintBand(timeLine, part, k, x, left, palette));
    const part = timeLine.parts[run] ?? timeLine.parts[0];
    if (part) this.paintTicks(timeLine, part, rows, x, palette);
  }

  paintBand(timeLine, part, row, x, left, palette) {
    const { context } = this,
      y = row * (kBand_px + kGap_px),
      { status } = part.recording;
    for (let begin = part.begin, end; begin < part.end; begin = end) {
      end = begin + 1;
      while (end < part.end && status.values[end] === status.values[begin]) ++end;
      const from = Math.max(left, x(timeLine.timeOf(part, begin))),
        to = x(timeLine.timeOf(part, Math.min(end, part.end - 1)));
      if (to < left) continue;
      context.fillStyle = palette.status[status.values[begin]];
      context.fillRect(from, y, Math.max(to - from, 1.5), kBand_px);
      const words = kStatuses[status.values[begin]];
      if (context.measureText(words).width + 10 < to - from) {
        context.fillStyle = palette.plot;
        context.fillText(words, from + 5, y + kBand_px / 2 + 0.5);
      }
    }
  }

  name(words, y, ink) {
    this.context.fillStyle = ink;
    this.context.textAlign = 'left';
    this.context.fillText(words, kNames_px, y);
  }

  paintTicks(timeLine, part, top, x, palette) {
    const { context } = this,
      { eventFrame, eventKind } = part.recording,
      middle = top + kTicks_px / 2;
    const last = new Float64Array(kEventKinds.length).fill(-9);
    for (let k = 0; k < eventFrame.length; ++k) {
      const frame = eventFrame.values[k],
        kind = eventKind.values[k];
      if (frame < part.begin || frame >= part.end) continue;
      const at = x(timeLine.timeOf(part, frame));
      if (at - last[kind] < 1) continue;
      last[kind] = at;
      if (kind === kSpawned) fill(context, palette.alternative, at, top, 1.5, kTicks_px / 2 - 2);
      else if (kind === kEnded) fill(context, palette.finding, at, middle + 2, 1.5, kTicks_px / 2 - 2);
      else if (kind === kSearch) fill(context, palette.pattern, at - 0.5, middle - 1.5, 3, 3);
    }
  }
}

function fill(context, ink, x, y, width, height) {
  context.fillStyle = ink;
  context.fillRect(x, y, width, height);
}
