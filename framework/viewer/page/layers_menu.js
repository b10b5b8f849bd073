import { kAssociationChoices, kLayers } from './app_state.js';
import { element } from './dom.js';

/// What is drawn: a menu of check boxes, and whose associations.
export class LayersMenu {
  constructor(state) {
    this.state = state;
    this.boxes = new Map(kLayers.map(([name, label]) => [name, this.box(name, label)]));
    this.choice = element(
      'select',
      { 'aria-label': 'Associations of', onchange: () => state.set({ associations: this.choice.value }) },
      ...kAssociationChoices.map((value) =>
        element('option', { value, text: `of ${value === 'all' ? 'all' : `the ${value} one`}` }),
      ),
    );
    this.summary = element('summary', { class: 'tool', text: 'Layers', title: 'What is drawn (l)' });
    this.root = element(
      'details',
      { class: 'menu' },
      this.summary,
      element(
        'div',
        { class: 'menu-body', role: 'group', 'aria-label': 'Layers' },
        ...[...this.boxes.values()].map(({ root }) => root),
        element('label', { class: 'check' }, 'Association lines ', this.choice),
      ),
    );
    this.root.addEventListener('keydown', (event) => {
      if (event.key === 'Escape' && this.root.open) this.close(event);
    });
    document.addEventListener('pointerdown', (event) => {
      if (!this.root.contains(event.target)) this.root.open = false;
    });
  }

  box(name, label) {
    const input = element('input', { type: 'checkbox', onchange: () => this.state.toggleLayer(name, input.checked) });
    return { input, root: element('label', { class: 'check' }, input, ` ${label}`) };
  }

  close(event) {
    this.root.open = false;
    this.summary.focus();
    event.stopPropagation();
  }

  toggle() {
    this.root.open = !this.root.open;
    if (this.root.open) this.boxes.values().next().value.input.focus();
  }

  update() {
    for (const [name, { input }] of this.boxes) input.checked = this.state.layers.has(name);
    this.choice.value = this.state.associations;
  }
}
