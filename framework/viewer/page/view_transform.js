/// From metres, y up, to pixels of a pane, y down. `view` is shared by the panes that move together.
export class ViewTransform {
  constructor(view) {
    this.view = view;
    this.width = 1;
    this.height = 1;
    this.ratio = 1; ///< device pixels per CSS pixel
  }

  get scale() {
    return this.view.scale;
  }
  x(x_m) {
    return this.width / 2 + (x_m - this.view.x) * this.view.scale;
  }
  y(y_m) {
    return this.height / 2 - (y_m - this.view.y) * this.view.scale;
  }
  mapX(x_px) {
    return this.view.x + (x_px - this.width / 2) / this.view.scale;
  }
  mapY(y_px) {
    return this.view.y - (y_px - this.height / 2) / this.view.scale;
  }

  /// Drawing in pixels of the pane.
  usePixels(context) {
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }

  /// Drawing in metres: line widths and dashes have to be divided by scale.
  useMetres(context) {
    const k = this.ratio * this.view.scale;
    context.setTransform(k, 0, 0, -k, this.ratio * this.x(0), this.ratio * this.y(0));
  }
}

const kLeastScale = 0.05,
  kGreatestScale = 4000; ///< px per m

export const clampScale = (scale) => Math.min(kGreatestScale, Math.max(kLeastScale, scale));

/// The view that shows a box [x, y, x, y] in a pane; `auto`: it stays fitted when the pane changes its size.
export function fitView(box, width, height, margin_px = 24) {
  const w = Math.max(box[2] - box[0], 1e-3),
    h = Math.max(box[3] - box[1], 1e-3);
  const scale = Math.min(Math.max(width - 2 * margin_px, 40) / w, Math.max(height - 2 * margin_px, 40) / h);
  return { x: (box[0] + box[2]) / 2, y: (box[1] + box[3]) / 2, scale: clampScale(scale), fitted: true, auto: true };
}

/// Moved so that the point of the pane at (x_px, y_px) stays where it is.
export function zoomed(transform, factor, x_px, y_px) {
  const scale = clampScale(transform.scale * factor);
  const x = transform.mapX(x_px),
    y = transform.mapY(y_px);
  return {
    x: x - (x_px - transform.width / 2) / scale,
    y: y + (y_px - transform.height / 2) / scale,
    scale,
    fitted: true,
  };
}
