import { element, setText } from './dom.js';

const kPause_ms = 700;

/// Tells screen readers what has changed, once things are quiet: at rest the moment, while playing only a new status.
export class Announcer {
  constructor() {
    this.root = element('div', { class: 'unseen', role: 'status', 'aria-live': 'polite' });
    this.timer = 0;
    this.status = '';
  }

  note(status, moment, playing) {
    const news = playing ? (status === this.status ? '' : status) : moment;
    this.status = status;
    if (news === '' || news === this.last) return;
    this.last = news;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => setText(this.root, news), playing ? 0 : kPause_ms);
  }
}
