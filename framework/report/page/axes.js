/// Scales and axes by d3, the same in all plots.
import { extent, ticks } from 'd3-array';
import { axisBottom, axisLeft } from 'd3-axis';
import { scaleLinear, scaleLog } from 'd3-scale';

/// Numbers that are not finite stand as words in the data; what is no number is a gap.
export const number = (value) => (value === null || value === undefined ? NaN : Number(value));

export const titleOf = (axis) => (axis.unit ? `${axis.name} [${axis.unit}]` : axis.name);

/// Round numbers between the ends of a scale; a logarithmic one over few decades has too few of its own.
function ticksOf(scale, logarithmic, count) {
  if (!logarithmic) return scale.ticks(count);
  const beginningWith = (digits) => scale.ticks(count).filter((tick) => digits.test(tick.toExponential()));
  const some = [/^[125]/, /^1e/].map(beginningWith).find((found) => found.length >= 3 && found.length <= count + 1);
  const decades = beginningWith(/^1e/);
  return some ?? (decades.length >= 3 ? decades : ticks(...scale.domain(), count));
}

/// A scale over all finite values and what the axis wants shown at least; some room is left around.
export function scaleOf(axis, values, range) {
  const shown = [...values.map(number), number(axis.from), number(axis.to)];
  let [low, high] = extent(shown.filter((v) => Number.isFinite(v) && (!axis.logarithmic || v > 0)));
  if (low === undefined) [low, high] = axis.logarithmic ? [1, 10] : [0, 1];
  const factor = Math.max(high / low, 1.1) ** 0.06,
    room = 0.06 * (high - low || Math.abs(low) || 1);
  const from = low === number(axis.from) ? low : axis.logarithmic ? low / factor : low - room;
  const to = high === number(axis.to) ? high : axis.logarithmic ? high * factor : high + room;
  return (axis.logarithmic ? scaleLog() : scaleLinear()).domain([from, to]).range(range).clamp(true);
}

const word = (value) => String(Number(value.toPrecision(4)));

/// An axis with lines across the plot. `box`: its edges [px].
export function drawAxis(svg, axis, scale, box, { below, count = 6 }) {
  const across = below ? box.bottom - box.top : box.right - box.left;
  const made = (below ? axisBottom : axisLeft)(scale).tickValues(ticksOf(scale, axis.logarithmic, count));
  return svg
    .append('g')
    .attr('class', 'axis')
    .attr('transform', below ? `translate(0,${box.bottom})` : `translate(${box.left},0)`)
    .call(made.tickFormat(word).tickSize(-across).tickPadding(5));
}

/// Both axes and their names.
export function drawFrame(svg, plot, x, y, box) {
  drawAxis(svg, plot.across, x, box, { below: true, count: (box.right - box.left) / 70 });
  drawAxis(svg, plot.upwards, y, box, { below: false, count: (box.bottom - box.top) / 50 });
  const middle = (box.top + box.bottom) / 2;
  svg.append('text').attr('class', 'middle').attr('x', (box.left + box.right) / 2).attr('y', box.bottom + 36).text(titleOf(plot.across));
  svg.append('text').attr('class', 'middle').attr('transform', `translate(14,${middle}) rotate(-90)`).text(titleOf(plot.upwards));
}

export function newDrawing(place, width_px, height_px) {
  return place.append('svg').attr('class', 'drawn').attr('viewBox', `0 0 ${width_px} ${height_px}`).attr('width', width_px).attr('height', height_px);
}
