import { Announcer } from './announcer.js';
import { AppState } from './app_state.js';
import { DeepLink } from './deep_link.js';
import { DetailsPanel } from './details_panel.js';
import { element } from './dom.js';
import { Header } from './header.js';
import { HelpDialog } from './help_dialog.js';
import { HypothesisList } from './hypothesis_list.js';
import { listenToKeys } from './keyboard.js';
import { ObjectsPanel } from './objects_panel.js';
import { readPalette } from './palette.js';
import { Moves } from './moves.js';
import { Player } from './player.js';
import { RunView } from './run_view.js';
import { kStatuses } from './frame_check.js';
import { shortcutsOf } from './shortcuts.js';
import { Tabs } from './tabs.js';
import { Theme } from './theme.js';
import { TimeLine } from './time_line.js';
import { TimePanel } from './time_panel.js';
import { Transport } from './transport.js';
import { TreePanel } from './tree_panel.js';
import { probabilityWords, seconds } from './words_of.js';

/// Words and lists follow a playing recording this often; the maps follow every picture.
const kPanels_ms = 140;
const kLooks = new Set(['view', 'localScale']); // nothing in words and lists depends on these
const kPanelsShare = 5; // and never for more than a fifth of the time
/// A growing recording redraws its plots at most this often, and never for more than a twentieth of the time.
const kPlots_ms = 500,
  kPlotsShare = 20;

/// The page: one state, the views that show it, and the loop that paints when something has changed.
export class App {
  constructor(root) {
    this.root = root;
    this.state = new AppState();
    this.timeLine = new TimeLine([]);
    this.views = [];
    this.paints = 0;
    this.waiting = [];
    this.theme = new Theme(() => this.recolor());
    this.palette = readPalette();
    this.player = new Player(this.state, this.timeLine);
    this.moves = new Moves(this);
    this.link = new DeepLink(this.state, (wishes) => this.visit(wishes));
    this.build();
    this.state.onChange((changed) => this.changed(changed));
  }

  build() {
    const seek = (frame) => this.moves.seek(frame, this.state.run),
      seekTime = (time) => this.moves.seekTime(time);
    this.tree = new TreePanel(this.state, seek);
    this.list = new HypothesisList(this.state);
    this.objects = new ObjectsPanel(this.state, (feature) => this.showFeature(feature));
    this.details = new DetailsPanel(this.state, seek);
    this.tabs = new Tabs(
      'Lists',
      [
        ['list', 'Hypotheses', this.list],
        ['tree', 'Tree', this.tree],
        ['map', 'Map', this.objects],
      ],
      () => this.updatePanels(),
    );
    this.time = new TimePanel(this.state, seekTime);
    this.transport = new Transport(this.state, {
      play: () => this.player.toggle(),
      step: (by) => this.moves.step(by),
      event: (by) => this.moves.jump(by),
      speed: (speed) => this.state.set({ speed }),
      newest: () => this.moves.toNewest(),
    });
    this.announcer = new Announcer();
    this.shortcuts = shortcutsOf(this);
    this.help = new HelpDialog(this.shortcuts);
    this.header = new Header(this.state, {
      window: (window) => this.moves.selectWindow(window),
      theme: () => this.theme.next(),
      help: () => this.help.open(),
      run: (run) => this.state.set({ run, selected: -1 }),
    });
    this.maps = element('div', { class: 'maps' });
    this.wordsPlace = element('div', { class: 'words-place' });
    const stage = element('div', { class: 'stage' }, this.maps, this.time.root);
    const side = element('div', { class: 'side' }, this.wordsPlace, this.tabs.root, this.details.root);
    this.root.replaceChildren(
      this.header.root,
      element('main', {}, stage, side),
      this.transport.root,
      this.help.root,
      this.announcer.root,
    );
    listenToKeys(this.shortcuts, () => this.help.root.open);
    new ResizeObserver(() => this.invalidate()).observe(this.maps);
  }

  /// Shows these runs from now on; the moment and the look stay as far as they can.
  setRecordings(recordings) {
    const letters = recordings.length > 1 ? ['A', 'B'] : [''];
    this.timeLine.recordings = recordings;
    this.views = recordings.map((recording, run) => new RunView(run, recording, this.state, letters[run]));
    this.maps.replaceChildren(...this.views.flatMap(({ global, local }) => [global.root, local.root]));
    this.root.classList.toggle('compare', recordings.length > 1);
    this.wordsPlace.replaceChildren(...this.views.map(({ words }) => words.root));
    this.timeLine.select(this.state.window);
    this.header.setRecordings(recordings, this.timeLine);
    this.dataChanged();
  }

  /// A younger recording of the same run: what is older than it is gone. The moment stays, if it is still there.
  replaceRecording(recording) {
    const [view] = this.views;
    const dropped = view.recording.windows.length - recording.windows.length;
    view.recording = recording;
    this.timeLine.recordings = [recording];
    this.header.setRecordings([recording], this.timeLine);
    const isGone = this.state.window < dropped;
    this.timeLine.select(Math.max(0, this.state.window - dropped));
    const { window, begin } = this.timeLine;
    const selected = recording.hypotheses.byId.has(this.state.selected) ? this.state.selected : -1;
    this.state.set({ window, selected, time: isGone ? begin : Math.max(begin, this.state.time) });
  }

