/// A page that follows a run while it happens, from a tiny server of events.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { createServer } from 'node:http';
import { after, before, test } from 'node:test';
import { launch, open } from './browser.js';
import { kMaker, recordsOfWindow } from './long_run.js';
import { pageWith } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const skip = existsSync(kMaker) ? false : 'OPAL_SYNTHETIC_RUN does not name the built program';
const run = syntheticRun({ frames: 200, hypotheses: 8 });
let browser, server, address;
let streams = [];

before(async () => {
  browser = await launch();
  server = createServer((request, response) => {
    if (request.url !== '/events') {
      response.writeHead(200, { 'content-type': 'text/html; charset=utf-8' });
      return response.end(pageWith('<meta name="opal-live" content="/events">'));
    }
    response.writeHead(200, { 'content-type': 'text/event-stream', 'cache-control': 'no-store' });
    response.write('retry: 100\n\n');
    streams.push(response);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}/`;
});
after(async () => {
  await browser?.close();
  server?.closeAllConnections();
  server?.close();
});

const send = (from, to) => {
  for (const line of run.lines.slice(from, to)) streams.at(-1).write(`data: ${line}\n\n`);
};

async function openLive() {
  streams = [];
  const context = await browser.newContext({ viewport: { width: 1366, height: 768 } });
  const page = await context.newPage();
  const troubles = [];
  page.on('pageerror', (error) => troubles.push(error.message));
  await page.goto(address);
  await page.waitForFunction(() => window.opal);
  while (streams.length === 0) await page.waitForTimeout(20);
  return { page, context, troubles };
}

const reached = (page, frame) =>
  page.waitForFunction(
    (f) => window.opal.frames() > f && window.opal.settled().then(() => window.opal.state()?.frame === f),
    frame,
  );

test('follows the newest, unless the reader has gone back; says when it is over', async () => {
  const { page, context, troubles } = await openLive();
  send(0, 22);
  await reached(page, 19);
  send(22, 52);
  await reached(page, 49);
  await page.keyboard.press('ArrowLeft');
  send(52, 102);
  await page.waitForFunction(() => window.opal.frames() === 100);
  assert.equal(await page.evaluate(() => window.opal.settled().then(() => window.opal.state().frame)), 48);
  await page.getByRole('button', { name: 'Newest' }).click();
  send(102, 202);
  await reached(page, 199);
  const drawn = await page.evaluate(() => window.opal.drawn());
  assert.deepEqual(
    drawn
      .filter(({ kind }) => kind === 'hypothesis')
      .map(({ id }) => id)
      .sort(),
    run.truth[199].hypotheses.map(({ id }) => id).sort(),
  );
  streams.at(-1).write('event: end\ndata: over\n\n');
  await page.waitForFunction(() => /over/.test(document.querySelector('.live').textContent));
  assert.deepEqual(troubles, []);
  await context.close();
});

test('a connection that is lost is found again, and the run told anew', async () => {
  const { page, context, troubles } = await openLive();
  send(0, 32);
  await reached(page, 29);
  streams.at(-1).destroy();
  await page.waitForFunction(() => /lost/i.test(document.querySelector('.live').textContent));
  while (streams.length < 2) await page.waitForTimeout(20);
  send(0, 62);
  await reached(page, 59);
  assert.deepEqual(troubles, []);
  await context.close();
});

test('a page of a run that never ends drops what is older than its window, and stays where the reader is', { skip }, async () => {
  const lines = recordsOfWindow({ seconds: 120, window_s: 20 });
  const sendLines = (from, to) => streams.at(-1).write(lines.slice(from, to).map((line) => `data: ${line}\n\n`).join(''));
  const { page, context, troubles } = await openLive();
  const state = () => page.evaluate(() => window.opal.settled().then(() => window.opal.state()));
  const newest = async (keyframe) => {
    await page.waitForFunction((k) => window.opal.settled().then(() => window.opal.state()?.keyframe === k), keyframe);
    return state();
  };
  sendLines(0, 202);
  await newest(199);
  await page.getByRole('button', { name: 'Step back' }).click();
  const seen = (await state()).time;
  sendLines(202, 242);
  await page.waitForFunction(() => window.opal.settled().then(() => window.opal.frames() < 200));
  assert.equal((await state()).time, seen);
  sendLines(242, 482);
  await page.waitForFunction((t) => window.opal.settled().then(() => window.opal.state().time > t), seen);
  await page.getByRole('button', { name: 'Newest' }).click();
  await newest(479);
  const drawn = await page.evaluate(() => window.opal.drawn());
  assert.ok(drawn.some(({ kind }) => kind === 'trajectory') && drawn.some(({ kind }) => kind === 'hypothesis'));
  const kept = await page.evaluate(() => window.opal.frames());
  assert.ok(kept >= 80 && kept < 200, `${kept} updates are kept`);
  assert.deepEqual(troubles, []);
  await context.close();
});

test('a broken record is told and ends the following', async () => {
  const { page, context, troubles } = await openLive();
  send(0, 12);
  await reached(page, 9);
  streams.at(-1).write('data: {"r":"frame","time":"soon"}\n\n');
  await page.waitForFunction(() => window.opal.errors.length > 0);
  assert.match(await page.locator('.alerts').innerText(), /record 13 \(frame\): time: expected a number, found "soon"/);
  assert.equal(await page.evaluate(() => window.opal.frames()), 10);
  assert.deepEqual(troubles, []);
  await context.close();
});
