/// Primitives of drawing on a pane, in pixels; nothing is allocated.

const kArrowBack = 0.62,
  kArrowNotch = 0.3,
  kArrowHalf = 0.5;

/// The outline of a dart whose middle is at (x, y), nose along the heading (y up).
export function dartPath(context, x, y, heading_rad, size_px) {
  const c = Math.cos(heading_rad) * size_px,
    s = -Math.sin(heading_rad) * size_px;
  context.moveTo(x + c * kArrowBack, y + s * kArrowBack);
  context.lineTo(x - c * kArrowBack - s * kArrowHalf, y - s * kArrowBack + c * kArrowHalf);
  context.lineTo(x - c * kArrowNotch, y - s * kArrowNotch);
  context.lineTo(x - c * kArrowBack + s * kArrowHalf, y - s * kArrowBack - c * kArrowHalf);
  context.closePath();
}

export function crossPath(context, x, y, half_px) {
  context.moveTo(x - half_px, y - half_px);
  context.lineTo(x + half_px, y + half_px);
  context.moveTo(x - half_px, y + half_px);
  context.lineTo(x + half_px, y - half_px);
}

/// The outline of a geometry after a rigid motion (cos, sin, x, y), in a pane.
export function geometryPath(context, view, { kind, numbers: n }, c = 1, s = 0, tx = 0, ty = 0) {
  const x = view.x(tx + c * n[0] - s * n[1]),
    y = view.y(ty + s * n[0] + c * n[1]);
  if (kind === 'segment') {
    context.moveTo(x, y);
    context.lineTo(view.x(tx + c * n[2] - s * n[3]), view.y(ty + s * n[2] + c * n[3]));
  } else if (kind === 'circle') {
    const r = Math.max(1.5, Math.abs(n[2]) * view.scale);
    context.moveTo(x + r, y);
    context.arc(x, y, r, 0, 2 * Math.PI);
  } else if (kind === 'oriented_point') {
    const heading = n[2] + Math.atan2(s, c);
    for (const side of [-0.5, 0.5]) {
      const a = heading + side * n[3];
      context.moveTo(x, y);
      context.lineTo(x + 9 * Math.cos(a), y - 9 * Math.sin(a));
    }
  } else {
    context.moveTo(x + 3, y);
    context.arc(x, y, 3, 0, 2 * Math.PI);
  }
}

/// Words with a halo of paper, so that they can be read on top of anything.
export function label(context, words, x, y, ink, paper) {
  context.lineWidth = 3.5;
  context.lineJoin = 'round';
  context.strokeStyle = paper;
  context.strokeText(words, x, y);
  context.fillStyle = ink;
  context.fillText(words, x, y);
}

const kMostGridLines = 12,
  kLongestBar_px = 140;

/// The distance between grid lines: 1, 2 or 5 times a power of ten.
function gridStep_m(extent_m) {
  const least = extent_m / kMostGridLines,
    power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * power).find((step) => step >= least);
}

export function paintGrid(context, view, ink) {
  const step = gridStep_m(Math.max(view.width, view.height) / view.scale);
  context.strokeStyle = ink;
  context.lineWidth = 1;
  context.beginPath();
  for (let x = Math.ceil(view.mapX(0) / step) * step; view.x(x) < view.width; x += step) {
    const at = Math.round(view.x(x)) + 0.5;
    context.moveTo(at, 0);
    context.lineTo(at, view.height);
  }
  for (let y = Math.ceil(view.mapY(view.height) / step) * step; view.y(y) > 0; y += step) {
    const at = Math.round(view.y(y)) + 0.5;
    context.moveTo(0, at);
    context.lineTo(view.width, at);
  }
  context.stroke();
}

/// A bar of 1, 2 or 5 times a power of ten metres, bottom left.
export function paintScaleBar(context, view, palette) {
  const most_m = kLongestBar_px / view.scale,
    power = 10 ** Math.floor(Math.log10(most_m));
  const length = [5, 2, 1].map((factor) => factor * power).find((m) => m <= most_m) ?? power;
  const words = length >= 1 ? `${length} m` : `${Math.round(length * 100)} cm`;
  const x = 14,
    y = view.height - 14;
  context.strokeStyle = palette.faint;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(x, y - 4);
  context.lineTo(x, y);
  context.lineTo(x + length * view.scale, y);
  context.lineTo(x + length * view.scale, y - 4);
  context.stroke();
  context.font = `11px ${palette.font}`;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  label(context, words, x + 5, y - 5, palette.faint, palette.plot);
}
