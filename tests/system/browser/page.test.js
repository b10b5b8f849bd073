/// The page of `opal view` in a real browser, over synthetic runs: what it shows is what the records say.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { writePage } from './page_file.js';
import { kUnits, syntheticRun } from './synthetic_run.js';

const run = syntheticRun({ frames: 120, hypotheses: 14, seed: 3 });
let browser, address;

before(async () => {
  browser = await launch();
  address = writePage('one', [run.lines, 'out']);
});
after(() => browser?.close());

async function withPage(options, body) {
  const { page, context, troubles } = await open(browser, options.address ?? address, options);
  try {
    await body(page);
    assert.deepEqual(troubles, []);
  } finally {
    await context.close();
  }
}

const near = (a, b, within, what) => assert.ok(Math.abs(a - b) <= within, `${what}: expected ${b}, found ${a}`);

test('loads every update and starts at the first', () =>
  withPage({}, async (page) => {
    assert.equal(await page.evaluate(() => window.opal.frames()), 120);
    assert.deepEqual(await page.evaluate(() => window.opal.errors), []);
    assert.equal((await page.evaluate(() => window.opal.state())).frame, 0);
    assert.match(await page.locator('.words .status').textContent(), /searching/);
  }));

for (const frame of [0, 47, 119])
  test(`what is drawn of update ${frame} is what the records say`, () =>
    withPage({}, async (page) => {
      const [state, drawn] = await page.evaluate(async (f) => {
        await window.opal.seek(f);
        return [window.opal.state(), window.opal.drawn()];
      }, frame);
      const expected = run.truth[frame];
      assert.equal(state.status, expected.status);
      assert.equal(state.best, expected.best);
      const marks = (kind) => drawn.filter((mark) => mark.kind === kind);
      assert.deepEqual(
        marks('hypothesis')
          .map(({ id }) => id)
          .sort(),
        expected.hypotheses.map(({ id }) => id).sort(),
      );
      for (const { id, pose, p } of expected.hypotheses) {
        const mark = marks('hypothesis').find((m) => m.id === id);
        near(mark.x, pose[0], 1e-6, `x of #${id}`);
        near(mark.y, pose[1], 1e-6, `y of #${id}`);
        near(mark.u, pose[2], 1e-5, `heading of #${id}`);
        near(mark.v, p, 1e-6, `probability of #${id}`);
      }
      assert.equal(marks('scan').length, expected.scanPoints);
      assert.deepEqual(
        marks('local_feature')
          .map(({ id }) => id)
          .sort(),
        expected.localFeatures.map(({ id }) => id).sort(),
      );
      for (const { id, stable } of expected.localFeatures)
        assert.equal(marks('local_feature').find((m) => m.id === id).other, stable ? 1 : 0);
      const best = expected.hypotheses.find(({ id }) => id === expected.best);
      const lines = marks('association')
        .map(({ id, other, third }) => [id, other, third])
        .sort();
      assert.deepEqual(
        lines,
        best.pairs
          .filter(([, mapped]) => mapped >= 0)
          .map(([local, mapped]) => [best.id, local, mapped])
          .sort(),
      );
      for (const mark of marks('association')) near(mark.x, best.pose[0], 1e-6, 'lines begin at the robot');
      assert.equal(marks('map_feature').length, run.map.features.length);
    }));

test('errors of rounding do not add up', () =>
  withPage({}, async (page) => {
    const last = run.truth.length - 1;
    const state = await page.evaluate((f) => window.opal.seek(f).then(() => window.opal.state()), last);
    for (const { id, nat } of run.truth[last].hypotheses)
      near(state.hypotheses.find((h) => h.id === id).nat, nat, kUnits.unit_nat, `nat of #${id}`);
  }));

test('the local map holds scan, candidates, stable and matched features', () =>
  withPage({}, async (page) => {
    const drawn = await page.evaluate(() => window.opal.seek(47).then(() => window.opal.drawn(0, 'local')));
    const features = drawn.filter(({ kind }) => kind === 'local_feature');
    assert.equal(features.length, run.truth[47].localFeatures.length);
    const best = run.truth[47].hypotheses.find(({ id }) => id === run.truth[47].best);
    const known = new Set(run.truth[47].localFeatures.map(({ id }) => id));
    const expected = best.pairs
      .filter(([local, mapped]) => mapped >= 0 && known.has(local))
      .map(([local]) => local)
      .sort();
    assert.deepEqual(
      features
        .filter(({ third }) => third >= 0)
        .map(({ id }) => id)
        .sort(),
      expected,
    );
  }));

