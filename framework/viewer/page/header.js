import { element, setText } from './dom.js';
import { LayersMenu } from './layers_menu.js';

/// What is on show: run, window, live state; and the switches of the page. `act` has window(k), run(k), theme, help.
export class Header {
  constructor(state, act) {
    this.state = state;
    this.name = element('span', { class: 'run-name' });
    this.notes = element(
      'details',
      { class: 'menu notes', hidden: true },
      element('summary', { class: 'tool', text: 'About' }),
      element('div', { class: 'menu-body' }),
    );
    this.window = element('select', {
      'aria-label': 'Window of the recording',
      hidden: true,
      onchange: () => act.window(Number(this.window.value)),
    });
    this.layers = new LayersMenu(state);
    this.follow = element('button', {
      type: 'button',
      class: 'tool',
      text: 'Follow',
      'aria-pressed': 'false',
      title: 'Follow the robot (f)',
      onclick: () => state.set({ follow: !state.follow }),
    });
    this.run = element('button', {
      type: 'button',
      class: 'tool',
      hidden: true,
      title: 'Lists of the other run (r)',
      onclick: () => act.run(1 - state.run),
    });
    this.live = element('span', { class: 'live', role: 'status', hidden: true });
    this.alerts = element('div', { class: 'alerts', role: 'alert' });
    this.root = element(
      'header',
      { class: 'page-header' },
      element(
        'div',
        { class: 'bar-row' },
        element('h1', { text: 'Opal' }),
        this.name,
        this.live,
        this.window,
        element('span', { class: 'spring' }),
        this.run,
        this.notes,
        this.follow,
        this.layers.root,
        element('button', {
          type: 'button',
          class: 'tool',
          text: 'Theme',
          title: 'Light, dark, as the system (t)',
          onclick: act.theme,
        }),
        element('button', {
          type: 'button',
          class: 'tool',
          text: '?',
          'aria-label': 'Keys and signs',
          title: 'Keys and signs (?)',
          onclick: act.help,
        }),
      ),
      this.alerts,
    );
  }

  setRecordings(recordings, timeLine) {
    this.recordings = recordings;
    this.timeLine = timeLine;
    this.update();
  }

  update() {
    const { recordings = [], timeLine } = this;
    const names = recordings.map(({ header, name }) =>
      header
        ? [header.log, header.config]
            .filter((t) => typeof t === 'string')
            .map(fileName)
            .join(' · ')
        : name,
    );
    setText(this.name, names.length > 1 ? names.map((name, k) => `${'AB'[k]}: ${name}`).join('   ') : (names[0] ?? ''));
    this.name.title = this.name.textContent;
    if (timeLine) this.updateWindows(timeLine);
    this.updateNotes(recordings);
    this.layers.update();
    this.follow.setAttribute('aria-pressed', String(this.state.follow));
    this.run.hidden = recordings.length < 2;
    setText(this.run, `Lists: ${'AB'[this.state.run] ?? ''}`);
  }

  updateWindows(timeLine) {
    const windows = timeLine.windows();
    this.window.hidden = windows.length < 2;
    if (this.window.childElementCount !== windows.length)
      this.window.replaceChildren(
        ...windows.map(([k, { name }]) => element('option', { value: String(k), text: name.slice(0, 60) || `window ${k}` })),
      );
    if (document.activeElement !== this.window) this.window.value = String(timeLine.window);
  }

  /// Where the data comes from, and what was left out of it.
  updateNotes(recordings) {
    const lines = recordings.flatMap(({ header, map, name }) =>
      header ? describe(header, map, recordings.length > 1 ? name : '') : [],
    );
    this.notes.hidden = lines.length === 0;
    if (this.noted === lines.join('\n')) return;
    this.noted = lines.join('\n');
    this.notes.lastElementChild.replaceChildren(...lines.map((text) => element('p', { text })));
  }

  alert(words) {
    this.alerts.append(element('p', { text: words }));
  }

  setLive(name, words) {
    this.live.hidden = false;
    this.live.dataset.live = name;
    setText(this.live, words);
  }
}

const fileName = (path) => path.slice(path.lastIndexOf('/') + 1);

function describe(header, map, name) {
  const facts = ['log', 'config', 'map', 'sensor', 'opal']
    .filter((key) => typeof header[key] === 'string')
    .map((key) => `${key}: ${header[key]}`);
  const counts = map ? [`${map.objects.length} objects, ${map.features.length} features, ${map.patterns.length} patterns`] : [];
  return [...(name ? [name] : []), ...facts, ...counts, ...header.reduced];
}
