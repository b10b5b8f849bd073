import { Column } from './column.js';
import { FeatureLog } from './feature_log.js';
import { checkedFrame } from './frame_check.js';
import { HypothesisLog } from './hypothesis_log.js';
import { PointLog } from './point_log.js';
import { compose, inverse } from './pose.js';
import { RecordError, number, numberOrNull, object, optionalList, refuse, text } from './record_error.js';
import { RowLog } from './row_log.js';
import { RunMap } from './run_map.js';
import { WrittenRecords } from './written_records.js';

/// What one can jump to, each with how the page calls it.
export const kEventKinds = ['status', 'spawned', 'ended', 'search'];

const kNone = [];

/// A whole run, decoded: append() takes one record after the other; all else reads. Frame f is the update number f of
/// the file. What is only needed of the moment on show (words, scores, cost) is read from the record itself, by detail().
export class Recording {
  constructor(name) {
    this.name = name;
    this.header = null;
    this.map = null;
    this.records = 0;
    this.characters = 0; ///< of frame records
    this.newestBegins = false; ///< a recording can begin with the newest frame record, after those of run and map
    this.lasts_s = 0; ///< from the first frame to the newest, time lines added up
    this.earlierPath = []; ///< where the robot was before the first frame: lines [x, y, x, y, ...] [m]
    this.windows = []; ///< {name, begin, end}: time lines, by frames
    this.hypotheses = new HypothesisLog();
    this.features = new FeatureLog();
    this.written = new WrittenRecords();
    const ints = ['keyframe', 'window', 'best', 'bestRow', 'wordsFrame', 'searchFrame'];
    const floats = [
      'time',
      'stamp',
      'probability',
      'none',
      'x',
      'y',
      'heading',
      'truthX',
      'truthY',
      'truthHeading',
      'error',
      'cpu',
    ];
    for (const column of ints) this[column] = new Column(Int32Array);
    for (const column of floats) this[column] = new Column(Float64Array);
    this.status = new Column(Uint8Array);
    this.matched = new Column(Uint8Array);
    this.eventFrame = new Column(Int32Array);
    this.eventKind = new Column(Uint8Array);
    this.endedBy = new Map(); ///< frame -> hypotheses
    this.refusedBy = new Map(); ///< frame -> places
  }

  get frames() {
    return this.written.lines.length;
  }

  /// Throws RecordError; what was appended before stays as it was.
  append(line) {
    const number = this.records + 1;
    let record;
    try {
      record = JSON.parse(line);
    } catch {
      throw new RecordError(
        `record ${number}: expected a JSON object, found ${JSON.stringify(line.slice(0, 40))}${line.length > 40 ? '…' : ''}`,
      );
    }
    try {
      this.take(object(record, 'record'), line);
    } catch (error) {
      const kind = typeof record?.r === 'string' ? ` (${record.r.slice(0, 20)})` : '';
      throw new RecordError(`record ${number}${kind}: ${error.message}`);
    }
    this.records = number;
  }

  take(record, line) {
    if (record.r === 'run') this.takeRun(record);
    else if (record.r === 'map') this.takeMap(record);
    else if (record.r === 'frame') this.takeFrame(record, line);
    else refuse('r', 'run, map or frame', record.r);
  }

  takeRun(record) {
    if (this.header) refuse('run', 'one run per data block', 'a second one');
    const units = {
      m: number(record.unit_m, 'unit_m'),
      rad: number(record.unit_rad, 'unit_rad'),
      nat: number(record.unit_nat, 'unit_nat'),
    };
    const scan_m = number(record.scan_unit_m, 'scan_unit_m');
    if (record.window !== undefined) checkWindow(record.window);
    const reduced = optionalList(record.reduced, 'reduced').map((sentence) => text(sentence, 'reduced'));
    this.rows = new RowLog(units);
    this.scan = new PointLog(scan_m);
    this.free = new PointLog(scan_m);
    this.header = { ...record, reduced };
  }

  takeMap(record) {
    if (!this.header) refuse('map', 'a run record before it', 'none');
    this.map = new RunMap(record);
    this.hypotheses.features = this.map.features.length;
  }

  takeFrame(record, line) {
    if (!this.map) refuse('frame', 'run and map records before it', 'none');
    const frame = this.frames,
      first = frame === 0;
    const now = checkedFrame(record, first, first ? 0 : this.time.values[frame - 1], this.map.features.length);
    const { restated } = record;
    if (now.starts) this.startWindow(text(record.start ?? restated?.start ?? '', 'start'), frame);
    else this.lasts_s += now.time - this.time.values[frame - 1];
    if (restated) this.rows.restart();
    this.rows.append(record, now.local);
    this.features.append(record, now.starts || restated !== undefined);
    this.takeHistory(restated && first ? this.beginWith(record) : record, frame);
    this.scan.append(record.scan, 'scan');
    this.free.append(record.free, 'free');
    this.takeMoment(record, now, frame);
    this.written.lines.push(line);
    this.characters += line.length;
    this.newestBegins = now.starts || restated !== undefined;
    this.windows[this.windows.length - 1].end = frame + 1;
  }

  /// A recording that begins in the middle of a run is told what holds, instead of how it came about.
  beginWith(record) {
    this.earlierPath = record.restated.path ?? [];
    return { ...record, spawned: record.restated.hypotheses, lost: undefined, grown: undefined };
  }

