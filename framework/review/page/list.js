import { element, setText } from '../../viewer/page/dom.js';
import { kFilters } from './review.js';

export const kSigns = { moved: '↔', gone: '×', added: '+' };
export const kAnswerSigns = { accepted: '✓', refused: '✕', undecided: '' };

export const nameOf = ({ about, notes }) => notes.name ?? about.id;

/// How far it moved, how long it is; empty for what is gone.
function sizeWords({ about }) {
  if (about.change === 'moved') return `${Math.hypot(...about.moved).toFixed(2)} m`;
  if (about.change === 'gone') return '';
  const [x, y, X, Y] = about.face;
  return `${Math.hypot(X - x, Y - y).toFixed(1)} m`;
}

/// The filters and the proposals that pass.
export class ProposalList {
  constructor(review) {
    this.review = review;
    this.filters = kFilters.map(([name, words]) => {
      const count = element('span', { class: 'number' });
      const button = element(
        'button',
        { type: 'button', class: 'tool filter', 'data-filter': name, onclick: () => review.choose(name) },
        `${words} `,
        count,
      );
      return { name, button, count };
    });
    this.items = review.proposals.map((proposal) => new Item(proposal, review));
    this.empty = element('p', { class: 'quiet empty', text: 'None.' });
    this.list = element('ul', { class: 'proposals' });
    this.root = element(
      'nav',
      { 'aria-label': 'Proposals' },
      element(
        'div',
        { class: 'filters', role: 'group', 'aria-label': 'Which proposals' },
        ...this.filters.map(({ button }) => button),
      ),
      this.list,
      this.empty,
    );
  }

  update() {
    const { review } = this,
      shown = review.shown();
    for (const { name, button, count } of this.filters) {
      setText(count, String(review.count(name)));
      button.setAttribute('aria-pressed', String(name === review.filter));
    }
    const wanted = shown.map(({ number }) => this.items[number].root);
    if (wanted.length !== this.list.children.length || wanted.some((node, k) => this.list.children[k] !== node))
      this.list.replaceChildren(...wanted);
    this.empty.hidden = shown.length > 0;
    for (const item of this.items) item.update(review.current);
    this.items[review.number]?.root.scrollIntoView({ block: 'nearest' });
  }
}

class Item {
  constructor(proposal, review) {
    this.proposal = proposal;
    const { about, probability, proposed, objection } = proposal;
    this.answer = element('span', { class: 'answer' });
    const facts = [about.change, sizeWords(proposal), `p ${probability.toFixed(3)}`].filter((word) => word).join(' · ');
    const chips = objection ? [element('span', { class: 'chip conflict', text: 'conflict' })] : [];
    this.button = element(
      'button',
      { type: 'button', onclick: () => review.show(proposal.number) },
      element('span', { class: `sign ${about.change}`, text: kSigns[about.change], 'aria-hidden': 'true' }),
      element(
        'span',
        { class: 'what' },
        element('span', { class: 'name', text: `${proposed ? '' : '? '}${nameOf(proposal)}` }),
        element('span', { class: 'quiet number' }, facts, ...chips),
      ),
      this.answer,
    );
    this.root = element('li', {}, this.button);
  }

  update(current) {
    const { answer } = this.proposal;
    this.root.className = answer;
    setText(this.answer, kAnswerSigns[answer]);
    this.answer.setAttribute('aria-label', answer);
    if (this.proposal === current) this.button.setAttribute('aria-current', 'true');
    else this.button.removeAttribute('aria-current');
  }
}