  /// The first look, once data is there: what the address asks for, else the whole map at the start.
  start() {
    this.visit(this.link.read());
    this.started = true;
    this.fitOnce();
    this.invalidate();
  }

  visit(wishes) {
    const run = Math.min(wishes.run ?? 0, Math.max(0, this.views.length - 1));
    const window = wishes.window ?? this.state.window;
    if (window !== this.timeLine.window) this.timeLine.select(window);
    const time = Math.min(this.timeLine.end, Math.max(this.timeLine.begin, wishes.time ?? this.timeLine.begin));
    this.state.set({ selected: -1, ...wishes, run, window: this.timeLine.window, time, playing: false });
    this.dataChanged();
  }

  /// Recordings have grown, or another window is on show.
  dataChanged() {
    this.timeLine.refresh();
    this.fitOnce();
    this.header.update();
    if (this.state.newest) this.state.set({ time: this.timeLine.end });
    this.showPlotsSoon();
    this.invalidate();
  }

  fitOnce() {
    const [view] = this.views;
    if (!this.started || this.state.view.fitted || !view?.recording.map) return;
    view.global.setMap(view.recording.map);
    view.global.fit();
  }

  showPlotsSoon() {
    if (this.plotsTimer) return;
    const wait = Math.max(0, (this.plotsNext ?? 0) - performance.now());
    this.plotsTimer = setTimeout(() => this.showPlots(), wait);
  }

  showPlots() {
    clearTimeout(this.plotsTimer);
    this.plotsTimer = 0;
    const began = performance.now();
    this.time.show(this.timeLine, this.palette);
    this.plotsNext = performance.now() + Math.max(kPlots_ms, kPlotsShare * (performance.now() - began));
    this.invalidate();
  }

  recolor() {
    this.palette = readPalette();
    if (this.views.length > 0) this.showPlots();
    this.invalidate();
  }

  changed(changed) {
    if (changed.has('object')) this.showFeature(this.state.object, false);
    if (changed.has('selected') || changed.has('run')) this.panelsDue = 0;
    if (changed.has('run')) this.time.repaint();
    if (changed.has('window') && this.timeLine.window !== this.state.window) this.moves.selectWindow(this.state.window);
    this.link.note();
    this.invalidate([...changed].every((name) => kLooks.has(name)));
  }

  showFeature(feature, move = true) {
    const { global } = this.views[this.state.run] ?? {};
    if (!global) return;
    if (feature < 0) global.pane.showTip('', 0, 0);
    else if (move || document.activeElement !== global.pane.moving || !global.pane.tip.textContent) global.showFeature(feature);
  }

  /// Paints soon; words and lists, too, unless they cannot have changed.
  invalidate(onlyPanes = false) {
    if (!onlyPanes) this.panelsStale = true;
    if (this.due) return;
    this.due = true;
    requestAnimationFrame((now) => this.paint(now));
  }

  paint(now) {
    this.due = false;
    this.player.tick(now);
    if (this.state.playing) this.invalidate(true);
    if (this.views.length === 0) return this.settle();
    if (!this.time.timeLine) this.showPlots();
    const frames = this.views.map((_, run) => this.timeLine.frameAt(run, this.state.time));
    if (this.state.follow) this.follow(frames);
    this.views.forEach((view, run) => view.paint(frames[run], this.palette, this.theme.name));
    this.time.follow();
    this.paints += 1;
    if (this.panelsStale && (!this.state.playing || now >= (this.panelsDue ?? 0))) this.updatePanels(now);
    this.settle();
  }

  settle() {
    for (const resolve of this.waiting.splice(0)) resolve();
  }

  /// Keeps the hypothesis on show in the middle.
  follow(frames) {
    const { recording, global } = this.views[this.state.run],
      frame = frames[this.state.run];
    if (frame < 0) return;
    const id = recording.rows.find(frame, this.state.selected) >= 0 ? this.state.selected : recording.best.values[frame];
    const row = recording.rows.find(frame, id);
    if (row < 0) return;
    const [x, y] = recording.rows.poseOf(row),
      { view } = this.state;
    if (view.x !== x || view.y !== y) this.state.view = { ...view, x, y, auto: false };
    global.transform.view = this.state.view;
  }

  updatePanels(now = performance.now()) {
    const began = performance.now();
    const view = this.views[this.state.run];
    if (!view) return;
    this.panelsStale = false;
    const frames = this.views.map(({ frame }) => frame);
    const updates = this.views.map(({ recording, frame }) => (frame < 0 ? '–' : recording.keyframe.values[frame]));
    this.time.readOut(frames);
    this.transport.update(this.timeLine.end, updates.join(' | '));
    for (const { words, recording, frame } of this.views) words.update(recording, frame);
    this.tabs.panel.update(view.scene);
    this.details.update(view.scene);
    this.header.update();
    if (view.frame >= 0) this.announce(view);
    this.panelsDue = now + Math.max(kPanels_ms, kPanelsShare * (performance.now() - began));
  }

  announce({ recording, frame }) {
    const status = kStatuses[recording.status.values[frame]],
      p = recording.probability.values[frame];
    this.announcer.note(status, `${seconds(this.state.time)}: ${status}, probability ${probabilityWords(p)}`, this.state.playing);
  }
}
