/// Draws every plot of a page from the data beside it, as wide as its place is, and again when that changes.
import { select } from 'd3-selection';
import { drawBars } from './bars.js';
import { drawIntervals } from './intervals.js';
import { drawLines } from './lines.js';
import { drawScatter } from './scatter.js';

const kDrawings = { bars: drawBars, intervals: drawIntervals, lines: drawLines, scatter: drawScatter };

for (const place of document.querySelectorAll('.plot')) {
  const plot = JSON.parse(place.querySelector('script').textContent);
  let drawn_px = 0;
  const draw = () => {
    if (place.clientWidth === drawn_px || place.clientWidth === 0) return;
    drawn_px = place.clientWidth;
    select(place).selectAll('.drawn').remove();
    kDrawings[plot.kind](select(place), plot, drawn_px);
  };
  draw();
  new ResizeObserver(draw).observe(place);
}
