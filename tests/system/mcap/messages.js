// Messages of ROS 2 as plain little-endian CDR.

class Cdr {
  constructor() {
    this.bytes = [0, 1, 0, 0];
  }
  number(value, size, set) {
    while ((this.bytes.length - 4) % size !== 0) this.bytes.push(0);
    const view = new DataView(new ArrayBuffer(size));
    view[set](0, value, true);
    this.bytes.push(...new Uint8Array(view.buffer));
    return this;
  }
  uint(value) { return this.number(value, 4, "setUint32"); }
  float(value) { return this.number(value, 4, "setFloat32"); }
  double(value) { return this.number(value, 8, "setFloat64"); }
  text(value) {
    this.uint(value.length + 1);
    this.bytes.push(...new TextEncoder().encode(value), 0);
    return this;
  }
  header(stamp_s, frame) {
    return this.uint(Math.floor(stamp_s)).uint(Math.round((stamp_s % 1) * 1e9)).text(frame);
  }
  whole() { return new Uint8Array(this.bytes); }
}

export function laserScan(stamp_s, ranges_m) {
  const cdr = new Cdr().header(stamp_s, "laser");
  for (const value of [-1, 1, 0.01, 0.0005, 0.1, 0.1, 12]) cdr.float(value);
  cdr.uint(ranges_m.length);
  for (const range_m of ranges_m) cdr.float(range_m);
  return cdr.uint(0).whole();
}

export function odometry(stamp_s, x_m) {
  const cdr = new Cdr().header(stamp_s, "odom").text("base_link");
  for (const value of [x_m, 0, 0, 0, 0, 0, 1]) cdr.double(value);
  for (let i = 0; i < 36 + 6 + 36; ++i) cdr.double(0);
  return cdr.whole();
}
