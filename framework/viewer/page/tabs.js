import { element } from './dom.js';

/// Panels of which one is on show: [name, label, panel] each.
export class Tabs {
  constructor(label, entries, changed) {
    this.entries = entries;
    this.changed = changed;
    this.buttons = entries.map(([name, text, panel], k) => {
      panel.root.id = `panel-${name}`;
      panel.root.setAttribute('role', 'tabpanel');
      panel.root.setAttribute('aria-labelledby', `tab-${name}`);
      return element('button', {
        type: 'button',
        role: 'tab',
        id: `tab-${name}`,
        'aria-controls': `panel-${name}`,
        text,
        onclick: () => this.open(k),
        onkeydown: (event) => this.onKey(event),
      });
    });
    this.root = element(
      'section',
      { class: 'tabs' },
      element('div', { class: 'tab-list', role: 'tablist', 'aria-label': label }, ...this.buttons),
      ...entries.map(([, , panel]) => panel.root),
    );
    this.open(0, false);
  }

  get panel() {
    return this.entries[this.current][2];
  }

  open(position, tell = true) {
    this.current = position;
    this.buttons.forEach((button, k) => {
      button.setAttribute('aria-selected', String(k === position));
      button.tabIndex = k === position ? 0 : -1;
      this.entries[k][2].root.hidden = k !== position;
    });
    if (tell) this.changed();
  }

  onKey(event) {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step) return;
    this.open((this.current + step + this.buttons.length) % this.buttons.length);
    this.buttons[this.current].focus();
    event.preventDefault();
    event.stopPropagation();
  }
}