test('sliding, stepping and jumping go to moments', () =>
  withPage({}, async (page) => {
    const frame = () => page.evaluate(() => window.opal.settled().then(() => window.opal.state().frame));
    await page.locator('.slider').focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await frame(), 1);
    await page.keyboard.press('End');
    assert.equal(await frame(), 119);
    const box = await page.locator('.slider').boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    near(await frame(), 60, 2, 'the middle of the slider');
    await page.getByRole('button', { name: 'Step back' }).click();
    await page.evaluate(() => window.opal.seek(0));
    await page.getByLabel('Events to jump to').selectOption({ label: 'status change' });
    await page.getByRole('button', { name: 'Next event' }).click();
    assert.equal(await frame(), 4);
    assert.match(await page.locator('.words .status').textContent(), /ambiguous/);
    await page.getByRole('button', { name: 'Previous event' }).click();
    assert.equal(await frame(), 0);
  }));

test('a click on the plots goes to that moment', () =>
  withPage({}, async (page) => {
    const box = await page.locator('.plot-cpu .plot-area').boundingBox();
    await page.mouse.click(box.x + 118 + (box.width - 118 - 12) / 4, box.y + 20);
    const { frame } = await page.evaluate(() => window.opal.settled().then(() => window.opal.state()));
    near(frame, 119 / 4, 1, 'a quarter of the time');
  }));

test('playing moves on and stops at the end', () =>
  withPage({}, async (page) => {
    await page.getByLabel('Speed', { exact: true }).selectOption({ label: '32×' });
    await page.getByRole('button', { name: 'Play', exact: true }).click();
    await page.waitForFunction(() => !window.opal.choices().playing && window.opal.state().frame === 119);
  }));

test('a click on a hypothesis shows its pose, scores and associations', () =>
  withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(47));
    const place = await page.evaluate(() => {
      const { best } = window.opal.state(),
        mark = window.opal.drawn().find(({ kind, id }) => kind === 'hypothesis' && id === best);
      const view = window.opal.view(),
        box = document.querySelector('.pane-global').getBoundingClientRect();
      return [
        box.left + box.width / 2 + (mark.x - view.x) * view.scale,
        box.top + box.height / 2 - (mark.y - view.y) * view.scale,
      ];
    });
    await page.mouse.click(...place);
    await page.evaluate(() => window.opal.settled());
    const details = await page.locator('.details').innerText();
    assert.match(details, /Hypothesis #0/);
    assert.match(details, /Likelihood[\s\S]*nat[\s\S]*1\.250/);
    const best = run.truth[47].hypotheses.find(({ id }) => id === 0);
    assert.match(details, new RegExp(`Associations \\(${best.pairs.length}\\)`));
    for (const [local, mapped] of best.pairs)
      assert.ok(details.includes(`${local} → ${mapped < 0 ? 'not on the map' : run.map.features[mapped].id}`), `${local}`);
  }));

test('the tree tells why a hypothesis ended, and details lead to the moment', () =>
  withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(119));
    await page.getByRole('tab', { name: 'Tree' }).click();
    const tree = page.getByRole('tree');
    await page.getByLabel('all ended').check();
    await page.getByLabel('Search the tree').fill('passes 1.8 m through wall-5');
    const row = tree.getByRole('treeitem').filter({ hasText: 'passes 1.8 m' }).first();
    assert.match(await row.innerText(), /beam 221 passes 1\.8 m through wall-5/);
    await row.click();
    await page.evaluate(() => window.opal.settled());
    assert.match(await page.locator('.details .reason').innerText(), /beam 221 passes 1\.8 m through wall-5/);
    await page.locator('.details .facts .link').last().click();
    const { frame } = await page.evaluate(() => window.opal.settled().then(() => window.opal.state()));
    const { selected } = await page.evaluate(() => window.opal.choices());
    assert.ok(!run.truth[frame].hypotheses.some(({ id }) => id === selected));
    assert.ok(run.truth[frame - 1].hypotheses.some(({ id }) => id === selected));
    const marks = await page.evaluate(() => window.opal.drawn());
    assert.ok(
      marks.some(({ kind, id }) => kind === 'finding' && id === selected),
      'its finding is drawn',
    );
  }));

test('rejected branches and places are in the tree with their reasons', () =>
  withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(48));
    await page.getByRole('tab', { name: 'Tree' }).click();
    await page.getByLabel('Search the tree').fill('wall-4 would lie');
    assert.match(await page.getByRole('tree').innerText(), /rejected .*wall-4 would lie 0\.8 m behind/);
    await page.getByLabel('Search the tree').fill('stand in free space');
    assert.match(await page.getByRole('tree').innerText(), /rejected: a column would stand in free space/);
  }));

