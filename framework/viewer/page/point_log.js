import { Column } from './column.js';
import { coordinate, optionalList, refuse } from './record_error.js';

/// Point lists, frame by frame, in one flat array [x, y, x, y, ...] [m]: points of frame f are [begin(f), begin(f + 1)).
export class PointLog {
  constructor(unit_m) {
    this.unit_m = unit_m;
    this.xy = new Column(Float32Array, 4096);
    this.begins = new Column(Int32Array);
    this.begins.push(0);
  }

  append(differences, place) {
    const numbers = optionalList(differences, place);
    if (numbers.length % 2 !== 0) refuse(place, 'pairs of x and y', numbers.length);
    let x = 0,
      y = 0;
    for (let k = 0; k < numbers.length; k += 2) {
      if (!Number.isInteger(numbers[k]) || !Number.isInteger(numbers[k + 1])) refuse(place, 'integers', numbers.slice(k, k + 2));
      x += numbers[k];
      y += numbers[k + 1];
      this.xy.push(coordinate(x * this.unit_m, place));
      this.xy.push(coordinate(y * this.unit_m, place));
    }
    this.begins.push(this.xy.length);
  }

  begin(frame) {
    return this.begins.values[frame];
  }
  end(frame) {
    return this.begins.values[frame + 1];
  }
}
