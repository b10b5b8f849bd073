import { Picture, path, svg } from './picture.js';
import { boxOf } from './shapes.js';

const kLeastWidth_m = 6,
  kAround = 0.35;

/// The map around one proposal: what is mapped, what would stand there, what each visit saw; other proposals faint.
export class DetailPicture extends Picture {
  constructor(review, map) {
    super('The map around the proposal', map);
    this.review = review;
    this.others = svg('g', { class: 'others' }, ...review.proposals.map((proposal) => changeOf(proposal)));
    this.own = svg('g', { class: 'own' });
    this.metres.append(this.others, this.own);
  }

  show(proposal) {
    if (this.proposal === proposal) return;
    this.proposal = proposal;
    [...this.others.children].forEach((group, number) => group.classList.toggle('is-own', number === proposal.number));
    const sights = proposal.picture.sights.map((shapes, k) => path(shapes, `sight v${k % 6}`));
    this.own.setAttribute('class', proposal.objection ? 'own disputed' : 'own');
    this.own.replaceChildren(...sights, changeOf(proposal));
    this.look(around(boxOf(proposal)));
  }

  /// Makes what one visit saw stand out; -1: none of them.
  point(visit) {
    [...this.own.querySelectorAll('.sight')].forEach((sight, k) => sight.classList.toggle('pointed', k === visit));
  }
}

/// An object as it is mapped, and as it would be.
export function changeOf({ about, picture }) {
  return svg('g', { class: `change ${about.change}` }, path(picture.mapped, 'mapped'), path(picture.proposed, 'proposed'));
}

/// A box with some of its surroundings.
function around([x, y, X, Y]) {
  const span = Math.max(X - x, Y - y, kLeastWidth_m / (1 + 2 * kAround)) * (1 + 2 * kAround);
  const cx = (x + X) / 2,
    cy = (y + Y) / 2;
  return [
    Math.min(x, cx - span / 2),
    cy - Math.max(Y - y, span / 2) / 2,
    Math.max(X, cx + span / 2),
    cy + Math.max(Y - y, span / 2) / 2,
  ];
}
