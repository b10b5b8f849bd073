/// Intervals in rows (a forest plot, Lewis & Clarke 2001): a column of drawings in the table that says the same in numbers.
import { drawAxis, newDrawing, number, scaleOf, titleOf } from './axes.js';

const kWidth_px = 340,
  kRow_px = 26,
  kBox = { left: 14, right: kWidth_px - 14, top: 0, bottom: kRow_px };

/// An end beyond the plot, or without bounds, is an arrow.
function drawWhisker(svg, scale, [low, high]) {
  const y = kRow_px / 2,
    [from, to] = scale.domain();
  svg.append('line').attr('class', 'whisker').attr('x1', scale(low)).attr('x2', scale(high)).attr('y1', y).attr('y2', y);
  if (low < from) svg.append('path').attr('class', 'arrow').attr('d', `M${kBox.left},${y}l7,-4v8z`);
  if (high > to) svg.append('path').attr('class', 'arrow').attr('d', `M${kBox.right},${y}l-7,-4v8z`);
}

/// A square, or a diamond for all together.
function drawRow(svg, scale, row) {
  const y = kRow_px / 2,
    at = number(row.at),
    within = row.within.map(number);
  if (Number.isNaN(at) || within.some(Number.isNaN)) return;
  const x = scale(at);
  if (!row.total) drawWhisker(svg, scale, within);
  const left = Math.min(scale(within[0]), x - 4.5),
    right = Math.max(scale(within[1]), x + 4.5);
  const path = row.total
    ? `M${left},${y}L${x},${y - 7}L${right},${y}L${x},${y + 7}z`
    : `M${x - 4.5},${y - 4.5}h9v9h-9z`;
  svg.append('path').attr('class', `mark ${row.tone}`).attr('d', path);
}

function cell(row, name, html_class) {
  return row.append(name).attr('class', `drawn ${html_class}`);
}

export function drawIntervals(place, plot) {
  const values = plot.rows.flatMap((row) => [row.at, ...row.within]);
  const scale = scaleOf(plot.axis, [...values, plot.neutral], [kBox.left, kBox.right]);
  const drawing = (row) => {
    const svg = newDrawing(cell(row, 'td', 'interval'), kWidth_px, kRow_px);
    drawAxis(svg, plot.axis, scale, kBox, { below: true, count: 6 }).selectAll('text').remove();
    const x = scale(number(plot.neutral));
    svg.append('line').attr('class', 'neutral').attr('x1', x).attr('x2', x).attr('y1', 0).attr('y2', kRow_px);
    return svg;
  };
  cell(place.select('thead tr'), 'th', 'interval').text(titleOf(plot.axis));
  const rows = place.selectAll('tbody tr').nodes();
  plot.rows.forEach((row, k) => drawRow(drawing(place.selectAll('tbody tr').filter((_, i) => i === k)), scale, row));
  const last = cell(place.select('table'), 'tfoot', '').append('tr');
  last.append('td').attr('colspan', rows[0]?.children.length - 1 || 1);
  const svg = newDrawing(cell(last, 'td', 'interval'), kWidth_px, 22);
  drawAxis(svg, plot.axis, scale, { ...kBox, bottom: 0 }, { below: true, count: 6 });
}
