import { element } from '../../viewer/page/dom.js';
import { Picture, svg } from './picture.js';
import { changeOf } from './detail_picture.js';
import { boxOf, emptyBox, include, isEmpty } from './shapes.js';

const kReach_px = 22;

/// The whole map with a mark on each proposal, which can be clicked.
export class WholePicture extends Picture {
  constructor(review, map) {
    super('The whole map with all proposals', map, { click: (x, y) => this.click(x, y) });
    this.review = review;
    this.changes = svg('g', { class: 'others' }, ...review.proposals.map((proposal) => changeOf(proposal)));
    this.metres.append(this.changes);
    this.marks = review.proposals.map((proposal) => markOf(proposal));
    this.pixels.append(...this.marks);
    this.ring = svg('circle', { class: 'ring', r: 13, 'data-x': 0, 'data-y': 0 });
    this.pixels.append(this.ring);
    this.tip = element('div', { class: 'tip', 'aria-hidden': 'true' });
    this.root.append(this.tip);
    const box = include(emptyBox(), map);
    for (const { picture } of review.proposals) include(box, picture.proposed);
    this.look(isEmpty(box) ? [0, 0, 1, 1] : box);
  }

  show(proposal, shown) {
    const listed = new Set(shown);
    this.review.proposals.forEach((each, number) => {
      const mark = this.marks[number];
      mark.setAttribute('class', `mark ${each.about.change} ${each.answer}${listed.has(each) ? '' : ' unlisted'}`);
      this.changes.children[number].setAttribute('class', `change ${each.about.change} ${each.answer}`);
    });
    const mark = this.marks[proposal.number];
    this.ring.dataset.x = mark.dataset.x;
    this.ring.dataset.y = mark.dataset.y;
    this.draw();
  }

  /// The nearest mark.
  click(x, y) {
    const away = (mark) => Math.hypot(this.transform.x(Number(mark.dataset.x)) - x, this.transform.y(Number(mark.dataset.y)) - y);
    const listed = this.marks
      .map((mark, number) => [away(mark), number])
      .filter(([, number]) => !this.marks[number].classList.contains('unlisted'));
    const [distance, number] = listed.reduce((best, each) => (each[0] < best[0] ? each : best), [Infinity, -1]);
    if (distance < kReach_px) this.review.show(number);
  }
}

function markOf(proposal) {
  const [x, y, X, Y] = boxOf(proposal);
  const title = svg('title');
  title.textContent = proposal.about.id;
  return svg('g', { 'data-x': (x + X) / 2, 'data-y': (y + Y) / 2 }, svg('circle', { r: 6 }), title);
}
