/// A record that is not as README.md says. The message names the place, what was expected and what was found.
export class RecordError extends Error {}

/// Farther than any building: coordinates beyond are damage [m].
const kFarthest_m = 1e6;
const kLongest_excerpt = 60;

function excerpt(value) {
  if (value === undefined) return 'nothing';
  const text = JSON.stringify(value);
  return text.length > kLongest_excerpt ? `${text.slice(0, kLongest_excerpt)}…` : text;
}

export function refuse(place, expected, found) {
  throw new RecordError(`${place}: expected ${expected}, found ${excerpt(found)}`);
}

export function list(value, place) {
  if (!Array.isArray(value)) refuse(place, 'a list', value);
  return value;
}

/// A list that may be absent.
export const optionalList = (value, place) => (value === undefined ? [] : list(value, place));

export function text(value, place) {
  if (typeof value !== 'string') refuse(place, 'text', value);
  return value;
}

export function number(value, place) {
  if (typeof value !== 'number' || !Number.isFinite(value)) refuse(place, 'a number', value);
  return value;
}

/// A number, or `null` for what is no number.
export function numberOrNull(value, place) {
  return value === null || value === undefined ? NaN : number(value, place);
}

export function coordinate(value, place) {
  if (typeof value !== 'number' || !(Math.abs(value) <= kFarthest_m)) refuse(place, 'a coordinate within 1000 km', value);
  return value;
}

export function integer(value, place) {
  if (!Number.isInteger(value) || Math.abs(value) > 0x7fffffff) refuse(place, 'an integer', value);
  return value;
}

export function position(value, length, place) {
  if (!Number.isInteger(value) || value < 0 || value >= length) refuse(place, `a position below ${length}`, value);
  return value;
}

export function flag(value, place) {
  if (value !== 0 && value !== 1) refuse(place, '0 or 1', value);
  return value;
}

export function pose(value, place) {
  if (!Array.isArray(value) || value.length !== 3) refuse(place, '[x, y, heading]', value);
  value.forEach((v) => coordinate(v, place));
  return value;
}

export function object(value, place) {
  if (value === null || typeof value !== 'object' || Array.isArray(value)) refuse(place, 'an object', value);
  return value;
}
