/// Shortcuts, as the help lists them: [keys, what they do, action]. They work everywhere but in fields that take text.
export function listenToKeys(shortcuts, overlayOpen) {
  const actions = new Map(shortcuts.flatMap(([keys, , act]) => keys.map((key) => [key, act])));
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || overlayOpen()) return;
    const { target } = event,
      takesText = target.matches('input[type=search], input[type=text], select, textarea');
    if (takesText && event.key !== 'Escape') return;
    if (event.key === ' ' && target.matches('button, summary, input')) return; // their own
    const act = actions.get(event.key);
    if (!act || act(event) === false) return;
    event.preventDefault();
  });
}
