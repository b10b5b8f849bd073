import { element, setText } from './dom.js';
import { TreeModel } from './tree_model.js';
import { VirtualList } from './virtual_list.js';

const kRow_px = 38,
  kIndent_px = 14;

/// The hypothesis tree: (local set → map set or "not on the map"), with how each branch stands or fell.
export class TreePanel {
  constructor(state, seek) {
    this.state = state;
    this.seek = seek;
    this.model = new TreeModel();
    this.list = new VirtualList('tree', 'Hypothesis tree', 'tree', 'treeitem', kRow_px, fillRow, {
      open: (row) => this.open(row),
      key: (event, row) => this.onKey(event, row),
    });
    this.search = element('input', {
      type: 'search',
      placeholder: 'Search: id, feature, reason',
      'aria-label': 'Search the tree',
      oninput: () => this.query(),
    });
    this.all = element('input', { type: 'checkbox', onchange: () => this.showAll() });
    this.root = element(
      'div',
      { class: 'list-panel' },
      element('div', { class: 'list-tools' }, this.search, element('label', { class: 'check' }, this.all, ' all ended')),
      this.list.root,
    );
  }

  query() {
    this.model.search.query = this.search.value.trim().toLowerCase();
    this.refresh();
  }

  showAll() {
    this.model.all = this.all.checked;
    this.refresh();
  }

  update(scene) {
    this.scene = scene;
    if (this.root.offsetParent !== null) this.refresh();
  }

  refresh() {
    const { scene } = this;
    this.list.show(scene ? this.model.rowsAt(scene.recording, scene.frame, this.state.selected) : []);
  }

  open(row) {
    if (row.id >= 0) this.state.set({ selected: row.id });
    if (row.expandable) this.model.toggle(row, row.id >= 0 && row.id !== this.lastOpened ? true : !row.open);
    this.lastOpened = row.id;
    this.refresh();
  }

  onKey(event, row) {
    if (event.key === 'ArrowRight' && row.expandable && !row.open) this.model.toggle(row, true);
    else if (event.key === 'ArrowRight' && row.open) this.list.activate(this.list.active + 1);
    else if (event.key === 'ArrowLeft' && row.expandable && row.open) this.model.toggle(row, false);
    else if (event.key === 'ArrowLeft') this.toParent(row);
    else if (event.key === 'g') this.seek(row.frame);
    else return false;
    this.refresh();
    return true;
  }

  toParent(row) {
    let k = this.list.active;
    while (k > 0 && this.list.items[k].level >= row.level) --k;
    this.list.activate(k);
  }
}

function fillRow(node, row) {
  if (node.childElementCount === 0)
    node.append(
      element('span', { class: 'twist', 'aria-hidden': 'true' }),
      element('span', { class: 'row-words' }),
      element('span', { class: 'row-note' }),
    );
  const [twist, words, note] = node.children;
  setText(twist, row.expandable ? (row.open ? '▾' : '▸') : '');
  setText(words, row.words);
  setText(note, row.note);
  node.title = `${row.words}\n${row.note}`;
  node.dataset.state = row.state;
  node.style.paddingLeft = `${4 + (row.level - 1) * kIndent_px}px`;
  node.setAttribute('aria-level', row.level);
  node.setAttribute('aria-label', `${row.words}. ${row.note}`);
  if (row.expandable) node.setAttribute('aria-expanded', String(row.open));
  else node.removeAttribute('aria-expanded');
}
