/// Points with what they lie within, and links. What is infinite lies in a lane of its own, beyond a line.
import { drawFrame, newDrawing, number, scaleOf } from './axes.js';

const kLane_px = 44,
  kRadius_px = 4,
  kWidest_px = 520;

/// Where equal points lie beside each other: a spiral (Vogel 1979).
function spiral() {
  const taken = new Map();
  return (x, y) => {
    const key = `${Math.round(x / 3)} ${Math.round(y / 3)}`,
      index = taken.get(key) ?? 0;
    taken.set(key, index + 1);
    const radius = 3.4 * Math.sqrt(index);
    return [x + radius * Math.cos(2.399963 * index), y + radius * Math.sin(2.399963 * index)];
  };
}

/// A link to another page, or nothing where an address does something else.
function linked(svg, address) {
  if (!address || !['file:', 'http:', 'https:'].includes(new URL(address, location.href).protocol)) return svg;
  return svg.append('a').attr('href', address);
}

/// A whole disc, or a half for each of two links.
function drawPoint(svg, [x, y], point) {
  const r = kRadius_px,
    half = (sweep) => `M${x},${y - r}a${r},${r} 0 0 ${sweep} 0,${2 * r}`;
  const parts = point.links ? [`${half(0)}z`, `${half(1)}z`] : [`${half(0)}a${r},${r} 0 0 0 0,${-2 * r}z`];
  parts.forEach((path, k) =>
    linked(svg, point.links?.[k])
      .append('path')
      .attr('class', `dot ${k === 0 ? 'a' : 'b'}`)
      .attr('d', path)
      .append('title')
      .text(point.title),
  );
}

export function drawScatter(place, plot, available_px) {
  const width_px = Math.max(260, Math.min(available_px, kWidest_px)),
    height_px = 0.92 * width_px;
  const svg = newDrawing(place, width_px, height_px);
  const box = { left: 62, right: width_px - 12, top: 12, bottom: height_px - 46 };
  const beyond = plot.points.some((p) => Math.abs(number(p.x)) === Infinity || Math.abs(number(p.y)) === Infinity);
  const lane = beyond ? kLane_px : 0;
  const ends = plot.points.flatMap((p) => [p.y, ...(p.within ?? [])]);
  const both = plot.diagonal && plot.across.from === undefined ? [...plot.points.map((p) => p.x), ...ends] : null;
  const x = scaleOf(plot.across, both ?? plot.points.map((p) => p.x), [box.left, box.right - lane]);
  const y = scaleOf(plot.upwards, both ?? ends, [box.bottom, box.top + lane]);
  drawFrame(svg, plot, x, y, box);
  if (beyond) drawLanes(svg, plot.beyond, box);
  if (plot.diagonal) {
    const from = Math.max(x.domain()[0], y.domain()[0]),
      to = Math.min(x.domain()[1], y.domain()[1]);
    svg.append('line').attr('class', 'neutral').attr('x1', x(from)).attr('y1', y(from)).attr('x2', x(to)).attr('y2', y(to));
  }
  const at = spiral(),
    px = (scale, value, far) => (Math.abs(value) === Infinity ? far : scale(value));
  for (const point of plot.points) {
    const place_px = [px(x, number(point.x), box.right - lane / 2), px(y, number(point.y), box.top + lane / 2)];
    if (!place_px.every(Number.isFinite)) continue;
    if (point.within) {
      const [low, high] = point.within.map((end) => y(number(end)));
      svg.append('line').attr('class', 'whisker').attr('x1', place_px[0]).attr('x2', place_px[0]).attr('y1', low).attr('y2', high);
    }
    drawPoint(svg, point.within ? place_px : at(...place_px), point);
  }
}

function drawLanes(svg, name, box) {
  const x = box.right - kLane_px,
    y = box.top + kLane_px;
  svg.append('path').attr('class', 'beyond').attr('d', `M${x},${box.top}V${box.bottom}M${box.left},${y}H${box.right}`);
  svg.append('text').attr('class', 'middle quiet').attr('x', box.right - kLane_px / 2).attr('y', box.bottom + 16).text(name);
  svg.append('text').attr('class', 'end quiet').attr('x', box.left - 6).attr('y', box.top + kLane_px / 2 + 4).text(name);
}
