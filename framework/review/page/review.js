/// Which proposals are on the list: [name, what it is called, test].
export const kFilters = [
  ['all', 'All', () => true],
  ['undecided', 'Undecided', ({ answer }) => answer === 'undecided'],
  ['accepted', 'Accepted', ({ answer }) => answer === 'accepted'],
  ['refused', 'Refused', ({ answer }) => answer === 'refused'],
  ['conflicts', 'Conflicts', ({ objection }) => objection !== ''],
];

const kNothing = { answer: 'undecided', by: '', at: '', note: '' };
const saidOf = ({ answer, by, at, note }) => ({ answer, by, at, note });

/// Proposals, what was said of them, and which one is on show. Listeners hear of every change.
export class Review {
  constructor(data) {
    this.document = data.document;
    this.proposals = data.proposals.map((proposal, number) => ({ ...proposal, ...kNothing, ...data.answers[number], number }));
    this.filter = 'all';
    this.number = 0;
    this.by = '';
    this.message = '';
    this.unsaved = new Set();
    this.history = [];
    this.listeners = [];
    this.toFirstUndecided();
  }

  onChange(listener) {
    this.listeners.push(listener);
  }

  tell(message = '') {
    this.message = message;
    for (const listener of this.listeners) listener();
  }

  get current() {
    return this.proposals[this.number];
  }

  count(filter) {
    const [, , test] = kFilters.find(([name]) => name === filter);
    return this.proposals.filter(test).length;
  }

  get decided() {
    return this.proposals.length - this.count('undecided');
  }

  /// What is on the list.
  shown() {
    const [, , test] = kFilters.find(([name]) => name === this.filter);
    return this.proposals.filter(test);
  }

  choose(filter) {
    this.filter = filter;
    const shown = this.shown();
    if (shown.length > 0 && !shown.includes(this.current)) this.number = shown[0].number;
    this.tell();
  }

  show(number) {
    this.number = number;
    this.tell();
  }

  /// One further on the list, or back.
  move(by) {
    const shown = this.shown(),
      place = shown.indexOf(this.current);
    const next = shown[Math.min(shown.length - 1, Math.max(0, place + by))];
    if (next) this.show(next.number);
  }

  toFirstUndecided() {
    const first = this.proposals.find(({ answer }) => answer === 'undecided');
    if (first) this.number = first.number;
  }

  /// Says something of the proposal on show, and goes on to the next undecided one.
  decide(answer) {
    const { current } = this;
    if (!current) return;
    if (answer === 'accepted' && current.objection) return this.tell(`This one cannot be accepted: ${current.objection}.`);
    const list = this.shown();
    this.say(current, { answer, by: this.by, at: answer === 'undecided' ? '' : now(), note: current.note });
    this.goOn(list, current);
    this.tell();
  }

  say(proposal, said) {
    this.history.push([proposal.number, saidOf(proposal)]);
    Object.assign(proposal, said);
    this.unsaved.add(proposal.number);
  }

  goOn(list, from) {
    const place = list.indexOf(from),
      inTurn = [...list.slice(place + 1), ...list.slice(0, place)];
    const next = inTurn.find(({ answer }) => answer === 'undecided') ?? (this.shown().includes(from) ? from : inTurn[0]);
    if (next) this.number = next.number;
  }

  annotate(note) {
    const { current } = this;
    if (note === current.note) return;
    if (current.answer === 'undecided') {
      current.note = note; // goes with the decision
      return;
    }
    this.say(current, { ...saidOf(current), note });
    this.tell();
  }

  /// Takes the last thing back that was said, and shows what it was about.
  undo() {
    const last = this.history.pop();
    if (!last) return this.tell('There is nothing to take back.');
    const [number, before] = last;
    Object.assign(this.proposals[number], before);
    this.unsaved.add(number);
    this.number = number;
    if (!this.shown().includes(this.current)) this.filter = 'all';
    this.tell('Taken back.');
  }

  /// What is kept elsewhere, but for what was said here since.
  adopt(answers) {
    for (const proposal of this.proposals)
      if (!this.unsaved.has(proposal.number) && (answers[proposal.number] || proposal.answer !== 'undecided'))
        Object.assign(proposal, kNothing, answers[proposal.number]);
  }

  /// The document of these decisions.
  documentOf(proposals) {
    const decisions = proposals.map(({ about, answer, by, at, note }) => ({
      about,
      answer,
      ...Object.fromEntries(Object.entries({ by, at, note }).filter(([, text]) => text !== '')),
    }));
    return { ...this.document, decisions };
  }

  get wholeDocument() {
    return this.documentOf(this.proposals.filter(({ answer }) => answer !== 'undecided'));
  }
}

const now = () => `${new Date().toISOString().slice(0, 19)}Z`;
