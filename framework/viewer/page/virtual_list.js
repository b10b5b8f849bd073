import { element } from './dom.js';

const kSpare = 4; ///< rows beyond the visible ones

/// A list, or tree, of any length of which only the visible rows exist. `fill(node, item)` writes a row; rows are reused.
/// The list has the focus, and points at its active row (aria-activedescendant). Arrow keys, Home, End, PageUp, PageDown;
/// `on.open(item)` on Enter, Space and click, `on.key(event, item)` may take a key first (true if it did).
export class VirtualList {
  constructor(name, label, role, rowRole, rowHeight, fill, on) {
    Object.assign(this, { name, rowRole, rowHeight, fill, on });
    this.items = [];
    this.active = -1;
    this.rows = [];
    this.space = element('div', { class: 'rows', role: 'presentation' });
    this.root = element(
      'div',
      { class: 'virtual-list', role, tabindex: '0', 'aria-label': label, id: `${name}-list` },
      this.space,
    );
    this.root.addEventListener('scroll', () => this.paint());
    this.root.addEventListener('keydown', (event) => this.onKey(event));
    this.root.addEventListener('focus', () => this.activate(this.active < 0 ? 0 : this.active, false));
    new ResizeObserver(() => this.paint()).observe(this.root);
  }

  /// New content; the active row stays with its key.
  show(items) {
    const key = this.items[this.active]?.key;
    this.items = items;
    this.active = key === undefined ? -1 : items.findIndex((item) => item.key === key);
    this.space.style.height = `${items.length * this.rowHeight}px`;
    this.paint();
  }

  paint() {
    const { scrollTop, clientHeight } = this.root;
    const first = Math.max(0, Math.floor(scrollTop / this.rowHeight) - kSpare);
    const count =
      clientHeight === 0 ? 0 : Math.min(this.items.length - first, Math.ceil(clientHeight / this.rowHeight) + 2 * kSpare);
    while (this.rows.length < count) this.addRow();
    this.rows.forEach((row, k) => {
      row.hidden = k >= count;
      if (k < count) this.paintRow(row, first + k);
    });
    const on = this.active >= first && this.active < first + count;
    if (on) this.root.setAttribute('aria-activedescendant', `${this.name}-row-${this.active - first}`);
    else this.root.removeAttribute('aria-activedescendant');
  }

  addRow() {
    const row = element('div', { class: 'row', role: this.rowRole, id: `${this.name}-row-${this.rows.length}` });
    row.addEventListener('click', () => {
      this.activate(row.position);
      this.on.open(this.items[row.position]);
    });
    this.rows.push(row);
    this.space.append(row);
  }

  paintRow(row, position) {
    row.position = position;
    row.style.transform = `translateY(${position * this.rowHeight}px)`;
    row.classList.toggle('active', position === this.active);
    row.setAttribute('aria-posinset', position + 1);
    row.setAttribute('aria-setsize', this.items.length);
    this.fill(row, this.items[position]);
  }

  activate(position, scroll = true) {
    this.active = Math.max(0, Math.min(position, this.items.length - 1));
    if (scroll) this.reveal(this.active);
    this.paint();
  }

  reveal(position) {
    const top = position * this.rowHeight,
      { scrollTop, clientHeight } = this.root;
    if (top < scrollTop) this.root.scrollTop = top;
    else if (top + this.rowHeight > scrollTop + clientHeight) this.root.scrollTop = top + this.rowHeight - clientHeight;
  }

  onKey(event) {
    const item = this.items[this.active],
      page = Math.max(1, Math.floor(this.root.clientHeight / this.rowHeight) - 1);
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const moves = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page, Home: -Infinity, End: Infinity };
    if (item && this.on.key?.(event, item)) event.preventDefault();
    else if (event.key in moves) this.activate(Math.max(0, Math.min(this.items.length - 1, this.active + moves[event.key])));
    else if ((event.key === 'Enter' || event.key === ' ') && item) this.on.open(item);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
