import { coordinate, integer, list, numberOrNull, optionalList, position, refuse, text } from './record_error.js';

/// One hypothesis, from spawn to end. `links` are its associations with the frames [from, to) in which they held;
/// `nodes` what happened to it: `{frame, kind: grown | lost | tried, pairs or locals, reason}`.
function spawnedNow(id, frame) {
  return {
    id,
    parent: -1,
    origin: '',
    spawnedFrame: frame,
    pose: null,
    nat: NaN,
    pairs: [],
    links: [],
    nodes: [],
    children: [],
    endFrame: Infinity,
    end: null,
    known: false,
  };
}

function pairsOf(value, features, place) {
  return list(value, place).map((pair) => {
    if (!Array.isArray(pair) || pair.length !== 2) refuse(place, '[local, mapped or -1]', pair);
    integer(pair[0], place);
    if (pair[1] !== -1) position(pair[1], features, place);
    return pair;
  });
}

export function findingsOf(value, features, place) {
  return optionalList(value, place).map((finding) => {
    const [scorer, words, mapped, line] = list(finding, place);
    if (line !== undefined && line !== null && list(line, place).length !== 0 && line.length !== 4)
      refuse(place, '[x, y, x, y] or []', line);
    (line ?? []).forEach((v) => coordinate(v, place));
    const feature = mapped === null || mapped === undefined || mapped === -1 ? -1 : position(mapped, features, place);
    return { scorer: text(scorer, place), words: text(words, place), feature, line: line ?? [] };
  });
}

/// All hypotheses of a run by id, in order of spawn.
export class HypothesisLog {
  constructor() {
    this.byId = new Map();
    this.inOrder = [];
    this.features = 0; ///< how many the map has
  }

  /// The hypothesis of that id; one that was never announced as spawned begins here.
  of(id, frame, place) {
    integer(id, place);
    let hypothesis = this.byId.get(id);
    if (!hypothesis) {
      hypothesis = spawnedNow(id, frame);
      this.byId.set(id, hypothesis);
      this.inOrder.push(hypothesis);
    }
    return hypothesis;
  }

  spawned(entry, frame, place) {
    const [id, parent, origin, x, y, heading, nat, pairs] = list(entry, place);
    const hypothesis = this.of(id, frame, place);
    if (hypothesis.known) refuse(place, 'a new id', id);
    hypothesis.known = true;
    hypothesis.parent = integer(parent, place);
    hypothesis.origin = text(origin ?? '', place);
    hypothesis.pose = [x, y, heading].map((v) => coordinate(v, place));
    hypothesis.nat = numberOrNull(nat, place);
    hypothesis.pairs = pairsOf(pairs, this.features, place);
    for (const [local, mapped] of hypothesis.pairs) hypothesis.links.push({ local, mapped, from: frame, to: Infinity });
    if (parent !== -1 && parent !== id) this.of(parent, frame, place).children.push(hypothesis);
    else hypothesis.parent = -1;
  }

  grown([id, pairs], frame, place) {
    const hypothesis = this.of(id, frame, place);
    const added = pairsOf(pairs, this.features, place);
    hypothesis.nodes.push({ frame, kind: 'grown', pairs: added, reason: '' });
    for (const [local, mapped] of added) hypothesis.links.push({ local, mapped, from: frame, to: Infinity });
  }

  lost([id, locals, reason], frame, place) {
    const hypothesis = this.of(id, frame, place);
    const ended = new Set(list(locals, place));
    const pairs = [];
    for (const link of hypothesis.links)
      if (link.to === Infinity && ended.has(link.local)) {
        link.to = frame;
        pairs.push([link.local, link.mapped]);
      }
    hypothesis.nodes.push({ frame, kind: 'lost', pairs, reason: text(reason ?? '', place) });
  }

  tried([id, pairs, reason], frame, place) {
    this.of(id, frame, place).nodes.push({
      frame,
      kind: 'tried',
      pairs: pairsOf(pairs, this.features, place),
      reason: text(reason ?? '', place),
    });
  }

  ended(entry, frame, place) {
    const [id, reason, into, x, y, heading, nat, scan_nat, scores, findings] = list(entry, place);
    const hypothesis = this.of(id, frame, place);
    hypothesis.endFrame = frame;
    hypothesis.end = {
      reason: text(reason, place),
      mergedInto: integer(into ?? -1, place),
      pose: [x, y, heading].map((v) => coordinate(v, place)),
      nat: numberOrNull(nat, place),
      scan_nat: numberOrNull(scan_nat, place),
      scores: scores ?? {},
      findings: findingsOf(findings, this.features, place),
    };
  }

  /// The time line is over, and with it whatever was alive.
  voided(id, frame) {
    const hypothesis = this.byId.get(id);
    if (hypothesis && hypothesis.endFrame === Infinity) hypothesis.endFrame = frame;
  }
}

/// [local, mapped] of all associations that hold at a frame.
export function pairsAt(hypothesis, frame) {
  const pairs = [];
  for (const link of hypothesis.links) if (link.from <= frame && frame < link.to) pairs.push([link.local, link.mapped]);
  return pairs;
}
