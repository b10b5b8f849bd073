/// How numbers and names are written.

const kMinus = '\u2212';

export function fixed(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  const text = Math.abs(value) >= 1e7 ? value.toExponential(2) : value.toFixed(digits);
  return text.replace('-', kMinus);
}

export const seconds = (value) => `${fixed(value, 2)} s`;
export const degrees = (value_rad) => `${fixed((value_rad * 180) / Math.PI, 1)}°`;
export const poseWords = (pose) =>
  pose ? `(${fixed(pose[0], 2)}, ${fixed(pose[1], 2)}) m, ${degrees(pose[2])}` : 'not recorded';

/// 0.98; what is below the records' resolution is said to be.
export const probabilityWords = (value) =>
  value > 0 ? (value >= 0.9995 ? '1.00' : value.toFixed(value < 0.0995 ? 3 : 2)) : '< 0.001';

/// A local feature by its number; -1 is one that the local map could not use.
export const localName = (local) => (local < 0 ? 'none' : String(local));

/// `{7, 12} -> {wall-3, not on the map}`
export function nodeWords(pairs, map) {
  if (pairs.length === 0) return 'no associations';
  const mapped = [...new Set(pairs.map(([, feature]) => map.nameOf(feature)))];
  return `{${pairs.map(([local]) => localName(local)).join(', ')}} → {${mapped.join(', ')}}`;
}

/// The last part of a prefixed name: `opal:LShape` is `LShape`.
export const shortName = (name) => name.slice(name.lastIndexOf(':') + 1);
