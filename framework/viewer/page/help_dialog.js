import { element } from './dom.js';

const kKeyNames = { ' ': 'Space', ArrowLeft: '←', ArrowRight: '→', ArrowUp: '↑', ArrowDown: '↓', Escape: 'Esc' };
const kSigns = [
  ['best', 'the best hypothesis: where the robot is believed to be'],
  ['alternative', 'its alternatives: the larger and fuller, the more probable'],
  ['scan', 'the scan'],
  ['free', 'free space: what the beams passed through'],
  ['local', 'local features, stable'],
  ['candidate', 'local features, candidates (dotted)'],
  ['match', 'what is associated with the map (broad)'],
  ['trajectory', 'estimated trajectory'],
  ['truth', 'recorded truth (dashed)'],
  ['finding', 'findings, ends and refused places'],
  ['pattern', 'patterns (dashed)'],
];

/// Keys and signs, in a dialog.
export class HelpDialog {
  constructor(shortcuts) {
    const keys = element('dl', { class: 'keys' });
    for (const [names, words] of shortcuts)
      keys.append(
        element('dt', {}, ...names.map((key) => element('kbd', { text: kKeyNames[key] ?? key }))),
        element('dd', { text: words }),
      );
    const signs = element(
      'ul',
      { class: 'signs' },
      ...kSigns.map(([ink, words]) => element('li', {}, element('span', { class: `swatch ink-${ink}` }), words)),
    );
    this.root = element(
      'dialog',
      { class: 'help', 'aria-label': 'Keys and signs' },
      element(
        'header',
        {},
        element('h2', { text: 'Keys and signs' }),
        element('button', { type: 'button', class: 'tool', text: 'Close', onclick: () => this.root.close() }),
      ),
      element('div', { class: 'help-body' }, keys, signs),
    );
  }

  open() {
    this.root.showModal();
  }
}
