import { TreeSearch } from './tree_search.js';
import { nodeWords, poseWords, probabilityWords, seconds, shortName } from './words_of.js';

/// What the tree panel shows at a moment, as rows: `{key, level, words, state, note, id, open, expandable, frame}`. Hypotheses are
/// the branches; under each what happened to it: what it was associated with later, what ended, what was tried and did not fit.

const kRecent_s = 3;
const kMostHypotheses = 5000;
const kSigns = { grown: '+', lost: '\u2212', tried: '×' };

export class TreeModel {
  constructor() {
    this.all = false; ///< also what ended long ago
    this.search = new TreeSearch();
    this.own = new WeakMap();
    this.opened = new Map(); ///< key -> open or closed by the reader
  }

  toggle(row, open = !row.open) {
    this.opened.set(row.key, open);
  }

  rowsAt(recording, frame, selected) {
    Object.assign(this, { recording, frame, selected, now: recording.time.values[frame] });
    this.left = 0; ///< how many there was no room for
    this.wanted = this.wantedHypotheses();
    const rows = [];
    if (this.left > 0) rows.push(this.leftOut());
    for (const hypothesis of this.wanted)
      if (!this.wanted.has(recording.hypotheses.byId.get(hypothesis.parent))) this.addHypothesis(rows, hypothesis, 1);
    this.addSearch(rows);
    return rows;
  }

  /// Hypotheses of this time line that are looked for, in order of spawn: alive, ended of late (or ever), and their ancestors.
  wantedHypotheses() {
    const { recording, frame } = this;
    const { byId, inOrder } = recording.hypotheses;
    const { begin } = recording.windows[recording.window.values[frame]];
    const wanted = new Set();
    for (let k = inOrder.length - 1; k >= 0 && inOrder[k].spawnedFrame >= begin; --k) {
      const hypothesis = inOrder[k];
      if (hypothesis.spawnedFrame > frame || !this.isLookedFor(hypothesis)) continue;
      if (wanted.size >= kMostHypotheses && !this.isFresh(hypothesis)) this.left += 1;
      else for (let h = hypothesis; h && !wanted.has(h); h = byId.get(h.parent)) wanted.add(h);
    }
    return new Set([...wanted].sort((a, b) => a.spawnedFrame - b.spawnedFrame || a.id - b.id));
  }

  isLookedFor(hypothesis) {
    if (!this.all && !this.isFresh(hypothesis)) return false;
    return this.search.query === '' || this.search.finds(hypothesis, this.frame, this.recording.map);
  }

  isFresh(hypothesis) {
    if (hypothesis.endFrame > this.frame || hypothesis.id === this.selected) return true;
    return this.now - this.recording.time.values[hypothesis.endFrame] <= kRecent_s;
  }

  leftOut() {
    const note = 'a search finds them, too';
    return {
      key: 'left',
      level: 1,
      id: -1,
      expandable: false,
      state: 'search',
      frame: this.frame,
      words: `${this.left} older ones are not listed`,
      note,
    };
  }

  addHypothesis(rows, hypothesis, level) {
    const { recording, frame, search } = this;
    const alive = hypothesis.endFrame > frame;
    const children = hypothesis.children.filter((child) => this.wanted.has(child));
    const nodes = hypothesis.nodes.filter((node) => node.frame <= frame);
    const key = `h${hypothesis.id}`;
    const open = this.opened.get(key) ?? (search.query !== '' || hypothesis.id === this.selected);
    rows.push({
      key,
      level,
      open,
      id: hypothesis.id,
      expandable: children.length + nodes.length > 0,
      state: alive ? 'alive' : 'ended',
      frame: hypothesis.spawnedFrame,
      words: `#${hypothesis.id} ${nodeWords(this.ownPairs(hypothesis), recording.map)}`,
      note: alive ? this.aliveNote(hypothesis) : this.endedNote(hypothesis),
    });
    if (!open) return;
    nodes.forEach((node, k) => this.addNode(rows, hypothesis, node, k, level + 1));
    for (const child of children) this.addHypothesis(rows, child, level + 1);
  }

  ownPairs(hypothesis) {
    if (!this.own.has(hypothesis)) this.own.set(hypothesis, this.addedPairs(hypothesis));
    return this.own.get(hypothesis);
  }

  /// What a branch adds to its parent; all of it for a root.
  addedPairs(hypothesis) {
    const parent = this.recording.hypotheses.byId.get(hypothesis.parent);
    if (!parent) return hypothesis.pairs;
    const inherited = new Set(
      parent.links.filter((link) => link.from < hypothesis.spawnedFrame).map((l) => `${l.local} ${l.mapped}`),
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
    const { map, time } = this.recording;
    if (this.search.query !== '' && !this.search.findsNode(node, map)) return;
    const when = seconds(time.values[node.frame]);
    rows.push({
      key: `n${hypothesis.id}.${number}`,
      level,
      id: hypothesis.id,
      expandable: false,
      open: false,
      frame: node.frame,
      state: node.kind,
      words: `${kSigns[node.kind]} ${nodeWords(node.pairs, map)}`,
      note: node.kind === 'grown' ? when : `${node.kind === 'tried' ? 'rejected' : 'dropped'} ${when}: ${node.reason}`,
    });
  }

  /// The last search: places that did not become hypotheses.
  addSearch(rows) {
    const { recording } = this,
      frame = recording.searchFrame.values[this.frame];
    if (frame < 0) return;
    const { rejected = [], patterns = [], proposed = 0 } = recording.searchAt(frame),
      when = seconds(recording.time.values[frame]);
    const refused = rejected.map((entry, k) => this.refused(frame, entry, k));
    const found = refused.filter(({ words, note }) => this.search.findsText(`${words} ${note}`));
    if (this.search.query !== '' && found.length === 0) return;
    const key = `s${frame}`,
      open = this.opened.get(key) ?? this.search.query !== '';
    rows.push({
      key,
      level: 1,
      id: -1,
      open,
      expandable: found.length > 0,
      state: 'search',
      frame,
      words: `Search at ${when}`,
      note: `${patterns.length} patterns, ${proposed} places proposed, ${rejected.length} refused`,
    });
    if (open) rows.push(...found);
  }

  refused(frame, [origin, x, y, heading, , pairs, reason], k) {
    return {
      key: `r${frame}.${k}`,
      level: 2,
      id: -1,
      expandable: false,
      open: false,
      state: 'tried',
      frame,
      words: `× ${nodeWords(pairs, this.recording.map)}`,
      note: `rejected: ${reason} · ${shortName(String(origin))} at ${poseWords([x, y, heading])}`,
    };
  }
}
