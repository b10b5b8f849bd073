/// A report with every kind of plot, made by the kit itself (report_tests), with hostile names: drawn, and text without a script.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.js';
import { kFolder } from './page_file.js';

const program = process.env.OPAL_REPORT_TESTS,
  skip = program ? false : 'OPAL_REPORT_TESTS is not set';
const path = join(kFolder, 'report.html');
let browser;
before(async () => {
  if (program) execFileSync(program, ['[look]'], { env: { ...process.env, OPAL_REPORT_PAGE: path } });
  browser = await launch();
});
after(() => browser?.close());

async function opened(settings = {}) {
  const context = await browser.newContext({ viewport: { width: 1200, height: 800 }, ...settings });
  const page = await context.newPage();
  const troubles = [];
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('console', (message) => message.type() === 'error' && troubles.push(message.text()));
  page.on('dialog', (dialog) => (troubles.push(dialog.message()), dialog.dismiss()));
  page.on('request', (request) => request.url().startsWith('file:') || troubles.push(`fetched ${request.url()}`));
  await page.goto(`file://${path}`);
  return { page, context, troubles };
}

test('every plot is drawn with axes, and nothing in names executes or is fetched', { skip }, async () => {
  const { page, context, troubles } = await opened();
  const plots = page.locator('.plot');
  assert.equal(await plots.count(), 4);
  for (let k = 0; k < 4; ++k) assert.ok((await plots.nth(k).locator('svg .axis .tick').count()) > 2, `plot ${k}`);
  assert.equal(await page.locator('.dot').count(), 2 + 1 + 1, 'one with two halves, one beyond, one with its interval, none without a place');
  assert.equal(await page.locator('a .dot').count(), 2);
  assert.equal(await page.locator('td.interval .mark').count(), 3);
  assert.equal(await page.locator('path.line').count(), 2);
  assert.equal(await page.locator('rect.span').count(), 2);
  assert.equal(await page.locator('rect.bar').count(), 2);
  assert.equal(await page.locator('img').count(), 0);
  const wrong = await page.evaluate(() => [...document.querySelectorAll('svg *')].flatMap((e) => [...e.attributes]).filter((a) => /NaN|undefined/.test(a.value)).length);
  assert.equal(wrong, 0, 'every place is a number');
  assert.deepEqual(troubles, []);
  await context.close();
});

test('plots take the colours of light and dark, and the width that there is', { skip }, async () => {
  const seen = [];
  for (const colorScheme of ['light', 'dark']) {
    const { page, context } = await opened({ colorScheme });
    const fill = () => page.locator('.bar').first().evaluate((bar) => getComputedStyle(bar).fill);
    const width = () => page.locator('.plot svg').first().evaluate((svg) => svg.clientWidth);
    const wide = await width();
    seen.push(await fill());
    await page.setViewportSize({ width: 400, height: 800 });
    await page.waitForFunction((before) => document.querySelector('.plot svg').clientWidth < before, wide);
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 400, 'the page does not scroll sideways');
    await context.close();
  }
  assert.notEqual(seen[0], seen[1]);
});

test('without a script, tables and sentences are there', { skip }, async () => {
  const { page, context } = await opened({ javaScriptEnabled: false });
  const text = await page.locator('body').innerText();
  for (const part of ['<img src=x onerror=alert(1)>', 'difference [points]', 'two']) assert.ok(text.includes(part), part);
  assert.equal(await page.locator('tbody tr').count(), 3);
  assert.ok(!text.includes('"kind"'), 'data of plots is not shown');
  await context.close();
});
