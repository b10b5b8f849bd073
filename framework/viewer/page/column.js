/// A typed array that grows: amortised constant cost per push, read by `values[i]` for i < length.
export class Column {
  constructor(Type, capacity = 256) {
    this.values = new Type(capacity);
    this.length = 0;
  }

  push(value) {
    if (this.length === this.values.length) this.reserve(this.length + 1);
    this.values[this.length++] = value;
  }

  reserve(length) {
    if (length <= this.values.length) return;
    const grown = new this.values.constructor(Math.max(length, 2 * this.values.length));
    grown.set(this.values.subarray(0, this.length));
    this.values = grown;
  }
}
