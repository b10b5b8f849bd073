import { anchorOf } from './geometry.js';
import { label } from './brush.js';
import { kMark } from './marks.js';
import { shortName } from './words_of.js';

/// The side of a face that cannot be seen is shaded this deep.
const kBody_m = 0.12,
  kBodyOpacity = 0.2,
  kWall_px = 1.6,
  kDash_px = 4,
  kNames_px = 46;

/// What is on the map, drawn once per view: paths are built once, in metres, one per colour.
export class MapLayer {
  constructor(map) {
    this.map = map;
    this.batches = new Map(); ///< colour type -> {solid, dashed, body, points}
    map.features.forEach((feature) => this.collect(feature));
    this.patterns = new Path2D();
    for (const pattern of map.patterns) this.link(pattern.features.map((number) => anchorOf(map.features[number].geometry)));
  }

  collect(feature) {
    if (!this.batches.has(feature.colorType))
      this.batches.set(feature.colorType, { solid: new Path2D(), dashed: new Path2D(), body: new Path2D(), points: [] });
    const batch = this.batches.get(feature.colorType),
      { kind, numbers: n } = feature.geometry;
    const path = feature.perceivable ? batch.solid : batch.dashed;
    if (kind === 'segment') {
      path.moveTo(n[0], n[1]);
      path.lineTo(n[2], n[3]);
      if (feature.perceivable) shadeBehind(batch.body, n);
    } else if (kind === 'circle') {
      path.moveTo(n[0] + Math.abs(n[2]), n[1]);
      path.arc(n[0], n[1], Math.abs(n[2]), 0, 2 * Math.PI);
    } else {
      batch.points.push(feature);
    }
  }

  link(points) {
    points.forEach(([x, y], k) => (k === 0 ? this.patterns.moveTo(x, y) : this.patterns.lineTo(x, y)));
    if (points.length > 2) this.patterns.closePath();
  }

  paint(context, view, palette, layers, marks) {
    marks.clear();
    if (layers.has('patterns')) this.paintPatterns(context, view, palette, marks);
    if (!layers.has('objects')) return;
    view.useMetres(context);
    for (const [type, batch] of this.batches) this.paintBatch(context, view, palette.type(this.map.types, type), batch, layers);
    view.usePixels(context);
    this.paintPoints(context, view, palette, layers);
    this.map.features.forEach((feature, number) => {
      if (!feature.perceivable && !layers.has('unperceivable')) return;
      const n = feature.geometry.numbers;
      marks.add(kMark.map_feature, number, n[0], n[1], n[2], n[3]);
    });
    if (layers.has('names')) this.paintNames(context, view, palette);
    this.paintStoreys(context, view, palette);
  }

  /// The name of each sheet above it.
  paintStoreys(context, view, palette) {
    context.font = `600 12px ${palette.font}`;
    context.textAlign = 'left';
    context.textBaseline = 'bottom';
    for (const { name, bounds } of this.map.storeys)
      label(context, name, view.x(bounds[0]), view.y(bounds[3]) - 4, palette.text, palette.plot);
  }

  paintBatch(context, view, color, batch, layers) {
    context.globalAlpha = kBodyOpacity;
    context.fillStyle = color;
    context.fill(batch.body);
    context.globalAlpha = 1;
    context.strokeStyle = color;
    context.lineWidth = kWall_px / view.scale;
    context.stroke(batch.solid);
    if (!layers.has('unperceivable')) return;
    context.setLineDash([kDash_px / view.scale, kDash_px / view.scale]);
    context.globalAlpha = 0.75;
    context.stroke(batch.dashed);
    context.globalAlpha = 1;
    context.setLineDash([]);
  }

  /// Points have no size of their own: squares; oriented points get their sides.
  paintPoints(context, view, palette, layers) {
    for (const [type, { points }] of this.batches) {
      context.fillStyle = context.strokeStyle = palette.type(this.map.types, type);
      context.lineWidth = 1.2;
      context.beginPath();
      for (const {
        geometry: { kind, numbers: n },
        perceivable,
      } of points) {
        if (!perceivable && !layers.has('unperceivable')) continue;
        const x = view.x(n[0]),
          y = view.y(n[1]);
        if (perceivable) context.fillRect(x - 2, y - 2, 4, 4);
        else context.rect(x - 2, y - 2, 4, 4);
        if (kind !== 'oriented_point') continue;
        for (const side of [-0.5, 0.5]) {
          context.moveTo(x, y);
          context.lineTo(x + 7 * Math.cos(n[2] + side * n[3]), y - 7 * Math.sin(n[2] + side * n[3]));
        }
      }
      context.stroke();
    }
  }

  paintPatterns(context, view, palette, marks) {
    view.useMetres(context);
    context.strokeStyle = palette.pattern;
    context.globalAlpha = 0.35;
    context.lineWidth = 1 / view.scale;
    context.setLineDash([6 / view.scale, 3 / view.scale]);
    context.stroke(this.patterns);
    context.setLineDash([]);
    context.globalAlpha = 1;
    view.usePixels(context);
    this.map.patterns.forEach(({ features }, k) => {
      const [x, y] = features.length > 0 ? anchorOf(this.map.features[features[0]].geometry) : [NaN, NaN];
      marks.add(kMark.pattern, k, x, y);
    });
  }

  /// As many names as there is room for: one per object, none closer than a word's width to another.
  paintNames(context, view, palette) {
    context.font = `11px ${palette.font}`;
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    const taken = new Set();
    for (const object of this.map.objects) {
      if (object.features.length === 0) continue;
      const [mx, my] = anchorOf(this.map.features[object.features[0]].geometry),
        x = view.x(mx),
        y = view.y(my);
      const cell = `${Math.floor(x / (2 * kNames_px))},${Math.floor(y / 16)}`;
      if (x < 0 || y < 0 || x > view.width || y > view.height || taken.has(cell)) continue;
      taken.add(cell);
      label(context, shorten(object.name || object.id), x, y - 3, palette.text, palette.plot);
    }
  }

  /// The feature that is nearest to a place of the map, within a distance; -1 if there is none.
  at(x, y, within_m, layers, distanceTo) {
    let found = -1,
      least = within_m;
    this.map.features.forEach((feature, number) => {
      if (!feature.perceivable && !layers.has('unperceivable')) return;
      const distance_m = distanceTo(feature.geometry, x, y);
      if (distance_m >= least) return;
      least = distance_m;
      found = number;
    });
    return found;
  }
}

function shadeBehind(path, [x, y, u, v]) {
  const length = Math.hypot(u - x, v - y);
  if (!(length > 0)) return;
  const nx = ((v - y) / length) * kBody_m,
    ny = (-(u - x) / length) * kBody_m; // right of the direction: not visible
  path.moveTo(x, y);
  path.lineTo(u, v);
  path.lineTo(u + nx, v + ny);
  path.lineTo(x + nx, y + ny);
  path.closePath();
}

const kLongestName = 28;
const shorten = (name) => (name.length > kLongestName ? `${name.slice(0, kLongestName - 1)}…` : name);

/// `wall-3 · Wall · wall-3/face-1`
export function featureWords(map, number) {
  const feature = map.features[number],
    object = map.objects[feature.object];
  const parts = object ? [`${object.name ? `${object.name} · ` : ''}${object.id} · ${shortName(object.type)}`] : [];
  parts.push(`${feature.id} · ${shortName(feature.type)}${feature.perceivable ? '' : ' · not seen by this sensor'}`);
  return parts.join('\n');
}
