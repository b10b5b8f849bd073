/// Two runs of one log side by side on one time line.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { writePage } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const a = syntheticRun({ frames: 60, hypotheses: 8, seed: 1, config: 'a.jsonld' }),
  b = syntheticRun({ frames: 60, hypotheses: 5, seed: 2, config: 'b.jsonld', stampShift: 2 });
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

test('by stamp where the runs overlap, with panes that move together', async () => {
  const { page, context, troubles } = await open(browser, writePage('two', [a.lines, 'first'], [b.lines, 'second']));
  const states = () => page.evaluate(() => window.opal.settled().then(() => [window.opal.state(0), window.opal.state(1)]));
  let [first, second] = await states();
  assert.equal(first.frame, 0);
  assert.equal(second, null, 'the second begins two seconds later');
  await page.evaluate(() => window.opal.seek(40));
  [first, second] = await states();
  assert.equal(first.frame, 40);
  assert.equal(second.frame, 30);
  assert.ok(Math.abs(first.stamp - second.stamp) < 1e-6);
  for (const [run, truth] of [
    [0, a.truth[40]],
    [1, b.truth[30]],
  ]) {
    const drawn = await page.evaluate((r) => window.opal.drawn(r), run);
    assert.deepEqual(
      drawn
        .filter(({ kind }) => kind === 'hypothesis')
        .map(({ id }) => id)
        .sort(),
      truth.hypotheses.map(({ id }) => id).sort(),
    );
  }
  assert.equal(await page.locator('.words').count(), 2);
  assert.match(await page.locator('.run-name').innerText(), /A: .*a\.jsonld.*B: .*b\.jsonld/);
  const readOut = await page.locator('.plot-hypotheses .plot-value').innerText();
  assert.match(readOut, /^\d+ \| \d+$/);
  await page.locator('.pane-global .pane-top').nth(1).hover();
  await page.mouse.wheel(0, -300);
  await page.keyboard.press('r');
  await page.keyboard.press('b');
  await page.evaluate(() => window.opal.settled());
  assert.equal((await page.evaluate(() => window.opal.choices())).run, 1);
  await page.waitForTimeout(350);
  assert.match(await page.evaluate(() => location.hash), /run=1&sel=\d+.*view=/);
  assert.deepEqual(troubles, []);
  await context.close();
});
