/// Shapes are {faces: [x, y, x, y, ...], circles: [x, y, r, ...], points: [x, y, ...]} in metres, as the program writes them.

/// The text of a path that draws them; points as small squares of `point_m`.
export function pathOf({ faces, circles, points }, point_m = 0.1) {
  const parts = [];
  for (let k = 0; k < faces.length; k += 4) parts.push(`M${faces[k]} ${faces[k + 1]}L${faces[k + 2]} ${faces[k + 3]}`);
  for (let k = 0; k < circles.length; k += 3) {
    const [x, y, r] = circles.slice(k, k + 3);
    parts.push(`M${x - r} ${y}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`);
  }
  const s = point_m;
  for (let k = 0; k < points.length; k += 2) parts.push(`M${points[k] - s / 2} ${points[k + 1] - s / 2}h${s}v${s}h${-s}z`);
  return parts.join('');
}

/// Grows a box [x, y, x, y] so that it holds them.
export function include(box, { faces, circles, points }) {
  const take = (x, y, r = 0) => {
    box[0] = Math.min(box[0], x - r);
    box[1] = Math.min(box[1], y - r);
    box[2] = Math.max(box[2], x + r);
    box[3] = Math.max(box[3], y + r);
  };
  for (let k = 0; k < faces.length; k += 2) take(faces[k], faces[k + 1]);
  for (let k = 0; k < circles.length; k += 3) take(circles[k], circles[k + 1], circles[k + 2]);
  for (let k = 0; k < points.length; k += 2) take(points[k], points[k + 1]);
  return box;
}

export const emptyBox = () => [Infinity, Infinity, -Infinity, -Infinity];
export const isEmpty = (box) => !(box[2] >= box[0]);

/// Around everything that a proposal is about: the object itself, and what would stand there.
export function boxOf({ picture, sights }) {
  const own = include(emptyBox(), picture.mapped);
  if (isEmpty(own) || sights.length === 0) include(own, picture.proposed);
  for (const sight of picture.sights) include(own, sight);
  return isEmpty(own) ? [0, 0, 1, 1] : own;
}
