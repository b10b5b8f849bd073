import { GlobalPane } from './global_pane.js';
import { LocalPane } from './local_pane.js';
import { sceneAt } from './scene.js';
import { WordsPanel } from './words_panel.js';

/// One run on the page: its two maps, its words, and the update that is on show.
export class RunView {
  constructor(run, recording, state, letter) {
    this.run = run;
    this.recording = recording;
    this.state = state;
    const title = (words) => (letter ? `${letter} · ${words}` : words);
    this.global = new GlobalPane(run, title('Global map'), state);
    this.local = new LocalPane(run, title('Local map'), state);
    this.words = new WordsPanel(letter ? `${letter} · ${recording.name}` : 'Now');
    this.frame = -1;
    this.scene = null;
  }

  /// `frame` -1: this run has no update yet at this time.
  paint(frame, palette, theme) {
    if (this.recording.map) this.global.setMap(this.recording.map);
    this.frame = frame;
    const selected = this.run === this.state.run ? this.state.selected : -1;
    this.scene = frame < 0 ? null : sceneAt(this.recording, frame, selected);
    this.global.paint(this.scene, palette, theme);
    this.local.paint(this.scene, palette);
  }
}
