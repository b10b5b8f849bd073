import { Column } from './column.js';
import { FeatureLog } from './feature_log.js';
import { HypothesisLog, findingsOf } from './hypothesis_log.js';
import { PointLog } from './point_log.js';
import { compose, inverse } from './pose.js';
import { RecordError, integer, list, number, numberOrNull, object, optionalList, pose, refuse, text } from './record_error.js';
import { RowLog } from './row_log.js';
import { RunMap } from './run_map.js';

export const kStatuses = ['searching', 'ambiguous', 'localized', 'lost'];
/// What one can jump to, each with how the page calls it.
export const kEventKinds = ['status', 'born', 'ended', 'search'];

const kNone = [];

/// A whole run, decoded: append() takes one record after the other; all else reads. Frame f is the update number f of
/// the file. What is only needed of the moment on show (words, scores, cost) is read from the record itself, by detail().
export class Recording {
  constructor(name) {
    this.name = name;
    this.header = null;
    this.map = null;
    this.records = 0;
    this.windows = [];  ///< {name, begin, end}: time lines, by frames
    this.hypotheses = new HypothesisLog();
    this.features = new FeatureLog();
    this.lines = [];
    const ints = ['keyframe', 'window', 'best', 'bestRow', 'wordsFrame', 'searchFrame'];
    const floats = ['time', 'stamp', 'probability', 'none', 'x', 'y', 'heading', 'truthX', 'truthY', 'truthHeading', 'error', 'cpu'];
    for (const column of ints) this[column] = new Column(Int32Array);
    for (const column of floats) this[column] = new Column(Float64Array);
    this.status = new Column(Uint8Array);
    this.matched = new Column(Uint8Array);
    this.eventFrame = new Column(Int32Array);
    this.eventKind = new Column(Uint8Array);
    this.endedBy = new Map();    ///< frame -> hypotheses
    this.refusedBy = new Map();  ///< frame -> places
    this.detailOf = { frame: -1, record: null };
    this.searchOf = { frame: -1, search: null };
    this.findingsOf = { frame: -1, findings: [] };
    this.wordsOf = { frame: -1, words: [] };
  }

  get frames() { return this.lines.length; }

  /// Throws RecordError; what was appended before stays as it was.
  append(line) {
    const number = this.records + 1;
    let record;
    try {
      record = JSON.parse(line);
    } catch {
      throw new RecordError(`record ${number}: expected a JSON object, found ${JSON.stringify(line.slice(0, 40))}${line.length > 40 ? '…' : ''}`);
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
      m: number(record.unit_m, 'unit_m'), rad: number(record.unit_rad, 'unit_rad'), nat: number(record.unit_nat, 'unit_nat'),
    };
    const scan_m = number(record.scan_unit_m, 'scan_unit_m');
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
    const frame = this.frames, first = frame === 0;
    const now = this.check(record, first);
    if (now.starts) this.startWindow(text(record.start ?? '', 'start'), frame);
    this.rows.append(record, now.local);
    this.features.append(record, now.starts);
    this.takeHistory(record, frame);
    this.scan.append(record.scan, 'scan');
    this.free.append(record.free, 'free');
    this.takeMoment(record, now, frame);
    this.lines.push(line);
    this.windows[this.windows.length - 1].end = frame + 1;
  }

  /// What has to be right before anything of the frame is taken.
  check(record, first) {
    const starts = record.start !== undefined || first;
    const time = number(record.time, 'time');
    if (!starts && time < this.time.values[this.frames - 1])
      refuse('time', `not before ${this.time.values[this.frames - 1]}`, time);
    const status = kStatuses.indexOf(record.status);
    if (status < 0) refuse('status', kStatuses.join(', '), record.status);
    if (record.scores !== undefined) list(record.scores, 'scores');
    if (record.cpu !== undefined) object(record.cpu, 'cpu');
    if (record.search !== undefined) checkSearch(record.search);
    if (record.words !== undefined) checkWords(record.words);
    findingsOf(record.findings, this.map.features.length, 'findings');
    return {
      starts, time, status, local: pose(record.local, 'local'), stamp: number(record.stamp, 'stamp'),
      keyframe: integer(record.keyframe, 'keyframe'), best: integer(record.best ?? -1, 'best'),
      truth: record.truth === undefined || record.truth === null ? null : pose(record.truth, 'truth'),
    };
  }

