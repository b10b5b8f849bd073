import { element, setHidden, setText } from '../../viewer/page/dom.js';
import { saveAsFile } from './file_saving.js';

const kName = 'opal-review-by';

/// What is under review, how far it is, and whether it is saved.
export class Header {
  constructor(review, saving, { notes, isServed, theme, help }) {
    this.review = review;
    this.saving = saving;
    this.count = element('strong', { class: 'count', role: 'status' });
    this.progress = element('progress', { max: Math.max(1, review.proposals.length), 'aria-label': 'Decided' });
    this.state = element('span', { class: 'state', role: 'status' });
    this.save = element(
      'button',
      { type: 'button', class: 'tool', onclick: () => saving.save() },
      'Save ',
      element('kbd', { text: 's' }),
    );
    const file = element('button', { type: 'button', class: 'tool', text: 'Save as a file', onclick: () => saveAsFile(review) });
    this.by = element('input', {
      type: 'text',
      maxlength: 60,
      placeholder: 'Your name (optional)',
      'aria-label': 'Your name',
      oninput: () => this.nameChanged(),
    });
    this.by.value = review.by = recall();
    this.root = element(
      'header',
      { class: 'top' },
      element('h1', { text: `Review of ${review.document.map}` }),
      this.count,
      this.progress,
      this.state,
      this.by,
      this.save,
      isServed ? file : '',
      element('button', {
        type: 'button',
        class: 'tool',
        text: '◐',
        title: 'Light, dark, as the system',
        'aria-label': 'Light, dark, as the system',
        onclick: theme,
      }),
      element('button', { type: 'button', class: 'tool', text: '?', title: 'Keys', 'aria-label': 'Keys', onclick: help }),
    );
    this.notes = noteBox(notes);
  }

  nameChanged() {
    this.review.by = this.by.value.trim();
    try {
      localStorage.setItem(kName, this.review.by);
    } catch {
      /* the name lasts as long as the page */
    }
  }

  update() {
    const { review, saving } = this;
    setText(this.count, `${review.decided} of ${review.proposals.length} decided`);
    this.progress.value = review.decided;
    setText(this.state, saving.words);
    this.state.className = `state ${saving.state}`;
    this.state.title = saving.words;
  }
}

/// What has changed since the decisions were made; empty: nothing.
function noteBox(notes) {
  const box = element(
    'div',
    { class: 'notes', role: 'note' },
    element('ul', {}, ...notes.map((text) => element('li', { text }))),
  );
  box.append(element('button', { type: 'button', class: 'tool', text: 'Hide', onclick: () => setHidden(box, true) }));
  setHidden(box, notes.length === 0);
  return box;
}

function recall() {
  try {
    return localStorage.getItem(kName) ?? '';
  } catch {
    return '';
  }
}
