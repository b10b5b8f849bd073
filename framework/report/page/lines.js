/// Lines over a common axis, one below the other, and a bar of coloured spans below.
import { line } from 'd3-shape';
import { drawAxis, newDrawing, number, scaleOf, titleOf } from './axes.js';

const kPanel_px = 78,
  kGap_px = 20,
  kBar_px = 10;

function drawPanel(svg, plot, panel, x, box) {
  const y = scaleOf(panel.upwards, panel.y, [box.bottom, box.top]);
  drawAxis(svg, panel.upwards, y, box, { below: false, count: 4 });
  svg.append('text').attr('x', box.left + 2).attr('y', box.top - 5).text(titleOf(panel.upwards));
  const shown = panel.y.map(number);
  const path = line()
    .defined((value) => Number.isFinite(value))
    .x((_, k) => x(number(plot.x[k])))
    .y((value) => y(value));
  svg.append('path').attr('class', `line ${panel.tone}`).attr('d', path(shown));
}

export function drawLines(place, plot, available_px) {
  const width_px = Math.max(260, Math.min(available_px, 640)),
    height_px = plot.lines.length * (kPanel_px + kGap_px) + kBar_px + 54;
  const svg = newDrawing(place, width_px, height_px),
    left = 48,
    right = width_px - 12;
  const x = scaleOf(plot.across, [...plot.x, ...plot.spans.map((span) => span.to)], [left, right]);
  let top = kGap_px;
  for (const panel of plot.lines) {
    drawPanel(svg, plot, panel, x, { left, right, top, bottom: top + kPanel_px });
    top += kPanel_px + kGap_px;
  }
  const box = { left, right, top: top - kGap_px / 2, bottom: top - kGap_px / 2 + kBar_px };
  drawAxis(svg, plot.across, x, box, { below: true, count: (right - left) / 70 });
  for (const span of plot.spans)
    svg
      .append('rect')
      .attr('class', `span ${span.tone}`)
      .attr('x', x(number(span.from)))
      .attr('y', box.top)
      .attr('width', Math.max(0.5, x(number(span.to)) - x(number(span.from))))
      .attr('height', kBar_px)
      .append('title')
      .text(span.title);
  svg.append('text').attr('class', 'middle').attr('x', (left + right) / 2).attr('y', box.bottom + 34).text(titleOf(plot.across));
}
