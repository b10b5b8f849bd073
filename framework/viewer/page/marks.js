/// What was painted, as the painting code reports it, mark by mark: kind, who it is, and where in the frame of the pane [m].
/// For tests and the curious; cheap enough to be always on.
const kMarkKinds = [
  'map_feature',
  'pattern',
  'free_space',
  'scan',
  'trajectory',
  'truth',
  'local_feature',
  'association',
  'hypothesis',
  'selected',
  'finding',
  'ended',
  'rejected',
  'robot',
  'observed_pattern',
];

export class Marks {
  constructor() {
    this.kind = new Uint8Array(1024);
    this.ids = new Int32Array(3 * 1024);
    this.places = new Float64Array(4 * 1024);
    this.count = 0;
  }

  clear() {
    this.count = 0;
  }

  /// `other` and `third` say more about some kinds: association: local feature, mapped feature; local_feature: 0 candidate, 1 stable.
  add(kind, id, x, y, u = NaN, v = NaN, other = -1, third = -1) {
    if (this.count === this.kind.length) this.grow();
    const k = this.count++;
    this.kind[k] = kind;
    this.ids[3 * k] = id;
    this.ids[3 * k + 1] = other;
    this.ids[3 * k + 2] = third;
    this.places[4 * k] = x;
    this.places[4 * k + 1] = y;
    this.places[4 * k + 2] = u;
    this.places[4 * k + 3] = v;
  }

  grow() {
    const double = (old) => {
      const array = new old.constructor(2 * old.length);
      array.set(old);
      return array;
    };
    this.kind = double(this.kind);
    this.ids = double(this.ids);
    this.places = double(this.places);
  }

  list() {
    return Array.from({ length: this.count }, (_, k) => ({
      kind: kMarkKinds[this.kind[k]],
      id: this.ids[3 * k],
      other: this.ids[3 * k + 1],
      third: this.ids[3 * k + 2],
      x: this.places[4 * k],
      y: this.places[4 * k + 1],
      u: this.places[4 * k + 2],
      v: this.places[4 * k + 3],
    }));
  }
}

export const kMark = Object.fromEntries(kMarkKinds.map((name, k) => [name, k]));
