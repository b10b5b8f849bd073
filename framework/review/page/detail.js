import { element, setHidden, setText } from '../../viewer/page/dom.js';
import { kSigns, nameOf } from './list.js';

const kChanges = { moved: 'stands elsewhere', gone: 'is gone', added: 'is not on the map' };
const kLegend = [
  ['building', 'the map'],
  ['mapped', 'this object, as mapped'],
  ['proposed', 'as it would be'],
  ['other', 'other proposals'],
];

/// The words about the proposal on show, and what can be said of it.
export class Detail {
  constructor(review, picture) {
    this.review = review;
    this.picture = picture;
    this.sign = element('span', { class: 'sign', 'aria-hidden': 'true' });
    this.title = element('h2', {});
    this.id = element('p', { class: 'quiet id' });
    this.sentence = element('p', { class: 'sentence' });
    this.doubt = element('p', { class: 'doubt' });
    this.objection = element('p', { class: 'objection', role: 'note' });
    this.accept = this.button('Accept', 'a', 'accepted');
    this.refuse = this.button('Refuse', 'r', 'refused');
    this.undo = element(
      'button',
      { type: 'button', class: 'tool', onclick: () => review.undo() },
      'Undo ',
      element('kbd', { text: 'u' }),
    );
    this.note = element('input', {
      type: 'text',
      class: 'note',
      maxlength: 500,
      placeholder: 'Note (optional)',
      'aria-label': 'Note',
      onchange: () => review.annotate(this.note.value.trim()),
      onkeydown: ({ key }) => key === 'Enter' && this.note.blur(),
    });
    this.said = element('p', { class: 'quiet said' });
    this.message = element('p', { class: 'message', role: 'status' });
    this.visits = element('tbody');
    this.legend = element('p', { class: 'legend quiet' });
    this.build();
  }

  button(words, key, answer) {
    const act = () => this.review.decide(this.review.current.answer === answer ? 'undecided' : answer);
    return element(
      'button',
      { type: 'button', class: `tool decide ${answer}`, onclick: act },
      `${words} `,
      element('kbd', { text: key }),
    );
  }

  build() {
    this.head = element('header', {}, this.sign, element('div', {}, this.title, this.id));
    this.actions = element('div', { class: 'actions' }, this.accept, this.refuse, this.undo, this.note);
    this.words = element(
      'section',
      { class: 'words', 'aria-label': 'The proposal' },
      this.head,
      this.sentence,
      this.doubt,
      this.objection,
      this.actions,
      this.said,
      this.message,
    );
    this.table = element(
      'section',
      { class: 'visits', 'aria-label': 'What each visit saw' },
      element('h3', { text: 'What each visit saw' }),
      element('table', {}, this.visits),
    );
  }

  update() {
    const { current, message } = this.review;
    this.accept.disabled = current.objection !== '';
    this.accept.setAttribute('aria-pressed', String(current.answer === 'accepted'));
    this.refuse.setAttribute('aria-pressed', String(current.answer === 'refused'));
    this.undo.disabled = this.review.history.length === 0;
    if (document.activeElement !== this.note || this.shown !== current) this.note.value = current.note;
    setText(this.said, saidWords(current));
    setText(this.message, message);
    setHidden(this.message, message === '');
    if (this.shown !== current) this.show(current);
  }

  show(proposal) {
    this.shown = proposal;
    const { about, notes, objection } = proposal;
    this.sign.className = `sign ${about.change}`;
    setText(this.sign, kSigns[about.change]);
    setText(this.title, `${nameOf(proposal)} ${kChanges[about.change]}`);
    const where = [notes.name ? about.id : '', proposal.type.replace(/^opal:/, ''), notes.storey ?? ''];
    setText(this.id, where.filter((word) => word).join(' · '));
    setText(this.sentence, proposal.sentence);
    setText(this.doubt, proposal.proposed ? '' : '? Less probable than asked for: drives alone would not change the map here.');
    setHidden(this.doubt, proposal.proposed);
    setText(
      this.objection,
      objection &&
        `Cannot be accepted: ${objection}. The map stays as it is until drives agree. Refuse it to take it off the list of what is undecided.`,
    );
    setHidden(this.objection, !objection);
    this.legend.className = `legend quiet ${about.change}`;
    this.legend.replaceChildren(
      ...legendOf(proposal).flatMap(([kind, words]) => [element('i', { class: kind }), element('span', { text: words })]),
    );
    this.visits.replaceChildren(...proposal.sights.map((sight, k) => this.row(sight, k)));
  }

  row({ drive, agrees, words }, k) {
    const { faces, circles } = this.shown.picture.sights[k];
    const isDrawn = faces.length + circles.length > 0;
    const cells = [
      element('td', {}, isDrawn ? element('i', { class: `swatch v${k % 6}` }) : ''),
      element('td', { class: 'drive', text: drive }),
      element('td', { text: words }),
      element('td', { class: agrees ? 'for' : 'against', text: agrees ? 'for' : 'against' }),
    ];
    return element('tr', { onmouseenter: () => this.picture.point(k), onmouseleave: () => this.picture.point(-1) }, ...cells);
  }
}

/// What is in the picture: [class, words].
function legendOf({ about, objection }) {
  const legend = new Map(kLegend);
  if (about.change === 'added') legend.delete('mapped');
  if (about.change === 'gone') {
    legend.delete('proposed');
    legend.set('mapped', 'this object, which would not be looked for');
  } else if (objection) legend.set('proposed', 'what drives say together');
  return [...legend];
}

function saidWords({ answer, by, at, note }) {
  if (answer === 'undecided') return 'Undecided.';
  const when = at ? ` on ${at.slice(0, 10)} at ${at.slice(11, 16)} UTC` : '';
  return `${answer === 'accepted' ? 'Accepted' : 'Refused'}${by ? ` by ${by}` : ''}${when}.${note ? ` Note: ${note}` : ''}`;
}