  startWindow(name, frame) {
    for (const id of this.rows.restart()) this.hypotheses.voided(id, frame);
    this.windows.push({ name, begin: frame, end: frame });
  }

  takeHistory(record, frame) {
    const first = frame === 0;
    const each = (name) => {
      const entries = optionalList(record[name], name);
      entries.forEach((entry, k) => this.hypotheses[name](entry, frame, `${name}[${k}]`));
      return entries.length > 0;
    };
    const spawned = each('spawned');
    each('lost'); // before they grow: the same local feature may find another counterpart
    each('grown');
    each('tried');
    const ended = each('ended');
    for (let row = this.rows.begin(frame); row < this.rows.end(frame); ++row)
      this.hypotheses.of(this.rows.id.values[row], frame, 'enter');
    if (ended)
      this.endedBy.set(
        frame,
        record.ended.map(([id]) => this.hypotheses.byId.get(id)),
      );
    if (record.search?.rejected?.length)
      this.refusedBy.set(
        frame,
        record.search.rejected.map(([, x, y]) => [x, y]),
      );
    if (spawned && !(first && record.restated)) this.mark(frame, 'spawned');
    if (ended) this.mark(frame, 'ended');
    if (record.search) this.mark(frame, 'search');
  }

  mark(frame, kind) {
    this.eventFrame.push(frame);
    this.eventKind.push(kEventKinds.indexOf(kind));
  }

  takeMoment(record, now, frame) {
    const carriedOn = !now.starts;
    if (now.starts || now.status !== this.status.values[frame - 1]) this.mark(frame, 'status');
    this.keyframe.push(now.keyframe);
    this.time.push(now.time);
    this.stamp.push(now.stamp);
    this.window.push(this.windows.length - 1);
    this.status.push(now.status);
    this.matched.push(record.match ? 1 : 0);
    this.probability.push(numberOrNull(record.probability, 'probability'));
    this.none.push(numberOrNull(record.none, 'none'));
    this.x.push(now.local[0]);
    this.y.push(now.local[1]);
    this.heading.push(now.local[2]);
    this.best.push(now.best);
    const row = this.rows.find(frame, now.best);
    this.bestRow.push(row);
    this.takeTruth(now.truth, row);
    this.cpu.push(record.cpu ? numberOrNull(record.cpu.total, 'cpu.total') : NaN);
    this.wordsFrame.push(record.words ? frame : carriedOn ? this.wordsFrame.values[frame - 1] : -1);
    this.searchFrame.push(record.search ? frame : carriedOn ? this.searchFrame.values[frame - 1] : -1);
  }

  takeTruth(truth, row) {
    this.truthX.push(truth ? truth[0] : NaN);
    this.truthY.push(truth ? truth[1] : NaN);
    this.truthHeading.push(truth ? truth[2] : NaN);
    this.error.push(truth && row >= 0 ? Math.hypot(this.rows.x.values[row] - truth[0], this.rows.y.values[row] - truth[1]) : NaN);
  }

  /// Hypotheses that ended in a frame, and places that its search refused.
  endedAt(frame) {
    return this.endedBy.get(frame) ?? kNone;
  }
  refusedAt(frame) {
    return this.refusedBy.get(frame) ?? kNone;
  }

  /// What is read again from the records themselves.
  detail(frame) {
    return this.written.record(frame);
  }
  wordsAt(frame) {
    return this.written.words(this.wordsFrame.values[frame]);
  }
  searchAt(frame) {
    return this.written.search(frame);
  }
  findingsAt(frame) {
    return this.written.findings(frame, this.map.features.length);
  }

  localPose(frame) {
    return [this.x.values[frame], this.y.values[frame], this.heading.values[frame]];
  }

  truthPose(frame) {
    const x = this.truthX.values[frame];
    return Number.isNaN(x) ? null : [x, this.truthY.values[frame], this.truthHeading.values[frame]];
  }

  /// T_map_base of a hypothesis at a frame: where it is, or where it ended or began; null if it is not known.
  poseAt(frame, id) {
    const row = this.rows.find(frame, id);
    if (row >= 0) return this.rows.poseOf(row);
    const hypothesis = this.hypotheses.byId.get(id);
    return hypothesis?.end?.pose ?? hypothesis?.pose ?? null;
  }

  /// T_map_local that a hypothesis means at a frame.
  registrationAt(frame, T_map_base) {
    return compose(T_map_base, inverse(this.localPose(frame)));
  }

  /// The next (step 1) or previous (step -1) frame within its time line that has an event of that kind (-1: any), or -1.
  eventFrom(frame, step, kind) {
    const { begin, end } = this.windows[this.window.values[frame]];
    const frames = this.eventFrame.values;
    let k = lowerBound(frames, this.eventFrame.length, step > 0 ? frame + 1 : frame) - (step > 0 ? 0 : 1);
    for (; k >= 0 && k < this.eventFrame.length && frames[k] >= begin && frames[k] < end; k += step)
      if (kind < 0 || this.eventKind.values[k] === kind) return frames[k];
    return -1;
  }
}

function checkWindow(window) {
  for (const name of ['seconds', 'characters'])
    if (object(window, 'window')[name] !== undefined) number(window[name], `window.${name}`);
}

/// The first position whose value is not less.
export function lowerBound(values, length, value) {
  let low = 0,
    high = length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}
