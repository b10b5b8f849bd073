import { findingsOf } from './hypothesis_log.js';

/// The frame records as text. What is only needed of the moment on show is parsed when it is asked for; the last of each is kept.
export class WrittenRecords {
  constructor() {
    this.lines = [];
    this.last = { record: [-1, null], words: [-1, []], search: [-1, null], findings: [-1, []] };
  }

  remember(name, frame, read) {
    if (this.last[name][0] !== frame) this.last[name] = [frame, read()];
    return this.last[name][1];
  }

  record(frame) {
    return this.remember('record', frame, () => JSON.parse(this.lines[frame]));
  }

  /// `from`: the frame whose record has the words; -1: none has.
  words(from) {
    return from < 0 ? kNone : this.remember('words', from, () => JSON.parse(this.lines[from]).words);
  }

  search(frame) {
    return this.remember('search', frame, () => JSON.parse(this.lines[frame]).search);
  }

  findings(frame, features) {
    return this.remember('findings', frame, () => findingsOf(this.record(frame).findings, features, 'findings'));
  }
}

const kNone = [];
