/// Keyboard alone reaches everything, and everything can be read, in light and in dark.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { writePage } from './page_file.js';
import { passedByTab, worstContrast } from './reading.js';
import { syntheticRun } from './synthetic_run.js';

const run = syntheticRun({ frames: 60, hypotheses: 10 });
const kInks = [
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
  assert.deepEqual(await passedByTab(page), []);
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
      assert.deepEqual(await page.evaluate(worstContrast, kInks), []);
    }
    await page.keyboard.press('l');
    assert.deepEqual(await page.evaluate(worstContrast, kInks), []);
    await page.keyboard.press('Escape');
    await page.keyboard.press('?');
    assert.deepEqual(await page.evaluate(worstContrast, kInks), []);
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
