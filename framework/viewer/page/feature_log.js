import { Column } from './column.js';
import { geometryOf } from './geometry.js';
import { flag, integer, list, optionalList, text } from './record_error.js';

/// The local features over time. A version is what a feature was from some frame on; `alive` lists the versions that
/// hold at each frame, one stretch per change, so that any frame is found at once. Frame: local.
export class FeatureLog {
  constructor() {
    this.versions = [];
    this.alive = new Column(Int32Array);
    this.begin = new Column(Int32Array); ///< per frame, into alive
    this.end = new Column(Int32Array);
    this.current = new Map(); ///< id -> version
  }

  append(record, starts) {
    const features = optionalList(record.features, 'features'),
      gone = optionalList(record.gone, 'gone');
    const changed = starts || features.length > 0 || gone.length > 0 || this.begin.length === 0;
    if (starts) this.current.clear();
    features.forEach((entry, k) => this.change(entry, `features[${k}]`));
    for (const id of gone) this.current.delete(integer(id, 'gone'));
    if (changed) this.list();
    else this.repeat();
  }

  change(entry, place) {
    const [id, type, stable, measurements, kind, ...numbers] = list(entry, place);
    this.current.set(integer(id, place), this.versions.length);
    this.versions.push({
      id,
      type: text(type, place),
      stable: flag(stable, place) === 1,
      measurements: integer(measurements, place),
      geometry: geometryOf(kind, numbers, place),
    });
  }

  list() {
    this.begin.push(this.alive.length);
    for (const version of this.current.values()) this.alive.push(version);
    this.end.push(this.alive.length);
  }

  repeat() {
    const last = this.begin.length - 1;
    this.begin.push(this.begin.values[last]);
    this.end.push(this.end.values[last]);
  }

  /// Calls back with each feature that is alive at a frame.
  forEach(frame, visit) {
    for (let k = this.begin.values[frame]; k < this.end.values[frame]; ++k) visit(this.versions[this.alive.values[k]]);
  }

  find(frame, id) {
    for (let k = this.begin.values[frame]; k < this.end.values[frame]; ++k) {
      const version = this.versions[this.alive.values[k]];
      if (version.id === id) return version;
    }
    return null;
  }
}
