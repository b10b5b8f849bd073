const kPan_px = 60,
  kZoom = 1.3;

/// All keys: [keys, what they do, action]. An action that returns false leaves the key to the browser.
export function shortcutsOf(app) {
  const { state } = app;
  const pane = () => app.views[state.run]?.global;
  const onMap = (event) => event.target.classList.contains('pane-top');
  const onLocal = (event) => onMap(event) && event.target.closest('.pane-local');
  const zoom = (factor) => (event) => (onLocal(event) ? app.views[state.run].local : pane())?.zoom(factor);
  const move = (dx, dy, otherwise) => (event) => (onMap(event) ? pane()?.move(dx, dy) : otherwise ? otherwise() : false);
  return [
    [[' '], 'play or pause', () => app.player.toggle()],
    [['ArrowRight'], 'one update on (on a map: move it)', move(-kPan_px, 0, () => app.moves.step(1))],
    [['ArrowLeft'], 'one update back (on a map: move it)', move(kPan_px, 0, () => app.moves.step(-1))],
    [['ArrowUp', 'ArrowDown'], 'on a map: move it', (event) => move(0, event.key === 'ArrowUp' ? kPan_px : -kPan_px)(event)],
    [['n'], 'next event', () => app.moves.jump(1)],
    [['p'], 'previous event', () => app.moves.jump(-1)],
    [['>'], 'faster', () => app.player.faster(1)],
    [['<'], 'slower', () => app.player.faster(-1)],
    [
      ['Home', 'End'],
      'first, last update',
      (event) => app.moves.seekTime(event.key === 'Home' ? app.timeLine.begin : app.timeLine.end),
    ],
    [['z'], 'stretch time around the moment', () => app.time.stretch(0.5)],
    [['Z'], 'more time', () => app.time.stretch(2)],
    [['+', '='], 'zoom in', zoom(kZoom)],
    [['-', '_'], 'zoom out', zoom(1 / kZoom)],
    [['0'], 'fit the map', () => pane()?.fit()],
    [['f'], 'follow the robot', () => state.set({ follow: !state.follow })],
    [[']'], 'next hypothesis', () => app.moves.cycle(1)],
    [['['], 'previous hypothesis', () => app.moves.cycle(-1)],
    [['b'], 'select the best hypothesis', () => selectBest(app)],
    [['.'], 'next mapped feature', () => app.moves.cycleObjects(1)],
    [[','], 'previous mapped feature', () => app.moves.cycleObjects(-1)],
    [['1', '2', '3'], 'list: hypotheses, tree, map', (event) => openTab(app, Number(event.key) - 1)],
    [['w'], 'to the words of this moment', () => app.views[state.run]?.words.body.focus()],
    [['m'], 'to the map', () => pane()?.pane.moving.focus()],
    [['l'], 'layers', () => app.header.layers.toggle()],
    [
      ['r'],
      'with two runs: lists of the other one',
      () => app.views.length > 1 && state.set({ run: 1 - state.run, selected: -1 }),
    ],
    [['t'], 'light, dark, as the system', () => app.theme.next()],
    [['Escape'], 'select none', () => state.set({ selected: -1, object: -1 })],
    [['?'], 'this help', () => app.help.open()],
  ];
}

function selectBest(app) {
  const { scene } = app.views[app.state.run] ?? {};
  if (scene && scene.best >= 0) app.state.set({ selected: scene.best });
}

function openTab(app, position) {
  app.tabs.open(position);
  app.tabs.panel.list.root.focus();
}
