import { coordinate, refuse } from './record_error.js';

/// The closed set of geometries: how many numbers each has.
const kNumbersOfKind = { point: 2, oriented_point: 4, segment: 4, circle: 3 };

/// `{kind, numbers}` from a kind and its numbers, checked.
export function geometryOf(kind, numbers, place) {
  const count = Object.hasOwn(kNumbersOfKind, kind) ? kNumbersOfKind[kind] : -1;
  if (count < 0) refuse(place, 'point, oriented_point, segment or circle', kind);
  if (!Array.isArray(numbers) || numbers.length !== count) refuse(place, `${count} numbers of a ${kind}`, numbers);
  numbers.forEach((value) => coordinate(value, place));
  return { kind, numbers };
}

/// From an object that has one geometry member, as events write it.
export function geometryMember(object, place) {
  for (const kind of Object.keys(kNumbersOfKind))
    if (Object.hasOwn(object, kind)) return geometryOf(kind, object[kind], `${place}.${kind}`);
  return refuse(place, 'a geometry', object);
}

/// Where a geometry is, if it has to be one point.
export function anchorOf({ kind, numbers: n }) {
  return kind === 'segment' ? [(n[0] + n[2]) / 2, (n[1] + n[3]) / 2] : [n[0], n[1]];
}

/// The point of a geometry that is nearest to (x, y): where a line can show which mapped feature is meant.
export function nearestOn(geometry, x, y) {
  const n = geometry.numbers;
  if (geometry.kind !== 'segment') return [n[0], n[1]];
  const dx = n[2] - n[0],
    dy = n[3] - n[1],
    square = dx * dx + dy * dy;
  if (!(square > 0)) return [n[0], n[1]];
  const part = Math.min(1, Math.max(0, ((x - n[0]) * dx + (y - n[1]) * dy) / square));
  return [n[0] + part * dx, n[1] + part * dy];
}

/// Distance of (x, y) to what is drawn of a geometry [m].
export function distanceTo(geometry, x, y) {
  const [nx, ny] = nearestOn(geometry, x, y);
  const distance_m = Math.hypot(x - nx, y - ny);
  return geometry.kind === 'circle' ? Math.abs(distance_m - geometry.numbers[2]) : distance_m;
}
