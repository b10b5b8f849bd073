/// A synthetic run as records of framework/viewer/page/README.md: a robot on a round through a hall, hypotheses at places that
/// look alike, most of which fall. Returns `{lines, truth}`; truth[f] is what the page has to show of frame f.
import { compose, inverse, wrapAngle } from '../../../framework/viewer/page/pose.js';

export const kUnits = { unit_m: 0.01, unit_rad: 0.002, unit_nat: 0.02, scan_unit_m: 0.01 };
const kWidth_m = 40,
  kDepth_m = 22,
  kPeriod_s = 0.2,
  kRange_m = 12;
const kStages = ['detect', 'local_map', 'track', 'seed', 'grow'];

export function syntheticRun({
  frames = 60,
  hypotheses = 12,
  beams = 90,
  seed = 7,
  windows = 1,
  truthKnown = true,
  log = 'hall.log',
  config = 'usual.jsonld',
  stampShift = 0,
  names = (k) => k,
} = {}) {
  const random = mulberry(seed);
  const map = hall(names);
  const lines = [
    JSON.stringify({
      r: 'run',
      format: 3,
      opal: '0.9',
      log,
      config,
      map: 'hall.jsonld',
      sensor: 'laser',
      T_base_laser: [0, 0, 0],
      range_max_m: kRange_m,
      ...kUnits,
      reduced: ['Scans are thinned to every second point.'],
    }),
    JSON.stringify({ r: 'map', ...map }),
  ];
  const run = { random, map, lines, truth: [], hypotheses, beams, truthKnown, nextId: 0, stampShift };
  for (let window = 0; window < windows; ++window) simulateWindow(run, window, Math.ceil(frames / windows));
  return { lines, truth: run.truth, map };
}

