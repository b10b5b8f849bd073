import { element } from '../../viewer/page/dom.js';

const kNames = { ArrowUp: '↑', ArrowDown: '↓' };

/// All keys, in a dialog.
export class KeysDialog {
  constructor(shortcuts) {
    const keys = element('dl', { class: 'keys' });
    for (const [names, words] of shortcuts)
      keys.append(
        element('dt', {}, ...names.map((key) => element('kbd', { text: kNames[key] ?? key }))),
        element('dd', { text: words }),
      );
    const close = element('button', { type: 'button', class: 'tool', text: 'Close', onclick: () => this.root.close() });
    this.root = element('dialog', { class: 'help', 'aria-label': 'Keys' }, element('h2', { text: 'Keys' }), keys, close);
  }

  open() {
    this.root.showModal();
  }
}
