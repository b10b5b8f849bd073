/// All layers, in the order of the menu: [name, label, on at first].
export const kLayers = [
  ['objects', 'Mapped objects', true],
  ['unperceivable', 'Features this sensor cannot see', true],
  ['patterns', 'Mapped patterns', false],
  ['names', 'Names of objects', false],
  ['free', 'Free space', true],
  ['scan', 'Scan', true],
  ['features', 'Local features', true],
  ['associations', 'Associations', true],
  ['hypotheses', 'Hypotheses', true],
  ['labels', 'Labels of hypotheses', true],
  ['findings', 'Findings', true],
  ['ended', 'What has just ended or been refused', true],
  ['trajectory', 'Estimated trajectory', true],
  ['truth', 'Recorded truth', true],
  ['observed', 'Observed patterns', true],
];

export const kAssociationChoices = ['best', 'selected', 'all'];
export const kSpeeds = [0.25, 0.5, 1, 2, 4, 8, 16, 32];

/// What the reader has chosen, in one place. set() tells all listeners which of it changed.
export class AppState {
  constructor() {
    this.listeners = [];
    this.time = 0;
    this.playing = false;
    this.speed = 1;
    this.window = 0;
    this.run = 0; ///< the run that lists and details are about
    this.selected = -1; ///< hypothesis of that run
    this.object = -1; ///< mapped feature that was picked from the list
    this.layers = new Set(kLayers.filter(([, , on]) => on).map(([name]) => name));
    this.associations = 'selected';
    this.follow = false;
    this.eventKind = -1;
    this.newest = false; ///< live: stay at the newest update
    this.view = { x: 0, y: 0, scale: 20, fitted: false, auto: false };
    this.localScale = 0; ///< px per m; 0: as large as the local map allows
  }

  set(patch) {
    const changed = new Set();
    for (const [name, value] of Object.entries(patch)) {
      if (this[name] === value) continue;
      this[name] = value;
      changed.add(name);
    }
    if (changed.size > 0) for (const listener of this.listeners) listener(changed);
  }

  toggleLayer(name, on = !this.layers.has(name)) {
    const layers = new Set(this.layers);
    if (on) layers.add(name);
    else layers.delete(name);
    this.set({ layers });
  }

  onChange(listener) {
    this.listeners.push(listener);
  }
}
