import { geometryMember } from './geometry.js';
import { list, object, position, text } from './record_error.js';

/// What the map holds for the sensor of a run: objects, features, patterns; from the `map` record. Frame: map.
export class RunMap {
  constructor(record) {
    this.name = text(record.name ?? '', 'name');
    this.objects = list(record.objects, 'objects').map((entry, k) => {
      const [id, type, name = ''] = list(entry, `objects[${k}]`);
      return {
        id: text(id, `objects[${k}]`),
        type: text(type, `objects[${k}]`),
        name: text(name, `objects[${k}]`),
        features: [],
      };
    });
    this.features = list(record.features, 'features').map((entry, k) => this.featureOf(entry, `features[${k}]`, k));
    const numbers = new Map(this.features.map((feature, k) => [feature.id, k]));
    this.patterns = list(record.patterns ?? [], 'patterns').map((entry, k) => patternOf(entry, `patterns[${k}]`, numbers));
    this.storeys = list(record.storeys ?? [], 'storeys').map((entry, k) => storeyOf(entry, `storeys[${k}]`));
    this.types = [...new Set(this.features.map((feature) => feature.colorType))].sort();
    this.bounds = boundsOf(this.features);
  }

  featureOf(entry, place, number) {
    object(entry, place);
    const owner =
      entry.object === null || entry.object === undefined || entry.object === -1
        ? -1
        : position(entry.object, this.objects.length, `${place}.object`);
    if (owner >= 0) this.objects[owner].features.push(number);
    const type = text(entry.type, `${place}.type`);
    return {
      id: text(entry.id, `${place}.id`),
      object: owner,
      type,
      perceivable: entry.perceivable !== false,
      geometry: geometryMember(entry, place),
      colorType: owner >= 0 ? this.objects[owner].type : type,
    };
  }

  /// In words, for a mapped feature as records name it: its position, or -1.
  nameOf(feature) {
    return feature < 0 ? 'not on the map' : (this.features[feature]?.id ?? `feature ${feature}`);
  }
}

function patternOf(entry, place, numbers) {
  object(entry, place);
  const features = list(entry.features, `${place}.features`)
    .map((id) => (typeof id === 'number' ? id : numbers.get(id)))
    .filter((number) => number !== undefined && number >= 0 && number < numbers.size);
  return { id: text(entry.id ?? '', `${place}.id`), template: text(entry.template ?? '', `${place}.template`), features };
}

/// A sheet of a map that holds several storeys, and where it lies.
function storeyOf(entry, place) {
  object(entry, place);
  const bounds = list(entry.bounds, `${place}.bounds`);
  if (bounds.length !== 4 || !bounds.every(Number.isFinite)) throw new Error(`${place}.bounds: expected four numbers`);
  return { id: text(entry.id, `${place}.id`), name: text(entry.name ?? '', `${place}.name`) || entry.id, bounds };
}

/// [least x, least y, greatest x, greatest y] of what is drawn; a square of 10 m if that is nothing.
function boundsOf(features) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  const cover = (x, y, r = 0) => {
    box[0] = Math.min(box[0], x - r);
    box[1] = Math.min(box[1], y - r);
    box[2] = Math.max(box[2], x + r);
    box[3] = Math.max(box[3], y + r);
  };
  for (const {
    geometry: { kind, numbers: n },
  } of features) {
    cover(n[0], n[1], kind === 'circle' ? Math.abs(n[2]) : 0);
    if (kind === 'segment') cover(n[2], n[3]);
  }
  return box[0] <= box[2] ? box : [-5, -5, 5, 5];
}