export function mulberry(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

function hall(names) {
  const objects = [],
    features = [];
  const add = (id, type, geometries) => {
    objects.push([names(id), type]);
    for (const [part, featureType, geometry, perceivable = true] of geometries)
      features.push({ id: names(`${id}/${part}`), object: objects.length - 1, type: featureType, perceivable, ...geometry });
  };
  const wall = (id, x, y, u, v) => {
    const length = Math.hypot(u - x, v - y),
      nx = (-(v - y) / length) * 0.1,
      ny = ((u - x) / length) * 0.1;
    add(id, 'opal:Wall', [
      ['face-1', 'opal:Line', { segment: [x + nx, y + ny, u + nx, v + ny] }],
      ['face-2', 'opal:Line', { segment: [u - nx, v - ny, x - nx, y - ny] }],
    ]);
  };
  wall('wall-1', 0, 0, kWidth_m, 0);
  wall('wall-2', kWidth_m, 0, kWidth_m, kDepth_m);
  wall('wall-3', kWidth_m, kDepth_m, 0, kDepth_m);
  wall('wall-4', 0, kDepth_m, 0, 0);
  wall('wall-5', 14, 0, 14, 6);
  wall('wall-6', 26, kDepth_m, 26, 15);
  for (let k = 0; k < 8; ++k)
    add(`column-${k + 1}`, 'opal:Column', [['circle', 'opal:Circle', { circle: [5 + 10 * (k % 4), k < 4 ? 7.5 : 14.5, 0.3] }]]);
  add('door-1', 'opal:Door', [['leaf', 'opal:DoorLeaf', { segment: [19, 0.1, 20.2, 0.1] }, false]]);
  add('corner-1', 'opal:Corner', [['tip', 'opal:Corner', { oriented_point: [0.1, 0.1, Math.PI / 4, Math.PI / 2] }]]);
  const patterns = [0, 1, 2].map((k) => ({
    id: `pattern-${k}`,
    template: 'opal:ColumnPair',
    features: [features[12 + k].id, features[13 + k].id],
  }));
  return { name: 'hall', objects, features, patterns };
}

function simulateWindow(run, window, frames) {
  const { random, hypotheses } = run;
  const alive = [];
  let previous = null,
    drift = 0;
  const known = new Map();
  for (let k = 0; k < frames; ++k) {
    const time = k * kPeriod_s,
      a = (2 * Math.PI * time) / 90;
    const T_map_base = [20 + 12 * Math.cos(a), 11 + 6 * Math.sin(a), wrapAngle(a + Math.PI / 2)];
    drift += 0.0004 * (random() - 0.4);
    const start = (run.start = k === 0 ? T_map_base : run.start);
    const local = compose([0, 0, drift], compose(inverse(start), T_map_base)).map((v) => Math.round(v * 1e4) / 1e4);
    const frame = { r: 'frame', keyframe: k, stamp: 100 + run.stampShift + time, time, local, match: 1 };
    if (k === 0) frame.start = run.map.name === 'hall' && window === 0 ? 'run' : `window-${window}`;
    frame.scan = encodePoints(scanFrom(run.map, T_map_base, run.beams, random));
    frame.free = encodePoints(scanFrom(run.map, T_map_base, 24, () => 0.5).map(([x, y]) => [0.85 * x, 0.85 * y]));
    localFeatures(run, frame, known, T_map_base, local, k);
    const ended = evolve(run, frame, alive, T_map_base, k, known, hypotheses);
    const D = previous ? compose(inverse(previous), local) : [0, 0, 0];
    encodeRows(frame, alive, ended, D);
    weigh(frame, alive, run, T_map_base, k);
    previous = local;
    run.lines.push(JSON.stringify(frame));
    run.truth.push(expectation(frame, alive, known, window));
  }
}

function encodePoints(points) {
  const numbers = [];
  let before = [0, 0];
  for (const point of points) {
    const now = point.map((v) => Math.round(v / kUnits.scan_unit_m));
    numbers.push(now[0] - before[0], now[1] - before[1]);
    before = now;
  }
  return numbers;
}

function scanFrom(map, pose, beams, random) {
  const points = [];
  for (let k = 0; k < beams; ++k) {
    const bearing = -Math.PI + (2 * Math.PI * k) / beams,
      heading = pose[2] + bearing;
    const range = Math.min(kRange_m, ...map.features.map((feature) => rangeTo(feature, pose, heading))) + 0.02 * (random() - 0.5);
    points.push([range * Math.cos(bearing), range * Math.sin(bearing)]);
  }
  return points;
}

function rangeTo({ segment, circle }, [x, y], heading) {
  const c = Math.cos(heading),
    s = Math.sin(heading);
  if (circle) {
    const along = (circle[0] - x) * c + (circle[1] - y) * s,
      aside = -(circle[0] - x) * s + (circle[1] - y) * c;
    return along > 0 && Math.abs(aside) < circle[2] ? along - Math.sqrt(circle[2] ** 2 - aside ** 2) : Infinity;
  }
  if (!segment) return Infinity;
  const ex = segment[2] - segment[0],
    ey = segment[3] - segment[1],
    det = ex * s - ey * c;
  if (Math.abs(det) < 1e-12) return Infinity;
  const t = (ex * (segment[1] - y) - ey * (segment[0] - x)) / det,
    u = (c * (segment[1] - y) - s * (segment[0] - x)) / det;
  return t > 0 && u >= 0 && u <= 1 ? t : Infinity;
}

/// Mapped features within sight become local ones, with the number of the mapped one plus 100 per window.
function localFeatures(run, frame, known, T_map_base, local, k) {
  if (k % 5 !== 0) return;
  const T_local_map = compose(local, inverse(T_map_base)),
    changed = [],
    gone = [];
  run.map.features.forEach((feature, number) => {
    const [kind, numbers] = Object.entries(feature).find(([name]) => ['segment', 'circle', 'oriented_point'].includes(name));
    const near = Math.hypot(numbers[0] - T_map_base[0], numbers[1] - T_map_base[1]) < 14,
      id = 100 + number;
    if (!near && known.has(id)) {
      known.delete(id);
      gone.push(id);
    }
    if (!near || !feature.perceivable) return;
    const measurements = (known.get(id)?.measurements ?? 0) + 1;
    const [x, y] = compose(T_local_map, [numbers[0], numbers[1], 0]),
      end = compose(T_local_map, [numbers[2], numbers[3], 0]);
    const placed = {
      segment: () => [x, y, end[0], end[1]],
      circle: () => [x, y, numbers[2]],
      oriented_point: () => [x, y, numbers[2] + T_local_map[2], numbers[3]],
    }[kind]();
    known.set(id, { id, mapped: number, measurements, stable: measurements >= 3 });
    changed.push([id, feature.type, measurements >= 3 ? 1 : 0, measurements, kind, ...placed]);
  });
  if (changed.length > 0) frame.features = changed;
  if (gone.length > 0) frame.gone = gone;
}

/// Spawns, growth and ends of a frame; returns the positions of rows that leave.
function evolve(run, frame, alive, T_map_base, k, known, wanted) {
  const { random } = run,
    ended = [];
  const stable = [...known.values()].filter((feature) => feature.stable);
  const pairOf = ({ id, mapped }, wrong) => [id, wrong ? (mapped + 2) % run.map.features.length : mapped];
  if (k > 0 && k % 7 === 0) {
    for (let position = alive.length - 1; position > 0; --position) {
      if (ended.length > 0 && random() > 0.3 * (alive.length > wanted / 8 ? 1 : 0)) continue;
      if (alive.length - ended.length <= Math.max(2, wanted * 0.9)) break;
      ended.push(position);
      end(run, frame, alive[position], k);
    }
  }
  if (k % 7 === 0 && alive.length - ended.length < wanted)
    give(run, frame, alive, T_map_base, wanted - (alive.length - ended.length), stable, pairOf);
  const best = alive[0];
  if (k % 20 === 15 && best?.pairs.size > 2) {
    const [local] = best.pairs.keys();
    frame.lost = [[best.id, [local], 'the local feature was merged into another']];
    best.pairs.delete(local);
  }
  if (k % 10 === 5 && stable.length > 0) {
    frame.grown = [];
    for (const hypothesis of alive) {
      if (ended.some((position) => alive[position] === hypothesis) || hypothesis.fresh) continue;
      const added = stable
        .filter(({ id }) => !hypothesis.pairs.has(id))
        .slice(0, 3)
        .map((feature) => pairOf(feature, hypothesis.id % 5 === 3));
      if (added.length === 0) continue;
      if (hypothesis.id % 5 === 4) added[0][1] = -1;
      frame.grown.push([hypothesis.id, added]);
      for (const [local, mapped] of added) hypothesis.pairs.set(local, mapped);
    }
    if (alive[1]) frame.tried = [[alive[1].id, [[stable[0].id, 3]], 'wall-4 would lie 0.8 m behind its measurements']];
  }
  return ended;
}

function end(run, frame, hypothesis, k) {
  const [x, y, heading] = hypothesis.pose,
    reason = k % 2 ? 'merged with a better one at the same place' : 'beam 221 passes 1.8 m through wall-5';
  frame.ended ??= [];
  frame.ended.push([
    hypothesis.id,
    reason,
    k % 2 ? 0 : -1,
    x,
    y,
    heading,
    -12.5,
    -3.25,
    { 'opal:FreeSpace': { crossed: -8.2, beams: 3 }, 'opal:Likelihood': { nat: -4.3 } },
    [['opal:FreeSpace', 'beam 221 passes 1.8 m through wall-5', 8, [x, y, 14, 3]]],
  ]);
}

function give(run, frame, alive, T_map_base, count, stable, pairOf) {
  const { random } = run;
  frame.spawned = [];
  for (let n = 0; n < count; ++n) {
    const id = run.nextId++,
      first = alive.length === 0;
    const pose = first ? T_map_base : [random() * kWidth_m, random() * kDepth_m, wrapAngle(random() * 6.28)];
    const spawned = pose.map((v) => Number(v.toFixed(6)));
    const pairs = stable.slice(0, 2).map((feature) => pairOf(feature, !first));
    const parent = alive.length > 3 && n % 4 === 3 ? alive[1].id : -1;
    frame.spawned.push([id, parent, parent < 0 ? 'opal:ColumnPair' : '', ...spawned, 2.5, pairs]);
    alive.push({ id, pose: spawned, nat: 2.5, pairs: new Map(pairs), fresh: true });
  }
  frame.search = {
    patterns: [
      ['opal:ColumnPair', stable.slice(0, 2).map(({ id }) => id), 14],
      ['opal:LShape', stable.slice(0, 3).map(({ id }) => id), 5],
    ],
    proposed: count + 3,
    rejected: [
      [
        'opal:ColumnPair',
        33.5,
        4.25,
        1.57,
        -4.2,
        stable.slice(0, 2).map((feature) => pairOf(feature, true)),
        'a column would stand in free space',
      ],
    ],
  };
}

/// Rows by the README's rule, with the decoder's own arithmetic, so that errors of rounding do not add up.
function encodeRows(frame, alive, ended, D) {
  if (ended.length > 0) {
    frame.leave = ended;
    for (const position of ended) alive.splice(position, 1);
  }
  const rows = [[], [], [], []],
    enter = [];
  alive.forEach((hypothesis, k) => {
    const wobble = (n) => 0.004 * Math.sin(hypothesis.id + n * frame.keyframe);
    if (hypothesis.fresh) {
      const [x, y, heading] = hypothesis.pose,
        steps = [x / kUnits.unit_m, y / kUnits.unit_m, heading / kUnits.unit_rad, hypothesis.nat / kUnits.unit_nat].map(
          Math.round,
        );
      enter.push([hypothesis.id, ...steps]);
      hypothesis.pose = [steps[0] * kUnits.unit_m, steps[1] * kUnits.unit_m, wrapAngle(steps[2] * kUnits.unit_rad)];
      hypothesis.nat = steps[3] * kUnits.unit_nat;
      hypothesis.fresh = false;
      return;
    }
    const moved = compose(hypothesis.pose, D);
    const wish = compose(moved, [wobble(1), wobble(2), wobble(3)]);
    const left = compose(inverse(moved), wish),
      gain = hypothesis.id === alive[0].id ? 0.3 : -0.05 * (hypothesis.id % 4);
    const steps = [left[0] / kUnits.unit_m, left[1] / kUnits.unit_m, left[2] / kUnits.unit_rad, gain / kUnits.unit_nat].map(
      Math.round,
    );
    steps.forEach((step, column) => rows[column].push(step));
    hypothesis.pose = compose(moved, [steps[0] * kUnits.unit_m, steps[1] * kUnits.unit_m, steps[2] * kUnits.unit_rad]);
    hypothesis.nat += steps[3] * kUnits.unit_nat;
    void k;
  });
  if (rows[0].length > 0) frame.rows = rows;
  if (enter.length > 0) frame.enter = enter;
}

function weigh(frame, alive, run, T_map_base, k) {
  const top = alive.slice(0, 5),
    best = top[0];
  const share = Math.min(0.98, 0.25 + 0.02 * k);
  top.forEach((hypothesis, n) => (hypothesis.p = Number((n === 0 ? share : ((1 - share) * 0.4) / n).toFixed(4))));
  for (const hypothesis of alive.slice(5)) hypothesis.p = 0;
  Object.assign(frame, {
    p: top.map(({ id, p }) => [id, p]),
    status: k < 4 ? 'searching' : share < 0.6 ? 'ambiguous' : 'localized',
    probability: best?.p ?? 0,
    none: 0.01,
    best: best?.id ?? -1,
    scores: top
      .slice(0, 3)
      .map(({ id }) => [
        id,
        1.75,
        { 'opal:Likelihood': { nat: 1.25, beams: 90 }, 'opal:FreeSpace': { crossed: 0, margin: null } },
      ]),
    cpu: Object.fromEntries([
      ...kStages.map((stage, n) => [
        stage,
        Number((0.1 + 0.3 * n + (k % 7 === 0 && stage === 'seed' ? 5 : 0) + 0.2 * run.random()).toFixed(3)),
      ]),
      ['total', Number((3.5 + (k % 7 === 0 ? 5 : 0) + run.random()).toFixed(3))],
    ]),
  });
  if (k % 3 === 0 && best)
    frame.words = [
      ['answer', `${frame.status} with probability ${best.p}`],
      ['support', 'column column-1 is 0.04 m from where it should be'],
      ['support', 'wall wall-1 agrees within 0.02 m'],
      ['alternative', alive[1] ? `the alternative #${alive[1].id} explains 3 features less` : 'there is no alternative'],
      ['fell', 'the one at (33.5, 4.3) fell at 0.00 s: a column would stand in free space'],
    ];
  if (best && k % 4 === 0)
    frame.findings = [
      ['opal:Likelihood', 'wall-1 is seen where it should be', 0, [best.pose[0], best.pose[1], best.pose[0], 0.1]],
    ];
  if (run.truthKnown) frame.truth = T_map_base.map((v) => Number(v.toFixed(6)));
}

function expectation(frame, alive, known, window) {
  return {
    window,
    time: frame.time,
    stamp: frame.stamp,
    status: frame.status,
    best: frame.best,
    local: frame.local,
    scanPoints: frame.scan.length / 2,
    hypotheses: alive.map(({ id, pose, nat, p, pairs }) => ({ id, pose: [...pose], nat, p, pairs: [...pairs] })),
    localFeatures: [...known.values()].map((feature) => ({ ...feature })),
  };
}
