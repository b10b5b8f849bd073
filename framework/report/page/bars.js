/// Bars from here to there on an axis.
import { drawFrame, newDrawing, number, scaleOf } from './axes.js';

export function drawBars(place, plot, available_px) {
  const width_px = Math.max(260, Math.min(available_px, 520)),
    height_px = 190;
  const svg = newDrawing(place, width_px, height_px);
  const box = { left: 62, right: width_px - 12, top: 12, bottom: height_px - 46 };
  const x = scaleOf(plot.across, plot.bars.flatMap((bar) => [bar.from, bar.to]), [box.left, box.right]);
  const y = scaleOf(plot.upwards, plot.bars.map((bar) => bar.height), [box.bottom, box.top]);
  drawFrame(svg, plot, x, y, box);
  for (const bar of plot.bars) {
    const from = x(number(bar.from)),
      top = y(number(bar.height));
    if (!Number.isFinite(from) || !Number.isFinite(top)) continue;
    svg
      .append('rect')
      .attr('class', 'bar')
      .attr('x', from + 0.5)
      .attr('y', top)
      .attr('width', Math.max(1, x(number(bar.to)) - from - 1))
      .attr('height', box.bottom - top)
      .append('title')
      .text(bar.title);
  }
}
