import { element, setHidden, setText } from './dom.js';
import { ViewTransform } from './view_transform.js';

const kSharpest = 2; ///< device pixels per CSS pixel: more costs much and shows little

/// A picture with a title and a tooltip: a canvas that keeps what rarely changes, and one for the rest.
export class Pane {
  constructor(name, title, help, view) {
    this.still = element('canvas', { 'aria-hidden': 'true' });
    this.moving = element('canvas', { tabindex: '0', role: 'application', 'aria-label': `${title}. ${help}`, class: 'pane-top' });
    this.title = element('h2', { class: 'pane-title', text: title });
    this.tip = element('div', { class: 'tip', role: 'status', hidden: true });
    this.tools = element('div', { class: 'pane-tools' });
    this.root = element(
      'section',
      { class: `pane pane-${name}`, 'aria-label': title },
      this.still,
      this.moving,
      this.title,
      this.tools,
      this.tip,
    );
    this.transform = new ViewTransform(view);
  }

  /// Follows the size of its place; true if it has changed.
  resize() {
    const { clientWidth: width, clientHeight: height } = this.root,
      ratio = Math.min(window.devicePixelRatio || 1, kSharpest);
    const t = this.transform;
    if (width === t.width && height === t.height && ratio === t.ratio) return false;
    t.width = Math.max(width, 1);
    t.height = Math.max(height, 1);
    t.ratio = ratio;
    for (const canvas of [this.still, this.moving]) {
      canvas.width = Math.round(t.width * ratio);
      canvas.height = Math.round(t.height * ratio);
    }
    return true;
  }

  clear(canvas, context) {
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    this.transform.usePixels(context);
  }

  showTip(words, x, y) {
    setText(this.tip, words);
    setHidden(this.tip, words === '');
    if (words === '') return;
    const left = x + 16 + this.tip.offsetWidth > this.transform.width ? x - 12 - this.tip.offsetWidth : x + 16;
    const top = y + 14 + this.tip.offsetHeight > this.transform.height ? y - 10 - this.tip.offsetHeight : y + 14;
    this.tip.style.transform = `translate(${Math.max(0, left)}px, ${Math.max(0, top)}px)`;
  }
}
