import { nodeWords } from './words_of.js';

/// Finds words in hypotheses: in what they are associated with, why they ended, what was found about them, what was tried.
/// The text of each is made once.
export class TreeSearch {
  constructor() {
    this.query = '';
    this.texts = new WeakMap();
  }

  text(object, make) {
    if (!this.texts.has(object)) this.texts.set(object, make().toLowerCase());
    return this.texts.get(object);
  }

  /// Whether a hypothesis, as it is known at a frame, has the words.
  finds(hypothesis, frame, map) {
    const { query } = this,
      { pairs, end, nodes } = hypothesis;
    if (this.text(hypothesis, () => `#${hypothesis.id} ${nodeWords(pairs, map)}`).includes(query)) return true;
    if (end && hypothesis.endFrame <= frame && this.text(end, () => endText(end)).includes(query)) return true;
    return nodes.some((node) => node.frame <= frame && this.findsNode(node, map));
  }

  findsNode(node, map) {
    return this.text(node, () => `${nodeWords(node.pairs, map)} ${node.reason}`).includes(this.query);
  }

  findsText(text) {
    return text.toLowerCase().includes(this.query);
  }
}

function endText({ reason, findings }) {
  return [reason, ...findings.map(({ words }) => words)].join(' ');
}
