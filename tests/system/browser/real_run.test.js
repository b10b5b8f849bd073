/// A recorded run from log to page: what the page draws is what the run's events say. Needs the built program: OPAL_PROGRAM.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { launch, open } from './browser.js';
import { kFolder } from './page_file.js';

const kRoot = join(dirname(fileURLToPath(import.meta.url)), '../../..');
const kProgram = process.env.OPAL_PROGRAM ?? '';
const skip = existsSync(kProgram) ? false : 'OPAL_PROGRAM does not name the built program';
const kPlace_m = 0.003,
  kAngle_rad = 0.002,
  kProbability = 0.001; ///< a step of the records, and rounding of the events
let browser, page, troubles, updates;

before(async () => {
  if (skip) return;
  const data = join(kRoot, 'maps/malaga'),
    map = join(kFolder, 'malaga.jsonld'),
    out = join(kFolder, 'out'),
    html = join(kFolder, 'malaga.html');
  const opal = (...words) => execFileSync(kProgram, words, { cwd: kRoot, stdio: 'pipe' });
  opal('map', 'import', join(data, 'malaga.map.yaml'), '-o', map);
  opal(
    'localize',
    'configs/malaga.jsonld',
    join(data, 'malaga.log.gz'),
    '--map',
    map,
    '--truth',
    join(data, 'malaga.gt.csv'),
    '-o',
    out,
  );
  opal('view', out, '-o', html);
  assert.ok(statSync(html).size < 15e6);
  updates = updatesOf(readFileSync(join(out, 'events.jsonl'), 'utf8').trim().split('\n').map(JSON.parse));
  browser = await launch();
  ({ page, troubles } = await open(browser, `file://${html}`));
});
after(() => browser?.close());

/// Per update: its estimate, its local features, and the associations of every hypothesis alive.
function updatesOf(events) {
  const updates = [],
    pairs = new Map(),
    local = new Map();
  const add = ({ hypothesis, pairs: added }) => {
    if (!pairs.has(hypothesis)) pairs.set(hypothesis, new Map());
    for (const [feature, mapped] of added) pairs.get(hypothesis).set(feature, mapped);
  };
  const on = {
    spawned: add,
    associated: add,
    dissociated: ({ hypothesis, local_features: ended }) => ended.forEach((feature) => pairs.get(hypothesis)?.delete(feature)),
    local_features: ({ changed = [], gone = [] }) => {
      changed.forEach((feature) => local.set(feature.id, feature.stable));
      gone.forEach((id) => local.delete(id));
    },
    estimate: (estimate) =>
      updates.push({
        ...estimate,
        local: new Map(local),
        pairs: new Map(estimate.hypotheses.map(({ hypothesis: id }) => [id, [...(pairs.get(id) ?? [])]])),
      }),
    pruned: (event) => (updates.ended ??= []).push({ ...event, update: updates.length }),
  };
  for (const event of events) on[event.event]?.(event);
  return updates;
}

const near = (a, b, within, what) => assert.ok(Math.abs(a - b) <= within, `${what}: expected ${b}, found ${a}`);
const turn = (angle) => Math.atan2(Math.sin(angle), Math.cos(angle));

test('the page has every update and no errors', { skip }, async () => {
  assert.equal(await page.evaluate(() => window.opal.frames()), updates.length);
  assert.deepEqual(await page.evaluate(() => window.opal.errors), []);
  assert.deepEqual(troubles, []);
});

for (const part of [0.04, 0.4, 1])
  test(`at ${part} of the run, hypotheses, associations and local features are those of the events`, { skip }, async () => {
    const number = Math.round(part * (updates.length - 1)),
      update = updates[number];
    const [drawn, state] = await page.evaluate(
      (f) => window.opal.seek(f).then(() => [window.opal.drawn(), window.opal.state()]),
      number,
    );
    const marks = (kind) => drawn.filter((mark) => mark.kind === kind);
    assert.equal(state.status, update.status);
    assert.equal(state.best, update.hypothesis ?? -1);
    near(state.stamp, update.stamp_s, 1e-3, 'stamp');
    assert.deepEqual(
      marks('hypothesis')
        .map(({ id }) => id)
        .sort(),
      update.hypotheses.map(({ hypothesis: id }) => id).sort(),
    );
    for (const {
      hypothesis: id,
      T_map_base: [x, y, heading],
      probability,
    } of update.hypotheses) {
      const mark = marks('hypothesis').find((m) => m.id === id);
      near(mark.x, x, kPlace_m, `x of #${id}`);
      near(mark.y, y, kPlace_m, `y of #${id}`);
      near(turn(mark.u - heading), 0, kAngle_rad, `heading of #${id}`);
      near(mark.v, probability, kProbability, `probability of #${id}`);
      const said = state.hypotheses.find((h) => h.id === id).associations;
      assert.deepEqual(new Map(said), new Map(update.pairs.get(id)), `associations of #${id}`);
    }
    const onMap = update.pairs.get(update.hypothesis).filter(([, mapped]) => mapped !== null);
    assert.equal(marks('association').length, onMap.length);
    assert.deepEqual(
      marks('local_feature')
        .map(({ id, other }) => [id, other === 1])
        .sort((a, b) => a[0] - b[0]),
      [...update.local].sort((a, b) => a[0] - b[0]),
    );
  });

test('an ended hypothesis tells the recorded reason', { skip }, async () => {
  const ended = updates.ended.find(({ findings }) => findings?.length > 0) ?? updates.ended[0];
  await page.evaluate((f) => window.opal.seek(f), ended.update);
  await page.evaluate((id) => (location.hash = `#t=${window.opal.choices().time}&sel=${id}`), ended.hypothesis);
  await page.waitForFunction((id) => window.opal.choices().selected === id, ended.hypothesis);
  await page.evaluate(() => window.opal.settled());
  const details = await page.locator('.details').innerText();
  assert.ok(details.includes(ended.reason), details);
  for (const { words } of ended.findings ?? []) assert.ok(details.includes(words), words);
});

test('the words of the moment are those of opal explain', { skip }, async () => {
  await page.evaluate((f) => window.opal.seek(f), updates.length - 1);
  const words = await page.locator('.words-body').innerText();
  assert.match(words, new RegExp(`${updates.at(-1).status}`));
});
