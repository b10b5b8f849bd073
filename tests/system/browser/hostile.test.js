/// Damaged and hostile data: told as an error or drawn as text; nothing executes.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { packed, writePage } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const run = syntheticRun({ frames: 30, hypotheses: 6 });
const kScript = '<img src=x onerror=alert(1)><script>alert(2)</script>';
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

async function shown(name, ...runs) {
  const { page, context, troubles } = await open(browser, writePage(name, ...runs));
  const frames = await page.evaluate(() => window.opal.frames()),
    errors = await page.evaluate(() => window.opal.errors);
  const alert = await page.locator('.alerts').innerText();
  return { page, context, troubles, frames, errors, alert };
}

test('markup in names, reasons, words and everywhere is text', async () => {
  const hostile = syntheticRun({ frames: 30, hypotheses: 6, names: (k) => `${k} ${kScript}`, log: kScript, config: kScript });
  const lines = hostile.lines.map((line) =>
    line
      .replace(/beam 221 passes|a column would stand|column column-1 is|the local feature was/g, kScript.replace(/"/g, '\\"'))
      .replaceAll('opal:Likelihood', kScript),
  );
  const { page, context, troubles, frames, errors } = await shown('hostile', [lines, kScript]);
  assert.deepEqual(errors, []);
  assert.equal(frames, 30);
  for (const frame of [0, 8, 21, 29]) {
    await page.evaluate((f) => window.opal.seek(f), frame);
    for (const key of ['b', ']', '.', '1', '2', '3']) await page.keyboard.press(key);
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    await page.mouse.move(300 + 5 * frame, 300);
  }
  await page.getByText('About').click();
  await page.getByRole('tab', { name: 'Tree' }).click();
  await page.getByLabel('all ended').check();
  await page.locator('.plot-cpu').hover();
  await page.evaluate(() => window.opal.settled());
  assert.equal(await page.locator('img').count(), 0);
  assert.equal(await page.locator('script').count(), 2, 'data and page, nothing else');
  assert.ok((await page.locator('#opal').innerText()).includes('<img src=x onerror=alert(1)>'), 'it is shown as text');
  assert.deepEqual(troubles, []);
  await context.close();
});

const refused = [
  [
    'a coordinate beyond all buildings',
    (f) => (f.local = [1e308, 0, 0]),
    /record 13 \(frame\): local: expected a coordinate within 1000 km, found 1e\+308/,
  ],
  ['null for a pose', (f) => (f.local = null), /local: expected \[x, y, heading\], found null/],
  ['rows for another number of hypotheses', (f) => f.rows[0].push(1), /rows: expected 6 in each list, found 7/],
  ['no rows for those that are carried on', (f) => delete f.rows, /rows: expected 4 lists for 6 rows, found nothing/],
  [
    'a status that does not exist',
    (f) => (f.status = 'fine'),
    /status: expected searching, ambiguous, localized, lost, found "fine"/,
  ],
  ['fractions for steps', (f) => (f.scan[3] = 0.5), /scan: expected integers/],
  ['a probability of nobody', (f) => f.p.push([99999, 0.1]), /p: expected the id of a hypothesis that is alive, found 99999/],
  [
    'a feature of no kind',
    (f) => (f.features = [[1, 'x', 1, 1, 'toString', 1, 2]]),
    /expected point, oriented_point, segment or circle/,
  ],
  ['a mapped feature that is not on the map', (f) => (f.grown = [[0, [[100, 999]]]]), /expected a position below/],
];
for (const [name, damage, words] of refused)
  test(`${name}: an error names record and place; what is before is shown`, async () => {
    const lines = [...run.lines],
      frame = JSON.parse(lines[12]);
    damage(frame);
    lines[12] = JSON.stringify(frame);
    const { page, context, troubles, frames, alert } = await shown('refused', [lines, 'out']);
    assert.match(alert, words);
    assert.equal(frames, 10);
    await page.evaluate(() => window.opal.seek(9));
    const drawn = await page.evaluate(() => window.opal.drawn());
    assert.equal(drawn.filter(({ kind }) => kind === 'hypothesis').length, run.truth[9].hypotheses.length);
    assert.deepEqual(troubles, []);
    await context.close();
  });

test('a file that is cut short shows what it still has', async () => {
  const whole = packed(run.lines);
  const { context, troubles, frames, alert } = await shown('cut', [whole.subarray(0, Math.floor(whole.length * 0.7)), 'out']);
  assert.ok(frames > 3 && frames < 30, `${frames}`);
  assert.match(alert, /expected gzip, found damage after record \d+/);
  assert.deepEqual(troubles, []);
  await context.close();
});

test('what is no data at all is told', async () => {
  for (const [data, words] of [
    [Buffer.from('no gzip'), /expected gzip/],
    [packed(['{"r": "frame"}']), /expected run and map records before it/],
    [packed(['<html>']), /record 1: expected a JSON object/],
    [packed([]), /expected updates, found none/],
  ]) {
    const { context, troubles, alert } = await shown('none', [data, 'out']);
    assert.match(alert, words);
    assert.deepEqual(troubles, []);
    await context.close();
  }
});

test('long texts and empty lists are shown or left out', async () => {
  const lines = [...run.lines],
    frame = JSON.parse(lines[2]);
  frame.words = [
    ['answer', 'x'.repeat(100000)],
    ['__proto__', 'y'],
  ];
  Object.assign(frame, { scan: [], free: [], scores: [], findings: [], cpu: {} });
  lines[2] = JSON.stringify(frame);
  const { page, context, troubles, errors } = await shown('long', [lines, 'z'.repeat(5000)]);
  assert.deepEqual(errors, []);
  await page.keyboard.press('b');
  await page.evaluate(() => window.opal.settled());
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(overflow <= 0, `the page is ${overflow} px too wide`);
  assert.deepEqual(troubles, []);
  await context.close();
});
