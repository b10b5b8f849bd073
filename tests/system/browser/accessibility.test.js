/// Keyboard alone reaches everything, and everything can be read, in light and in dark.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { writePage } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const run = syntheticRun({ frames: 60, hypotheses: 10 });
let browser, address;
before(async () => {
  browser = await launch();
  address = writePage('access', [run.lines, 'out']);
});
after(() => browser?.close());

test('Tab comes by every control, with a visible focus, and never gets stuck', async () => {
  const { page, context } = await open(browser, address);
  await page.keyboard.press('b');
  await page.evaluate(() => window.opal.settled());
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
  assert.deepEqual(
    wanted.filter((_, k) => !seen.has(k)),
    [],
  );
  await context.close();
});

test('keys do what the help says', async () => {
  const { page, context, troubles } = await open(browser, address);
  const state = () =>
    page.evaluate(() =>
      window.opal.settled().then(() => ({ ...window.opal.choices(), ...window.opal.view(), frame: window.opal.state().frame })),
    );
  await page.keyboard.press('ArrowRight');
  assert.equal((await state()).frame, 1);
  await page.keyboard.press('n');
  assert.equal((await state()).frame, 4);
  await page.keyboard.press('p');
  assert.equal((await state()).frame, 0);
  await page.keyboard.press('End');
  assert.equal((await state()).frame, 59);
  await page.keyboard.press(']');
  assert.equal((await state()).selected, run.truth[59].best);
  await page.keyboard.press('Escape');
  assert.equal((await state()).selected, -1);
  const before = await state();
  await page.keyboard.press('+');
  assert.ok((await state()).scale > before.scale);
  await page.keyboard.press('m');
  await page.keyboard.press('ArrowRight');
  assert.ok((await state()).x > before.x);
  assert.equal((await state()).frame, 59, 'arrows on the map do not step');
  await page.keyboard.press('0');
  assert.equal((await state()).scale, before.scale);
  await page.keyboard.press('f');
  assert.equal(await page.getByRole('button', { name: 'Follow' }).getAttribute('aria-pressed'), 'true');
  await page.keyboard.press('Home');
  await page.keyboard.press(' ');
  assert.equal((await state()).playing, true);
  await page.keyboard.press(' ');
  assert.equal((await state()).playing, false);
  await page.keyboard.press('?');
  assert.ok(await page.getByRole('dialog').isVisible());
  assert.match(await page.getByRole('dialog').innerText(), /play or pause/);
  await page.keyboard.press('Escape');
  assert.equal(await page.getByRole('dialog').count(), 0);
  assert.deepEqual(troubles, []);
  await context.close();
});

test('the tree opens, closes and selects by arrow keys', async () => {
  const { page, context } = await open(browser, address);
  await page.evaluate(() => window.opal.seek(59));
  await page.keyboard.press('2');
  const active = () =>
    page.evaluate(() => {
      const list = document.activeElement;
      return document.getElementById(list.getAttribute('aria-activedescendant'))?.getAttribute('aria-expanded');
    });
  await page.keyboard.press('Home');
  assert.equal(await active(), 'false');
  await page.keyboard.press('ArrowRight');
  assert.equal(await active(), 'true');
  const rows = await page.getByRole('treeitem').count();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await active(), 'true', 'left goes to the parent');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await active(), 'false');
  assert.ok((await page.getByRole('treeitem').count()) < rows);
  await page.keyboard.press('Enter');
  assert.ok((await page.evaluate(() => window.opal.choices())).selected >= 0);
  await context.close();
});

/// Contrast of every visible text with what is behind it (WCAG 2.1, 1.4.3), and of the inks that words are drawn with.
const worstContrast = () => {
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
  const drawn = [
    'text',
    'faint',
    'finding',
    'pattern',
    'run-a',
    'run-b',
    'status-searching',
    'status-ambiguous',
    'status-localized',
    'status-lost',
  ];
  for (const ink of drawn) {
    const ratio = contrast(parse(style.getPropertyValue(`--${ink}`)), plot);
    if (ratio < 4.5) found.push(`${ratio.toFixed(2)} drawn with --${ink}`);
  }
  return found;
};

for (const colorScheme of ['light', 'dark'])
  test(`contrast is 4.5 at least: ${colorScheme}`, async () => {
    const { page, context } = await open(browser, address, { colorScheme });
    assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), colorScheme);
    await page.evaluate(() => window.opal.seek(30));
    await page.keyboard.press('b');
    for (const key of ['1', '2', '3']) {
      await page.keyboard.press(key);
      await page.keyboard.press('ArrowDown');
      await page.evaluate(() => window.opal.settled());
      assert.deepEqual(await page.evaluate(worstContrast), []);
    }
    await page.keyboard.press('l');
    assert.deepEqual(await page.evaluate(worstContrast), []);
    await page.keyboard.press('Escape');
    await page.keyboard.press('?');
    assert.deepEqual(await page.evaluate(worstContrast), []);
    await context.close();
  });

test('the switch goes from the system to light to dark', async () => {
  const { page, context } = await open(browser, address, { colorScheme: 'dark' });
  await page.getByRole('button', { name: 'Theme' }).click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'light');
  await page.getByRole('button', { name: 'Theme' }).click();
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await context.close();
});

for (const [name, width, height] of [
  ['laptop', 1366, 768],
  ['tablet', 820, 1180],
  ['tablet on its side', 1180, 820],
  ['phone', 390, 844],
])
  test(`nothing runs out of a ${name}`, async () => {
    const { page, context } = await open(browser, address, { viewport: { width, height }, hasTouch: width < 1200 });
    await page.keyboard.press('b');
    await page.evaluate(() => window.opal.settled());
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth - innerWidth)) <= 0);
    for (const part of ['.pane-global', '.pane-local', '.words-body', '.tabs', '.details', '.slider', '.transport'])
      assert.ok(await page.locator(part).first().isVisible(), part);
    const box = await page.locator('.pane-global').boundingBox();
    assert.ok(box.width >= 300 && box.height >= 250, JSON.stringify(box));
    await context.close();
  });
