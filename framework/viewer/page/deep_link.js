import { kAssociationChoices, kLayers } from './app_state.js';

const kPause_ms = 250,
  kPausePlaying_ms = 2000;
const kNames = kLayers.map(([name]) => name);
const kUsual = kLayers
  .filter(([, , on]) => on)
  .map(([name]) => name)
  .join();

/// The moment and the look as text for the address: `t=14.2&sel=17&window=2&view=1,2,20`.
function linkOf(state) {
  const fields = [['t', trimmed(state.time, 4)]];
  if (state.window > 0) fields.push(['window', state.window]);
  if (state.run > 0) fields.push(['run', state.run]);
  if (state.selected >= 0) fields.push(['sel', state.selected]);
  const layers = kNames.filter((name) => state.layers.has(name)).join();
  if (layers !== kUsual) fields.push(['layers', layers || 'none']);
  if (state.associations !== 'selected') fields.push(['assoc', state.associations]);
  if (state.follow) fields.push(['follow', 1]);
  const { x, y, scale, auto } = state.view;
  if (!auto) fields.push(['view', [trimmed(x, 3), trimmed(y, 3), trimmed(scale, 3)].join()]);
  return fields.map(([name, value]) => `${name}=${value}`).join('&');
}

const trimmed = (value, digits) => String(Number(value.toFixed(digits)));

/// What such a text asks for; what cannot be read is left out.
function wishesOf(hash) {
  const fields = new URLSearchParams(hash.replace(/^#/, ''));
  const wishes = {};
  const number = (name) =>
    fields.has(name) && fields.get(name) !== '' && Number.isFinite(Number(fields.get(name))) ? Number(fields.get(name)) : null;
  const take = (name, key, fits) => {
    const value = number(name);
    if (value !== null && fits(value)) wishes[key] = value;
  };
  const whole = (value) => Number.isInteger(value) && value >= 0 && value < 2 ** 31;
  take('t', 'time', (value) => value >= 0);
  take('window', 'window', whole);
  take('run', 'run', whole);
  take('sel', 'selected', whole);
  if (fields.has('layers'))
    wishes.layers = new Set(
      fields
        .get('layers')
        .split(',')
        .filter((name) => kNames.includes(name)),
    );
  if (kAssociationChoices.includes(fields.get('assoc'))) wishes.associations = fields.get('assoc');
  if (fields.has('follow')) wishes.follow = fields.get('follow') === '1';
  const view = (fields.get('view') ?? '').split(',').map(Number);
  if (view.length === 3 && view.every(Number.isFinite) && view[2] > 0)
    wishes.view = { x: view[0], y: view[1], scale: view[2], fitted: true, auto: false };
  return wishes;
}

/// Keeps the address at the moment on show, without a history of every step.
export class DeepLink {
  constructor(state, visit) {
    this.state = state;
    this.timer = 0;
    this.known = location.hash; ///< as last read or written
    window.addEventListener('hashchange', () => {
      if (location.hash !== this.known) visit(this.read());
    });
  }

  read() {
    this.known = location.hash;
    return wishesOf(this.known);
  }

  note() {
    if (!this.timer) this.timer = setTimeout(() => this.write(), this.state.playing ? kPausePlaying_ms : kPause_ms);
  }

  /// An address that somebody has changed meanwhile is a wish that is about to be visited, and stays.
  write() {
    clearTimeout(this.timer);
    this.timer = 0;
    if (location.hash !== this.known) return;
    history.replaceState(null, '', `#${linkOf(this.state)}`);
    this.known = location.hash;
  }
}
