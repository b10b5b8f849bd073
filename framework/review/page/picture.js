import { element } from '../../viewer/page/dom.js';
import { listenToPointers } from '../../viewer/page/pan_zoom.js';
import { ViewTransform, fitView, zoomed } from '../../viewer/page/view_transform.js';
import { pathOf } from './shapes.js';

const kSvg = 'http://www.w3.org/2000/svg';
const kBar_px = 110,
  kLengths = [1, 2, 5];

export function svg(tag, attributes = {}, ...children) {
  const node = document.createElementNS(kSvg, tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

export const path = (shapes, kind) => svg('path', { class: kind, d: pathOf(shapes) });

/// A round length that is not longer than `most_m`.
export function roundLength(most_m) {
  const power = 10 ** Math.floor(Math.log10(most_m));
  return Math.max(...kLengths.filter((k) => k * power <= most_m * (1 + 1e-9))) * power;
}

/// A piece of the map to scale, with a bar of metres; it can be moved and zoomed. `metres` is for what is in metres,
/// y up; `pixels` for marks that keep their size.
export class Picture {
  constructor(label, map, { click = () => {} } = {}) {
    this.transform = new ViewTransform({ x: 0, y: 0, scale: 10 });
    this.metres = svg('g', { class: 'metres' }, path({ ...map, points: [] }, 'building'));
    this.pixels = svg('g', { class: 'pixels' });
    this.svg = svg('svg', { role: 'img', 'aria-label': label }, this.metres, this.pixels);
    this.bar = element('div', { class: 'bar' });
    this.root = element('div', { class: 'picture' }, this.svg, this.bar, this.buttons());
    this.box = [0, 0, 1, 1];
    listenToPointers(this.svg, {
      pan: (dx, dy) => this.pan(dx, dy),
      zoom: (factor, x, y) => this.zoom(factor, x, y),
      click,
      hover: () => {},
      leave: () => {},
    });
    new ResizeObserver(() => this.resize()).observe(this.root);
  }

  buttons() {
    const button = (text, label, act) =>
      element('button', { type: 'button', class: 'tool', text, title: label, 'aria-label': label, onclick: act });
    return element(
      'div',
      { class: 'zoom' },
      button('+', 'Zoom in', () => this.zoom(1.4)),
      button('−', 'Zoom out', () => this.zoom(1 / 1.4)),
      button('⤢', 'Show all of it', () => this.fit()),
    );
  }

  resize() {
    this.transform.width = this.root.clientWidth;
    this.transform.height = this.root.clientHeight;
    if (this.transform.view.auto !== false) this.fit();
    else this.draw();
  }

  /// Shows this box [x, y, x, y], now and when asked for all of it.
  look(box) {
    this.box = box;
    this.fit();
  }

  fit() {
    this.transform.view = fitView(this.box, this.transform.width, this.transform.height);
    this.draw();
  }

  pan(dx, dy) {
    const { view } = this.transform;
    this.transform.view = { ...view, x: view.x - dx / view.scale, y: view.y + dy / view.scale, auto: false };
    this.draw();
  }

  zoom(factor, x = this.transform.width / 2, y = this.transform.height / 2) {
    this.transform.view = { ...zoomed(this.transform, factor, x, y), auto: false };
    this.draw();
  }

  draw() {
    const { transform } = this;
    const { scale } = transform;
    this.metres.setAttribute('transform', `matrix(${scale} 0 0 ${-scale} ${transform.x(0)} ${transform.y(0)})`);
    for (const mark of this.pixels.children)
      mark.setAttribute('transform', `translate(${transform.x(Number(mark.dataset.x))} ${transform.y(Number(mark.dataset.y))})`);
    const length_m = roundLength(kBar_px / scale);
    this.bar.style.width = `${length_m * scale}px`;
    this.bar.textContent = length_m < 1 ? `${Math.round(100 * length_m)} cm` : `${length_m} m`;
  }
}