test('the words of the moment are shown', () =>
  withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(46));
    const words = await page.locator('.words-body').innerText();
    assert.match(words, /localized with probability 0\.98|localized with probability/);
    assert.match(words, /column-1 is 0\.04 m/);
  }));

test('names are told on hover, and to the keyboard', () =>
  withPage({}, async (page) => {
    const [x, y] = await page.evaluate(() => {
      const mark = window.opal.drawn().find(({ kind, id }) => kind === 'map_feature' && id === 12),
        view = window.opal.view();
      const box = document.querySelector('.pane-global').getBoundingClientRect();
      return [
        box.left + box.width / 2 + (mark.x + 0.3 - view.x) * view.scale,
        box.top + box.height / 2 - (mark.y - view.y) * view.scale,
      ];
    });
    await page.mouse.move(x, y);
    assert.match(await page.locator('.pane-global .tip').innerText(), /column-1 · Column/);
    await page.mouse.move(5, 5);
    await page.keyboard.press('3');
    await page.keyboard.press('ArrowDown');
    await page.keyboard.press('Enter');
    assert.match(await page.locator('.pane-global .tip').innerText(), /wall-1 · Wall/);
  }));

test('a deep link leads back to moment, selection, layers and view', async () => {
  let link = '';
  await withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(47));
    await page.keyboard.press('b');
    await page.keyboard.press('l');
    await page.getByLabel('Scan', { exact: true }).uncheck();
    await page.keyboard.press('Escape');
    await page.locator('.pane-global .pane-top').hover();
    await page.mouse.wheel(0, -400);
    await page.waitForTimeout(400);
    link = await page.evaluate(() => location.hash);
    assert.match(link, /t=9\.4&sel=0&layers=.*&view=/);
  });
  await withPage({ address: address + link }, async (page) => {
    const [choices, state] = await page.evaluate(() => [window.opal.choices(), window.opal.state()]);
    assert.equal(state.frame, 47);
    assert.equal(choices.selected, 0);
    assert.ok(!choices.layers.includes('scan'));
    await page.waitForTimeout(350);
    assert.equal(await page.evaluate(() => location.hash), link);
    await page.evaluate(() => (location.hash = '#t=2&sel=1'));
    await page.waitForFunction(() => window.opal.state().frame === 10 && window.opal.choices().selected === 1);
  });
});

test('an address that comes just before the page writes its own is visited', () =>
  withPage({}, async (page) => {
    await page.waitForFunction(() => location.hash !== '');
    await page.evaluate(() => {
      setTimeout(() => (location.hash = '#t=2&sel=1'), 200);
      window.opal.seek(47);
      const bothDue = performance.now() + 300;
      while (performance.now() < bothDue);
    });
    await page.waitForFunction(() => window.opal.state().frame === 10 && window.opal.choices().selected === 1);
  }));

test('windows are time lines of their own', async () => {
  const three = syntheticRun({ frames: 60, hypotheses: 6, windows: 3 });
  await withPage({ address: writePage('windows', [three.lines, 'out']) }, async (page) => {
    await page.getByLabel('Window of the recording').selectOption({ label: 'window-1' });
    const state = await page.evaluate(() => window.opal.settled().then(() => window.opal.state()));
    assert.equal(state.frame, 20);
    assert.deepEqual(
      state.hypotheses.map(({ id }) => id),
      three.truth[20].hypotheses.map(({ id }) => id),
    );
    await page.evaluate(() => window.opal.seek(45));
    assert.equal((await page.evaluate(() => window.opal.choices())).window, 2);
  });
});

test('what was left out of the file is told', () =>
  withPage({}, async (page) => {
    await page.getByText('About').click();
    assert.match(await page.locator('.notes .menu-body').innerText(), /Scans are thinned to every second point/);
  }));

test('time can be stretched, and what is on show follows the moment', () =>
  withPage({}, async (page) => {
    await page.evaluate(() => window.opal.seek(60));
    for (let k = 0; k < 3; ++k) await page.keyboard.press('z');
    const range = () =>
      page.evaluate(() =>
        window.opal.settled().then(() => ['min', 'max'].map((name) => Number(document.querySelector('.slider')[name]))),
      );
    const [from, to] = await range();
    near(to - from, 23.8 / 8, 0.1, 'an eighth of the time');
    assert.ok(from < 12 && 12 < to);
    await page.keyboard.press('End');
    assert.equal((await page.evaluate(() => window.opal.settled().then(() => window.opal.state()))).frame, 119);
    near((await range())[1], 23.8, 0.01, 'the end is on show');
    await page.getByRole('button', { name: 'All' }).click();
    assert.deepEqual(await range(), [0, 23.8]);
  }));
