/// Poses in the plane as [x, y, heading] [m, m, rad], named T_to_from as in the framework.

const kTurn_rad = 2 * Math.PI;

/// Into [-pi, pi).
export function wrapAngle(angle_rad) {
  return angle_rad - kTurn_rad * Math.floor((angle_rad + Math.PI) / kTurn_rad);
}

export function compose(a, b) {
  const c = Math.cos(a[2]),
    s = Math.sin(a[2]);
  return [a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], wrapAngle(a[2] + b[2])];
}

export function inverse(a) {
  const c = Math.cos(a[2]),
    s = Math.sin(a[2]);
  return [-c * a[0] - s * a[1], s * a[0] - c * a[1], wrapAngle(-a[2])];
}

export function transformPoint(a, x, y) {
  const c = Math.cos(a[2]),
    s = Math.sin(a[2]);
  return [a[0] + c * x - s * y, a[1] + s * x + c * y];
}
