import { element, setText } from './dom.js';
import { degrees, fixed, probabilityWords } from './words_of.js';
import { VirtualList } from './virtual_list.js';

const kRow_px = 26;

/// All live hypotheses, best first.
export class HypothesisList {
  constructor(state) {
    this.state = state;
    this.list = new VirtualList(
      'hypotheses',
      'Live hypotheses, best first',
      'listbox',
      'option',
      kRow_px,
      (node, item) => this.fillRow(node, item),
      { open: ({ key }) => this.state.set({ selected: key }) },
    );
    this.head = element(
      'div',
      { class: 'row head', 'aria-hidden': 'true' },
      ...['', 'id', 'prob.', 'x, y [m]', 'heading', 'log-lik.'].map((text) => element('span', { text })),
    );
    this.root = element('div', { class: 'list-panel hypotheses' }, this.head, this.list.root);
  }

  update(scene) {
    this.scene = scene;
    if (this.root.offsetParent === null) return;
    this.list.show(scene ? hypothesesBestFirst(scene) : []);
  }

  fillRow(node, { key, row }) {
    const { rows } = this.scene.recording,
      p = rows.probability.values[row];
    if (node.childElementCount === 0)
      node.append(element('span', { class: 'bar' }), ...Array.from({ length: 5 }, () => element('span')));
    const [bar, id, probability, place, heading, nat] = node.children;
    const best = key === this.scene.best;
    bar.style.setProperty('--part', fixed(p, 3));
    setText(id, `#${key}`);
    setText(probability, probabilityWords(p));
    setText(place, `${fixed(rows.x.values[row], 2)}, ${fixed(rows.y.values[row], 2)}`);
    setText(heading, degrees(rows.heading.values[row]));
    setText(nat, fixed(rows.nat.values[row], 1));
    node.classList.toggle('best', best);
    node.setAttribute('aria-selected', String(key === this.state.selected));
    node.setAttribute(
      'aria-label',
      `Hypothesis ${key}${best ? ', the best' : ''}: probability ${probability.textContent}, at ${place.textContent} metres, ${heading.textContent}`,
    );
  }
}

export function hypothesesBestFirst({ recording: { rows }, frame }) {
  const order = [],
    seen = new Set();
  const add = (row) => {
    if (!seen.has(row)) order.push(row);
    seen.add(row);
  };
  for (let k = rows.topBegins.values[frame]; k < rows.topBegins.values[frame + 1]; ++k) add(rows.tops.values[k]);
  const rest = Array.from({ length: rows.end(frame) - rows.begin(frame) }, (_, k) => rows.begin(frame) + k);
  rest.sort((a, b) => rows.nat.values[b] - rows.nat.values[a]).forEach(add);
  return order.map((row) => ({ key: rows.id.values[row], row }));
}
