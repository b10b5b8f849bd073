/// Colours by meaning, read from style.css, where light and dark are defined once for page and canvas.
const kInks = [
  'paper',
  'plot',
  'text',
  'faint',
  'grid',
  'free',
  'scan',
  'local',
  'candidate',
  'match',
  'association',
  'best',
  'alternative',
  'selected',
  'trajectory',
  'truth',
  'finding',
  'pattern',
  'run-a',
  'run-b',
];
const kStatusInks = ['searching', 'ambiguous', 'localized', 'lost'];
const kOtherTypes = 4;
const kOwnTypes = { 'opal:Wall': 'wall', 'opal:Column': 'column', 'opal:Door': 'door', 'opal:Window': 'window' };

export function readPalette() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  const palette = Object.fromEntries(kInks.map((name) => [name.replace(/-(.)/g, (_, c) => c.toUpperCase()), read(name)]));
  palette.status = kStatusInks.map((name) => read(`status-${name}`));
  palette.font = style.getPropertyValue('--font').trim();
  palette.type = (types, type) =>
    Object.hasOwn(kOwnTypes, type)
      ? read(`type-${kOwnTypes[type]}`)
      : read(`type-other-${1 + (types.indexOf(type) % kOtherTypes)}`);
  return palette;
}
