/// What keeps people from reading a page, or from reaching all of it by keyboard.
import assert from 'node:assert/strict';

/// Contrast of every visible text with what is behind it (WCAG 2.1, 1.4.3), and of the inks that words are drawn with.
export const worstContrast = (inks) => {
  const luminance = ([r, g, b]) => {
    const f = (v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4);
    return 0.2126 * f(r) + 0.7152 * f(g) + 0.0722 * f(b);
  };
  const canvas = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const parse = (color) => {
    canvas.clearRect(0, 0, 1, 1);
    canvas.fillStyle = color;
    canvas.fillRect(0, 0, 1, 1);
    return [...canvas.getImageData(0, 0, 1, 1).data];
  };
  const contrast = (a, b) => {
    const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
    return (high + 0.05) / (low + 0.05);
  };
  const behind = (node) => {
    for (let at = node; at; at = at.parentElement) {
      const color = parse(getComputedStyle(at).backgroundColor);
      if (color[3] > 250) return color;
    }
    return [255, 255, 255, 255];
  };
  const found = [];
  for (const node of document.querySelectorAll('body *')) {
    const own = [...node.childNodes].some((child) => child.nodeType === 3 && child.textContent.trim() !== '');
    if (!own || !node.checkVisibility() || node.closest('script, noscript')) continue;
    const ratio = contrast(parse(getComputedStyle(node).color), behind(node));
    if (ratio < 4.5) found.push(`${ratio.toFixed(2)} ${node.tagName}.${node.className}: ${node.textContent.slice(0, 30)}`);
  }
  const style = getComputedStyle(document.documentElement),
    plot = parse(style.getPropertyValue('--plot'));
  for (const ink of inks) {
    const ratio = contrast(parse(style.getPropertyValue(`--${ink}`)), plot);
    if (ratio < 4.5) found.push(`${ratio.toFixed(2)} drawn with --${ink}`);
  }
  return found;
};

/// Tab all the way round; the focus has to show. Returns what it does not come by.
export async function passedByTab(page) {
  const wanted = await page.evaluate(() => {
    const all = [...document.querySelectorAll('button, select, input, summary, [tabindex="0"]')].filter(
      (node) => node.checkVisibility() && node.tabIndex >= 0 && !node.disabled,
    );
    all.forEach((node, k) => (node.dataset.stop = String(k)));
    return all.map((node) => node.outerHTML.slice(0, 90));
  });
  const seen = new Set();
  for (let k = 0; k < wanted.length + 5; ++k) {
    await page.keyboard.press('Tab');
    const [stop, outline] = await page.evaluate(() => {
      const style = getComputedStyle(document.activeElement);
      return [document.activeElement.dataset.stop, `${style.outlineStyle} ${style.outlineWidth}`];
    });
    if (stop === undefined) continue;
    seen.add(Number(stop));
    assert.match(outline, /^(solid|auto) [1-9]/, `focus shows on ${wanted[stop]}`);
  }
  return wanted.filter((_, k) => !seen.has(k));
}
