import { nodeWords, poseWords, probabilityWords, seconds, shortName } from './words_of.js';

/// What the tree panel shows at a moment, as rows: `{key, level, words, state, note, id, open, frame}`. Hypotheses are the
/// branches; under each what happened to it: what it was associated with later, what ended, what was tried and did not fit.

const kRecent_s = 3,
  kMostRows = 20000;

export class TreeModel {
  constructor() {
    this.all = false; ///< also what ended long ago
    this.query = '';
    this.opened = new Map(); ///< key -> open or closed by the reader
  }

  toggle(row, open = !row.open) {
    this.opened.set(row.key, open);
  }

  rowsAt(recording, frame, selected) {
    this.recording = recording;
    this.frame = frame;
    this.selected = selected;
    this.now = recording.time.values[frame];
    const { begin } = recording.windows[recording.window.values[frame]];
    this.wanted = this.wantedFrom(begin);
    const rows = [];
    for (const hypothesis of recording.hypotheses.inOrder) {
      if (!this.wanted.has(hypothesis) || rows.length > kMostRows) continue;
      if (this.wanted.has(recording.hypotheses.byId.get(hypothesis.parent))) continue;
      this.addHypothesis(rows, hypothesis, 1);
    }
    this.addSearch(rows);
    return this.query === '' ? rows : rows.filter((row) => row.found);
  }

  /// Hypotheses of this time line: alive, ended of late (or ever), and the ancestors of those.
  wantedFrom(begin) {
    const { recording, frame } = this,
      wanted = new Set();
    for (const hypothesis of recording.hypotheses.inOrder) {
      if (hypothesis.bornFrame < begin || hypothesis.bornFrame > frame) continue;
      if (!this.all && !this.isFresh(hypothesis)) continue;
      for (let h = hypothesis; h && !wanted.has(h); h = recording.hypotheses.byId.get(h.parent)) wanted.add(h);
    }
    return wanted;
  }

  isFresh(hypothesis) {
    if (hypothesis.endFrame > this.frame || hypothesis.id === this.selected) return true;
    return this.now - this.recording.time.values[hypothesis.endFrame] <= kRecent_s;
  }

  addHypothesis(rows, hypothesis, level) {
    const { recording, frame } = this,
      alive = hypothesis.endFrame > frame;
    const row = {
      key: `h${hypothesis.id}`,
      level,
      id: hypothesis.id,
      expandable: true,
      state: alive ? 'alive' : 'ended',
      frame: hypothesis.bornFrame,
      words: `#${hypothesis.id} ${nodeWords(this.ownPairs(hypothesis), recording.map)}`,
      note: alive ? this.aliveNote(hypothesis) : this.endedNote(hypothesis),
    };
    row.open = this.opened.get(row.key) ?? (this.query !== '' || hypothesis.id === this.selected);
    row.found = this.matches(row);
    const at = rows.push(row) - 1;
    const children = hypothesis.children.filter((child) => this.wanted.has(child));
    const nodes = hypothesis.nodes.filter((node) => node.frame <= frame);
    row.expandable = children.length + nodes.length > 0;
    if (row.open) nodes.forEach((node, k) => this.addNode(rows, hypothesis, node, k, level + 1));
    if (row.open || this.query !== '') for (const child of children) this.addHypothesis(rows, child, level + 1);
    if (this.query !== '') row.found ||= rows.slice(at + 1).some((inner) => inner.found);
  }

  /// What a branch adds to its parent; all of it for a root.
  ownPairs(hypothesis) {
    const parent = this.recording.hypotheses.byId.get(hypothesis.parent);
    if (!parent) return hypothesis.pairs;
    const inherited = new Set(
      parent.links.filter((link) => link.from < hypothesis.bornFrame).map((l) => `${l.local} ${l.mapped}`),
    );
    const own = hypothesis.pairs.filter(([local, mapped]) => !inherited.has(`${local} ${mapped}`));
    return own.length > 0 ? own : hypothesis.pairs;
  }

  aliveNote(hypothesis) {
    const { rows } = this.recording,
      row = rows.find(this.frame, hypothesis.id);
    return row < 0 ? '' : `p ${probabilityWords(rows.probability.values[row])}`;
  }

  endedNote(hypothesis) {
    const when = seconds(this.recording.time.values[hypothesis.endFrame] ?? NaN);
    const into = hypothesis.end?.mergedInto >= 0 ? ` (into #${hypothesis.end.mergedInto})` : '';
    return `ended ${when}: ${hypothesis.end?.reason ?? 'the time line was over'}${into}`;
  }

  addNode(rows, hypothesis, node, number, level) {
    const { map, time } = this.recording,
      when = seconds(time.values[node.frame]);
    const signs = { grown: '+', lost: '\u2212', tried: '×' };
    const row = {
      key: `n${hypothesis.id}.${number}`,
      level,
      id: hypothesis.id,
      expandable: false,
      open: false,
      frame: node.frame,
      state: node.kind,
      words: `${signs[node.kind]} ${nodeWords(node.pairs, map)}`,
      note: node.kind === 'grown' ? when : `${node.kind === 'tried' ? 'rejected' : 'dropped'} ${when}: ${node.reason}`,
    };
    row.found = this.matches(row);
    if (this.query === '' || row.found) rows.push(row);
  }

  /// The last search: places that did not become hypotheses.
  addSearch(rows) {
    const { recording } = this,
      frame = recording.searchFrame.values[this.frame];
    if (frame < 0) return;
    const { rejected = [], patterns = [], proposed = 0 } = recording.searchAt(frame),
      when = seconds(recording.time.values[frame]);
    const row = {
      key: `s${frame}`,
      level: 1,
      id: -1,
      expandable: rejected.length > 0,
      state: 'search',
      frame,
      words: `Search at ${when}`,
      note: `${patterns.length} patterns, ${proposed} places proposed, ${rejected.length} refused`,
    };
    row.open = this.opened.get(row.key) ?? this.query !== '';
    row.found = this.matches(row);
    const at = rows.push(row) - 1;
    if (!row.open) return;
    rejected.forEach((entry, k) => this.addRefused(rows, frame, entry, k));
    if (this.query !== '') row.found ||= rows.slice(at + 1).some((inner) => inner.found);
  }

  addRefused(rows, frame, [template, x, y, heading, nat, pairs, reason], k) {
    const row = {
      key: `r${frame}.${k}`,
      level: 2,
      id: -1,
      expandable: false,
      open: false,
      state: 'tried',
      frame,
      words: `× ${nodeWords(pairs, this.recording.map)}`,
      note: `rejected: ${reason} · ${shortName(String(template))} at ${poseWords([x, y, heading])}`,
    };
    row.found = this.matches(row);
    rows.push(row);
  }

  matches(row) {
    return this.query === '' || `${row.words} ${row.note}`.toLowerCase().includes(this.query);
  }
}
