import { kSpeeds } from './app_state.js';
import { element, setText } from './dom.js';
import { seconds } from './words_of.js';

const kEventChoices = [
  [-1, 'any event'],
  [0, 'status change'],
  [1, 'spawn'],
  [2, 'end'],
  [3, 'search'],
];

/// Play, step, jump, speed, and what time it is. `act` has: play, step(±1), event(±1), speed(x), window(k), follow.
export class Transport {
  constructor(state, act) {
    this.state = state;
    this.play = button('Play', 'Play or pause (space)', 'play', act.play);
    this.speed = select(
      'Speed',
      kSpeeds.map((x) => [x, `${x}×`]),
      (value) => act.speed(value),
    );
    this.kind = select('Events to jump to', kEventChoices, (value) => state.set({ eventKind: value }));
    this.time = element('output', { class: 'time', 'aria-label': 'Time' });
    this.newest = element('button', {
      type: 'button',
      class: 'tool newest',
      text: 'Newest',
      hidden: true,
      'aria-pressed': 'false',
      title: 'Stay at the newest update',
      onclick: act.newest,
    });
    this.root = element(
      'div',
      { class: 'transport', role: 'toolbar', 'aria-label': 'Playback' },
      button('Previous event', 'Previous event (p)', 'previous', () => act.event(-1)),
      button('Step back', 'One update back (left arrow)', 'back', () => act.step(-1)),
      this.play,
      button('Step', 'One update on (right arrow)', 'step', () => act.step(1)),
      button('Next event', 'Next event (n)', 'next', () => act.event(1)),
      this.kind,
      this.speed,
      this.time,
      this.newest,
    );
  }

  update(end, keyframes) {
    setText(this.time, `${seconds(this.state.time)} of ${seconds(end)}${keyframes === '' ? '' : ` · update ${keyframes}`}`);
    this.play.dataset.icon = this.state.playing ? 'pause' : 'play';
    this.play.setAttribute('aria-label', this.state.playing ? 'Pause' : 'Play');
    if (document.activeElement !== this.speed) this.speed.value = String(this.state.speed);
    if (document.activeElement !== this.kind) this.kind.value = String(this.state.eventKind);
    this.newest.setAttribute('aria-pressed', String(this.state.newest));
  }
}

function button(name, title, icon, act) {
  return element('button', { type: 'button', class: 'icon', 'data-icon': icon, 'aria-label': name, title, onclick: act });
}

function select(label, choices, chosen) {
  const node = element(
    'select',
    { 'aria-label': label, title: label, onchange: () => chosen(Number(node.value)) },
    ...choices.map(([value, text]) => element('option', { value: String(value), text })),
  );
  return node;
}
