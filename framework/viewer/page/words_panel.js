import { element, setText } from './dom.js';
import { kStatuses } from './frame_check.js';
import { probabilityWords } from './words_of.js';

const kKinds = { answer: 'Answer', support: 'For it', against: 'Against it', alternative: 'Alternatives', fell: 'Fell', note: 'Note' };

/// The explanation of the moment, in the words that the record brings, and the status above it.
export class WordsPanel {
  constructor(title) {
    this.status = element('span', { class: 'status' });
    this.probability = element('span', { class: 'quiet' });
    this.body = element('div', { class: 'words-body', tabindex: '0', role: 'region', 'aria-label': `${title}: explanation` });
    this.root = element(
      'section',
      { class: 'words', 'aria-label': title },
      element('header', {}, element('h2', { text: title }), this.status, this.probability),
      this.body,
    );
    this.shown = null;
  }

  update(recording, frame) {
    if (frame < 0) return this.nothing('No update yet at this time.');
    const status = kStatuses[recording.status.values[frame]],
      p = recording.probability.values[frame];
    setText(this.status, status);
    this.status.dataset.status = status;
    setText(this.probability, Number.isNaN(p) ? '' : `probability ${probabilityWords(p)}${unproven(status, p)}`);
    const words = recording.wordsAt(frame);
    if (words === this.shown) return;
    this.shown = words;
    this.body.replaceChildren(
      ...(words.length > 0
        ? paragraphs(words)
        : [element('p', { class: 'quiet', text: 'The recording has no words for this moment.' })]),
    );
  }

  nothing(words) {
    this.shown = null;
    setText(this.status, '');
    setText(this.probability, '');
    this.body.replaceChildren(element('p', { class: 'quiet', text: words }));
  }
}

/// `searching` with a probability of 1.000 reads like a contradiction (report/status_text.hpp).
const unproven = (status, probability) => (status === 'searching' && probability > 0.5 ? ' (found, not proven yet)' : '');

function paragraphs(words) {
  let before = '';
  return words.map(([kind, text]) => {
    const name = Object.hasOwn(kKinds, kind) ? kKinds[kind] : kind;
    const tag = kind === before ? '' : name;
    before = kind;
    return element(
      'p',
      { class: 'sentence', 'data-kind': Object.hasOwn(kKinds, kind) ? kind : 'note' },
      element('span', { class: 'tag', text: tag }),
      element('span', { text }),
    );
  });
}
