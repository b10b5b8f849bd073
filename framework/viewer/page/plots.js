import Dygraph from 'dygraphs';
import { element, setText } from './dom.js';
import { fixed } from './words_of.js';

// The legend writes style attributes, which the page's security policy forbids; values are shown by the page itself.
const kPlugins = new Set(['Grid Plugin', 'Axes Plugin']);
const pluginName = (plugin) => (typeof plugin === 'function' ? new plugin() : plugin).toString();
Dygraph.PLUGINS = Dygraph.PLUGINS.filter((plugin) => kPlugins.has(pluginName(plugin)));

const kLeastError_m = 0.01;
export const kAxisWidth_px = 118,
  kRightGap_px = 12;

/// What is plotted over time: `value(recording, frame)`; NaN where there is none.
export const kPlots = [
  {
    name: 'error',
    title: 'Error',
    unit: 'm',
    digits: 2,
    log: true,
    value: (r, f) => Math.max(kLeastError_m, r.error.values[f]),
    exact: (r, f) => r.error.values[f],
  },
  { name: 'hypotheses', title: 'Hypotheses', unit: '', digits: 0, value: (r, f) => r.rows.end(f) - r.rows.begin(f) },
  { name: 'probability', title: 'Probability', unit: '', digits: 3, range: [0, 1.04], value: (r, f) => r.probability.values[f] },
  { name: 'cpu', title: 'CPU', unit: 'ms', digits: 2, value: (r, f) => r.cpu.values[f] },
];

/// One strip over the whole time line, one curve per run.
export class Plot {
  constructor(definition, last) {
    this.definition = definition;
    this.last = last;
    this.area = element('div', { class: 'plot-area' });
    this.value = element('span', { class: 'plot-value' });
    this.root = element(
      'div',
      { class: `plot plot-${definition.name}${last ? ' plot-last' : ''}` },
      this.area,
      element(
        'div',
        { class: 'plot-title' },
        element('span', { text: definition.unit ? `${definition.title} [${definition.unit}]` : definition.title }),
        this.value,
      ),
    );
    this.chart = null;
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  /// `range`: the time on show [from, to]. Returns whether there is anything to show.
  show(timeLine, palette, range) {
    const rows = rowsOf(timeLine, this.definition);
    this.root.hidden = !rows.some((row) => row.slice(1).some((v) => v !== null && !Number.isNaN(v)));
    if (this.root.hidden) return false;
    const runs = timeLine.parts.length,
      labels = ['time', 'A', 'B'].slice(0, 1 + runs);
    const look = this.look(palette, runs, range, this.rangeOf(rows));
    if (this.chart && this.chart.getLabels().length === labels.length) this.chart.updateOptions({ file: rows, ...look });
    else this.create(rows, { labels, ...look });
    return true;
  }

  setRange(dateWindow) {
    if (this.chart && !this.root.hidden) this.chart.updateOptions({ dateWindow });
  }

  create(rows, options) {
    this.chart?.destroy();
    this.chart = new Dygraph(this.area, rows, {
      interactionModel: {},
      highlightCircleSize: 0,
      rightGap: kRightGap_px,
      connectSeparatedPoints: true,
      logscale: this.definition.log,
      xValueFormatter: String,
      axisTickSize: 0,
      ...options,
    });
  }

  look(palette, runs, dateWindow, valueRange) {
    const plain = (value) => String(Number(value.toPrecision(6)));
    return {
      colors: runs > 1 ? [palette.runA, palette.runB] : [palette.runA],
      strokeWidth: 1.4,
      gridLineColor: palette.grid,
      axisLineColor: palette.grid,
      dateWindow,
      valueRange,
      axes: {
        x: {
          drawAxis: this.last,
          drawGrid: true,
          axisLabelFormatter: (value) => `${plain(value)} s`,
          pixelsPerLabel: 80,
          axisLabelWidth: 70,
          axisLineColor: palette.grid,
        },
        y: { axisLabelWidth: kAxisWidth_px - 2, axisLabelFormatter: plain, pixelsPerLabel: 18, axisLineColor: palette.grid },
      },
    };
  }

  rangeOf(rows) {
    if (this.definition.range) return this.definition.range;
    let low = Infinity,
      high = 0;
    for (const row of rows) {
      for (let k = 1; k < row.length; ++k) {
        if (row[k] > high) high = row[k];
        if (row[k] < low) low = row[k];
      }
    }
    return this.definition.log
      ? [Math.max(kLeastError_m, low / 1.5), Math.max(high * 1.5, 0.1)]
      : [0, Math.max(high * 1.12, 1e-3)];
  }

  resize() {
    if (this.chart && !this.root.hidden && this.root.clientWidth > 0) this.chart.resize();
  }

  /// The values of the moment, beside the title.
  readOut(timeLine, frames) {
    const { digits, exact, value } = this.definition;
    setText(
      this.value,
      timeLine.parts
        .map(({ recording }, run) => (frames[run] < 0 ? '–' : fixed((exact ?? value)(recording, frames[run]), digits)))
        .join(' | '),
    );
  }
}

/// [time, A, B] by time; null where a run has no update then.
function rowsOf({ parts, timeOf }, { value }) {
  const rows = [];
  parts.forEach((part, run) => {
    for (let frame = part.begin; frame < part.end; ++frame) {
      const row = [timeOf(part, frame), ...parts.map(() => null)];
      row[1 + run] = value(part.recording, frame);
      rows.push(row);
    }
  });
  return parts.length > 1 ? rows.sort((a, b) => a[0] - b[0]) : rows;
}
