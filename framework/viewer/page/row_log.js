import { Column } from './column.js';
import { compose, inverse, wrapAngle } from './pose.js';
import { coordinate, integer, list, numberOrNull, optionalList, position, refuse } from './record_error.js';

const kNeverNumbers = { length: 0 };

/// Poses, log-likelihoods and probabilities of all live hypotheses, frame by frame, in flat arrays: the rows of frame f
/// are [begin(f), begin(f + 1)). Frame: map [m, rad]; log-likelihood [nat].
export class RowLog {
  constructor(units) {
    this.units = units;
    this.id = new Column(Int32Array, 1024);
    this.x = new Column(Float64Array, 1024);
    this.y = new Column(Float64Array, 1024);
    this.heading = new Column(Float32Array, 1024);
    this.nat = new Column(Float32Array, 1024);
    this.probability = new Column(Float32Array, 1024);
    this.begins = new Column(Int32Array);
    this.begins.push(0);
    this.tops = new Column(Int32Array); ///< rows with a probability worth writing, best first
    this.topBegins = new Column(Int32Array);
    this.topBegins.push(0);
    this.live = { id: [], x: [], y: [], heading: [], nat: [] };
    this.rowOf = new Map(); ///< id -> place in the list of rows
    this.stale = false; ///< rowOf is older than the list
    this.previous = null; ///< T_local_base of the frame before
  }

  /// Ids that a new time line ends.
  restart() {
    const ended = this.live.id;
    this.live = { id: [], x: [], y: [], heading: [], nat: [] };
    this.previous = null;
    this.stale = true;
    return ended;
  }

  append(record, T_local_base) {
    this.leave(optionalList(record.leave, 'leave'));
    this.carry(record.rows, T_local_base);
    this.enter(optionalList(record.enter, 'enter'));
    this.previous = T_local_base;
    this.store();
    this.weigh(optionalList(record.p, 'p'));
  }

  leave(places) {
    if (places.length === 0) return;
    let before = this.live.id.length;
    for (const place of places) before = position(place, before, 'leave, decreasing');
    const gone = new Set(places);
    for (const name of Object.keys(this.live)) this.live[name] = this.live[name].filter((_, k) => !gone.has(k));
    this.stale = true;
  }

  carry(rows, T_local_base) {
    const { live, units } = this,
      count = live.id.length;
    if (rows === undefined ? count > 0 : list(rows, 'rows').length !== 4) refuse('rows', `4 lists for ${count} rows`, rows);
    const columns = rows ?? [kNeverNumbers, kNeverNumbers, kNeverNumbers, kNeverNumbers];
    for (const column of columns) {
      if (column.length !== count) refuse('rows', `${count} in each list`, column.length);
      for (let k = 0; k < count; ++k) if (!Number.isInteger(column[k])) refuse(`rows[..][${k}]`, 'an integer', column[k]);
    }
    if (count === 0) return;
    const D = this.previous ? compose(inverse(this.previous), T_local_base) : [0, 0, 0];
    for (let k = 0; k < count; ++k) {
      const moved = compose([live.x[k], live.y[k], live.heading[k]], D);
      const next = compose(moved, [columns[0][k] * units.m, columns[1][k] * units.m, columns[2][k] * units.rad]);
      live.x[k] = coordinate(next[0], `rows[0][${k}]`);
      live.y[k] = coordinate(next[1], `rows[1][${k}]`);
      live.heading[k] = next[2];
      live.nat[k] += columns[3][k] * units.nat;
    }
  }

  enter(entries) {
    const { live, units } = this;
    for (const entry of entries) {
      const [id, x, y, heading, nat] = list(entry, 'enter');
      for (const value of entry) if (!Number.isInteger(value)) refuse('enter', '[id, x, y, heading, nat], integers', entry);
      live.id.push(integer(id, 'enter'));
      live.x.push(coordinate(x * units.m, 'enter'));
      live.y.push(coordinate(y * units.m, 'enter'));
      live.heading.push(wrapAngle(heading * units.rad));
      live.nat.push(nat * units.nat);
    }
    if (entries.length > 0) this.stale = true;
  }

  store() {
    const { live } = this;
    for (let k = 0; k < live.id.length; ++k) {
      this.id.push(live.id[k]);
      this.x.push(live.x[k]);
      this.y.push(live.y[k]);
      this.heading.push(live.heading[k]);
      this.nat.push(live.nat[k]);
      this.probability.push(0);
    }
    this.begins.push(this.id.length);
  }

  weigh(entries) {
    if (this.stale) {
      this.rowOf = new Map(this.live.id.map((id, k) => [id, k]));
      this.stale = false;
    }
    const begin = this.begins.values[this.begins.length - 2];
    for (const entry of entries) {
      const [id, value] = list(entry, 'p'),
        row = this.rowOf.get(id);
      if (row === undefined) refuse('p', 'the id of a hypothesis that is alive', id);
      this.probability.values[begin + row] = numberOrNull(value, 'p');
      this.tops.push(begin + row);
    }
    this.topBegins.push(this.tops.length);
  }

  begin(frame) {
    return this.begins.values[frame];
  }
  end(frame) {
    return this.begins.values[frame + 1];
  }

  /// Row of a hypothesis at a frame, or -1.
  find(frame, id) {
    if (id < 0) return -1;
    for (let row = this.begin(frame); row < this.end(frame); ++row) if (this.id.values[row] === id) return row;
    return -1;
  }

  poseOf(row) {
    return [this.x.values[row], this.y.values[row], this.heading.values[row]];
  }
}