  startWindow(name, frame) {
    for (const id of this.rows.restart()) this.hypotheses.voided(id, frame);
    this.windows.push({ name, begin: frame, end: frame });
  }

  takeHistory(record, frame) {
    const each = (name) => {
      const entries = optionalList(record[name], name);
      entries.forEach((entry, k) => this.hypotheses[name](entry, frame, `${name}[${k}]`));
      return entries.length > 0;
    };
    const born = each('born');
    each('lost');  // before they grow: the same local feature may find another counterpart
    each('grown');
    each('tried');
    const ended = each('ended');
    for (let row = this.rows.begin(frame); row < this.rows.end(frame); ++row)
      this.hypotheses.of(this.rows.id.values[row], frame, 'enter');
    if (ended) this.endedBy.set(frame, record.ended.map(([id]) => this.hypotheses.byId.get(id)));
    if (record.search?.rejected?.length) this.refusedBy.set(frame, record.search.rejected.map(([, x, y]) => [x, y]));
    if (born) this.mark(frame, 'born');
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

  /// The record of a frame, as written.
  detail(frame) {
    if (this.detailOf.frame !== frame) this.detailOf = { frame, record: JSON.parse(this.lines[frame]) };
    return this.detailOf.record;
  }

  wordsAt(frame) {
    const from = this.wordsFrame.values[frame];
    if (from < 0) return [];
    if (this.wordsOf.frame !== from) this.wordsOf = { frame: from, words: JSON.parse(this.lines[from]).words };
    return this.wordsOf.words;
  }

  /// Hypotheses that ended in a frame, and places that its search refused.
  endedAt(frame) { return this.endedBy.get(frame) ?? kNone; }
  refusedAt(frame) { return this.refusedBy.get(frame) ?? kNone; }

  /// The search of a frame that has one.
  searchAt(frame) {
    if (this.searchOf.frame !== frame) this.searchOf = { frame, search: JSON.parse(this.lines[frame]).search };
    return this.searchOf.search;
  }

  /// About the best hypothesis of a frame.
  findingsAt(frame) {
    if (this.findingsOf.frame !== frame)
      this.findingsOf = { frame, findings: findingsOf(this.detail(frame).findings, this.map.features.length, 'findings') };
    return this.findingsOf.findings;
  }

  localPose(frame) { return [this.x.values[frame], this.y.values[frame], this.heading.values[frame]]; }

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
  registrationAt(frame, T_map_base) { return compose(T_map_base, inverse(this.localPose(frame))); }

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

/// The first position whose value is not less.
export function lowerBound(values, length, value) {
  let low = 0, high = length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

function checkSearch(search) {
  object(search, 'search');
  for (const entry of optionalList(search.patterns, 'search.patterns')) {
    const [template, locals] = list(entry, 'search.patterns');
    text(template, 'search.patterns');
    list(locals, 'search.patterns').forEach((id) => integer(id, 'search.patterns'));
  }
  for (const entry of optionalList(search.rejected, 'search.rejected')) {
    const [, x, y, heading, , pairs, reason] = list(entry, 'search.rejected');
    pose([x, y, heading], 'search.rejected');
    list(pairs, 'search.rejected').forEach((pair) => list(pair, 'search.rejected'));
    text(reason, 'search.rejected');
  }
}

function checkWords(words) {
  for (const entry of list(words, 'words')) {
    const [kind, sentence] = list(entry, 'words');
    text(kind, 'words');
    text(sentence, 'words');
  }
}
