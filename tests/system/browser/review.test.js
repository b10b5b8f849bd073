/// The page of `opal map review`: what a person says of proposals is what the overlay holds. Needs the built program: OPAL_PROGRAM.
import assert from 'node:assert/strict';
import { existsSync, renameSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.js';
import { changedBy, madeReview, opal, readJson, serveReview } from './made_review.js';
import { passedByTab, worstContrast } from './reading.js';

const skip = existsSync(process.env.OPAL_PROGRAM ?? '') ? false : 'OPAL_PROGRAM does not name the built program';
let browser;
before(async () => (browser = skip ? null : await launch()));
after(() => browser?.close());

async function opened(address, settings = {}) {
  const context = await browser.newContext({ viewport: { width: 1400, height: 900 }, ...settings });
  const page = await context.newPage();
  const troubles = [];
  page.on('pageerror', (error) => troubles.push(error.message));
  page.on('console', (message) => message.type() === 'error' && troubles.push(message.text()));
  page.on('dialog', (dialog) => (troubles.push(dialog.message()), dialog.dismiss()));
  await page.goto(address);
  await page.locator('.count').waitFor();
  return { page, context, troubles };
}

const choose = (page, id) =>
  page
    .locator('.proposals button')
    .filter({ has: page.getByText(id, { exact: false }) })
    .first()
    .click();
const said = (page, words) => page.waitForFunction((text) => document.querySelector('.state').textContent.includes(text), words);
const count = (page) => page.locator('.count').innerText();

test(
  'two accepted, one refused: after a reload and a restart they still are, and the overlay holds exactly the accepted ones',
  { skip },
  async () => {
    const folder = madeReview();
    let program = await serveReview(folder);
    let { page, context, troubles } = await opened(program.address);
    assert.equal(await count(page), '0 of 5 decided');
    await choose(page, 'South');
    await page.keyboard.press('a');
    await choose(page, 'column_1');
    await page.keyboard.press('r');
    await choose(page, 'learned-1');
    await page.getByLabel('Note').fill('a cupboard');
    await page.locator('.decide.accepted').click();
    await said(page, '3 of 5 decided, 2 accepted. Written: reviewed.decisions.json, reviewed.jsonld');
    await page.reload();
    assert.equal(await count(page), '3 of 5 decided');
    assert.equal(await page.locator('.proposals li.accepted').count(), 2);
    assert.equal(
      await page
        .locator('.proposals li.refused')
        .innerText()
        .then((text) => text.includes('column_1')),
      true,
    );
    assert.deepEqual(changedBy(folder, 'reviewed.jsonld'), ['learned-1', 'south_east', 'south_west']);
    assert.equal(
      readJson(folder, 'reviewed.decisions.json').decisions.find(({ about }) => about.id === 'learned-1').note,
      'a cupboard',
    );
    assert.deepEqual(troubles, []);
    await context.close();

    await program.kill(); // nothing is lost
    program = await serveReview(folder);
    ({ page, context, troubles } = await opened(program.address));
    assert.equal(await count(page), '3 of 5 decided');
    await page.keyboard.press('u');
    assert.match(await page.locator('.message').innerText(), /nothing to take back/);
    await context.close();
    assert.equal(await program.end(), 0);
    assert.match(opal(folder, 'map', 'overlay', 'room.jsonld', 'reviewed.jsonld', '-o', 'built.jsonld'), /learned-1/);
  },
);

test('keys move, decide, take back and filter; what is in conflict cannot be accepted', { skip }, async () => {
  const folder = madeReview(),
    program = await serveReview(folder);
  const { page, context, troubles } = await opened(program.address);
  const current = () => page.locator('.proposals [aria-current]').innerText();
  const first = await current();
  await page.keyboard.press('j');
  assert.notEqual(await current(), first);
  await page.keyboard.press('ArrowUp');
  assert.equal(await current(), first);
  await page.keyboard.press('a');
  assert.notEqual(await current(), first, 'on to the next one');
  await page.keyboard.press('u');
  assert.equal(await current(), first);
  assert.equal(await count(page), '0 of 5 decided');
  await page.locator('[data-filter=conflicts]').click();
  assert.match(await current(), /west_wall/);
  assert.equal(await page.locator('.decide.accepted').isDisabled(), true);
  await page.keyboard.press('a');
  assert.match(await page.locator('.message').innerText(), /cannot be accepted: visits place it differently/);
  assert.equal(await page.locator('.visits tbody tr').count(), 2);
  assert.equal(await page.locator('.own .sight').count(), 2);
  await page.keyboard.press('r');
  assert.equal(await count(page), '1 of 5 decided');
  await page.locator('[data-filter=all]').click();
  assert.match(await page.locator('.proposals li').last().innerText(), /^\D*\? east_wall/, 'less probable than asked for');
  assert.deepEqual(troubles, []);
  await context.close();
  await program.end();
  assert.deepEqual(changedBy(folder, 'reviewed.jsonld'), []);
});

test('pictures show the place to scale, and a mark on the whole map can be clicked', { skip }, async () => {
  const folder = madeReview(),
    program = await serveReview(folder);
  const { page, context } = await opened(program.address);
  const wrong = await page.evaluate(
    () =>
      [...document.querySelectorAll('svg *')]
        .flatMap((e) => [...e.attributes])
        .filter((a) => /NaN|undefined|Infinity/.test(a.value)).length,
  );
  assert.equal(wrong, 0, 'every place is a number');
  await choose(page, 'South');
  const scale = await page.evaluate(() => {
    const bar = document.querySelector('.stage .bar');
    const metres = document.querySelector('.stage .metres').getScreenCTM().a;
    return (bar.clientWidth / metres) * (bar.textContent.endsWith('cm') ? 100 : 1) - parseFloat(bar.textContent);
  });
  assert.ok(Math.abs(scale) < 0.1, `the bar is wrong by ${scale}`);
  const mark = await page.locator('.side .mark', { has: page.locator('title', { hasText: 'column_1' }) }).boundingBox();
  await page.mouse.click(mark.x + mark.width / 2, mark.y + mark.height / 2);
  assert.match(await page.locator('.words h2').innerText(), /column_1 is gone/);
  await context.close();
  await program.end();
});

test('markup in names and drives is text, in light and in dark', { skip }, async () => {
  const folder = madeReview();
  opal(folder, 'map', 'review', 'room.jsonld', 'evidence.json', '--html', 'review.html');
  const papers = [];
  for (const colorScheme of ['light', 'dark']) {
    const { page, context, troubles } = await opened(`file://${join(folder, 'review.html')}`, { colorScheme });
    await choose(page, 'South');
    assert.equal(await page.locator('img').count(), 0);
    assert.equal(await page.locator('script').count(), 2, 'data and page, nothing else');
    assert.ok((await page.locator('#review').innerText()).includes('South <img src=x onerror=alert(1)>'));
    assert.ok((await page.locator('.visits').innerText()).includes('<script>alert(2)</script>'));
    papers.push(await page.evaluate(() => getComputedStyle(document.body).backgroundColor));
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(overflow <= 0, `the page is ${overflow} px too wide`);
    assert.deepEqual(troubles, []);
    await context.close();
  }
  assert.notEqual(papers[0], papers[1]);
});

test(
  'a page that stands alone keeps decisions, and saves a file of which the program makes the same overlay',
  { skip },
  async () => {
    const folder = madeReview();
    opal(folder, 'map', 'review', 'room.jsonld', 'evidence.json', '--html', 'review.html');
    const { page, context, troubles } = await opened(`file://${join(folder, 'review.html')}`);
    await choose(page, 'South');
    await page.keyboard.press('a');
    await choose(page, 'column_1');
    await page.keyboard.press('a');
    await choose(page, 'learned-1');
    await page.keyboard.press('r');
    await page.reload();
    assert.equal(await count(page), '3 of 5 decided');
    const download = page.waitForEvent('download');
    await page.keyboard.press('s');
    const name = (await download).suggestedFilename();
    assert.equal(name, 'Example_room.decisions.json');
    await (await download).saveAs(join(folder, name));
    assert.deepEqual(troubles, []);
    await context.close();
    assert.match(
      opal(folder, 'map', 'review', 'room.jsonld', 'evidence.json', '--decisions', name, '-o', 'reviewed.jsonld'),
      /3 of 5 decided, 2 accepted/,
    );
    assert.deepEqual(changedBy(folder, 'reviewed.jsonld'), ['column_1', 'south_east', 'south_west']);
  },
);

test('when the program is gone, the page says so and loses nothing', { skip }, async () => {
  const folder = madeReview(),
    program = await serveReview(folder);
  const { page, context } = await opened(program.address);
  await program.kill();
  await choose(page, 'column_1');
  await page.keyboard.press('a');
  await said(page, 'Not saved: the program does not answer');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save as a file' }).click();
  await (await download).saveAs(join(folder, 'saved.json'));
  assert.equal(readJson(folder, 'saved.json').decisions.length, 1);
  renameSync(join(folder, 'saved.json'), join(folder, 'reviewed.decisions.json'));
  const again = await serveReview(folder);
  const next = await opened(again.address);
  assert.equal(await count(next.page), '1 of 5 decided');
  await next.context.close();
  await context.close();
  await again.end();
});

for (const colorScheme of ['light', 'dark'])
  test(`everything can be read, and reached by Tab: ${colorScheme}`, { skip }, async () => {
    const folder = madeReview();
    opal(folder, 'map', 'review', 'room.jsonld', 'evidence.json', '--html', 'review.html');
    const { page, context } = await opened(`file://${join(folder, 'review.html')}`, { colorScheme });
    for (const key of ['a', 'k', 'r', 'u', 'f', 'f', 'f', 'f']) await page.keyboard.press(key);
    assert.deepEqual(await page.evaluate(worstContrast, ['text', 'faint', 'moved', 'gone', 'added', 'doubt']), []);
    await page.locator('[data-filter=all]').click();
    assert.deepEqual(await page.evaluate(worstContrast, []), []);
    assert.deepEqual(await passedByTab(page), []);
    await page.setViewportSize({ width: 390, height: 844 });
    assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390, 'nothing runs out of a phone');
    await context.close();
  });
