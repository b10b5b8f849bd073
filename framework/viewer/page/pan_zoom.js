/// Mouse, touch and wheel on a pane, as what they mean. `on` has pan(dx, dy), zoom(factor, x, y), click(x, y), hover(x, y),
/// leave(); all in pixels of the pane.
const kClick_px = 6,
  kWheelStep = 0.0016;

export function listenToPointers(target, on) {
  const held = new Map();
  let travelled = 0,
    spread = 0;
  const place = (event) => {
    const box = target.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const middle = () => {
    const points = [...held.values()];
    return [points.reduce((s, p) => s + p[0], 0) / points.length, points.reduce((s, p) => s + p[1], 0) / points.length];
  };
  const span = () => {
    const [a, b] = [...held.values()];
    return b ? Math.hypot(a[0] - b[0], a[1] - b[1]) : 0;
  };

  target.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    target.setPointerCapture(event.pointerId);
    if (held.size === 0) travelled = 0;
    held.set(event.pointerId, place(event));
    spread = span();
  });
  target.addEventListener('pointermove', (event) => {
    const now = place(event);
    if (!held.has(event.pointerId)) {
      if (event.pointerType !== 'touch') on.hover(...now);
      return;
    }
    const before = middle();
    held.set(event.pointerId, now);
    const after = middle();
    travelled += Math.abs(after[0] - before[0]) + Math.abs(after[1] - before[1]);
    if (travelled > kClick_px || held.size > 1) on.pan(after[0] - before[0], after[1] - before[1]);
    const wider = span();
    if (held.size === 2 && spread > 0 && wider > 0) {
      on.zoom(wider / spread, ...after);
      travelled += kClick_px + 1;
    }
    spread = wider;
  });
  const release = (event) => {
    if (!held.delete(event.pointerId)) return;
    spread = span();
    if (event.type === 'pointerup' && held.size === 0 && travelled <= kClick_px) on.click(...place(event));
  };
  target.addEventListener('pointerup', release);
  target.addEventListener('pointercancel', release);
  target.addEventListener('pointerleave', () => on.leave());
  target.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      on.zoom(Math.exp(-kWheelStep * lines * event.deltaY), ...place(event));
    },
    { passive: false },
  );
}
