/// How fluid the page is: node frame_rate.js [UPDATES] [HYPOTHESES] [PAGE.html]. Prints the time to load and the frames per
/// second while playing at full speed and while panning, in headless Chromium with software rendering; and the CPU time of a picture,
/// which says the same on a busy machine.
import { statSync } from 'node:fs';
import { launch, open } from './browser.js';
import { repack, writePage } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const [, , updates = '10000', hypotheses = '200', file] = process.argv;
const address = file
  ? repack(file)
  : writePage('fluid', [syntheticRun({ frames: Number(updates), hypotheses: Number(hypotheses), beams: 120 }).lines, 'out']);
console.log(`page: ${(statSync(address.slice('file://'.length)).size / 1e6).toFixed(1)} MB`);

/// CPU time of each of the browser's processes [s].
async function cpuOf(session) {
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  return new Map(processInfo.map(({ id, cpuTime }) => [id, cpuTime]));
}

/// Pictures per second while `act(k)` is called once per picture, for some seconds.
async function measure(page, seconds, act) {
  const before = await cpuOf(session);
  const result = await page.evaluate(
    async ([duration, source]) => {
      const step = new Function('k', source);
      const before = window.opal.paints,
        begin = performance.now(),
        gaps = [];
      let last = begin,
        k = 0;
      while (performance.now() - begin < 1000 * duration) {
        step(k++);
        await new Promise((resolve) => requestAnimationFrame(resolve));
        gaps.push(performance.now() - last);
        last = performance.now();
      }
      gaps.sort((a, b) => a - b);
      return {
        fps: ((window.opal.paints - before) * 1000) / (performance.now() - begin),
        slow_ms: gaps[Math.floor(0.95 * gaps.length)],
      };
    },
    [seconds, act],
  );
  const used = [...(await cpuOf(session))].map(([id, cpu]) => cpu - (before.get(id) ?? 0));
  return { ...result, cpu_ms: used.map((cpu) => (1000 * cpu) / (seconds * result.fps)) };
}

const browser = await launch();
const session = await browser.newBrowserCDPSession();
const began = performance.now();
const { page, troubles } = await open(browser, address, { bypassCSP: true });
const memory = await page.evaluate(() => performance.memory?.usedJSHeapSize ?? 0);
console.log(
  `load: ${((performance.now() - began) / 1000).toFixed(1)} s for ${await page.evaluate(() => window.opal.frames())} updates; heap ${(memory / 1e6).toFixed(0)} MB`,
);
const sum = (values) => values.reduce((a, b) => a + b, 0);
const report = (name, { fps, slow_ms, cpu_ms }) =>
  console.log(
    `${name}: ${fps.toFixed(0)} frames per second, 95 % within ${slow_ms.toFixed(0)} ms; CPU per picture ${sum(cpu_ms).toFixed(0)} ms, ${Math.max(...cpu_ms).toFixed(0)} ms of it in one process`,
  );

await page.getByLabel('Speed', { exact: true }).selectOption({ label: '32×' });
await page.keyboard.press('Escape');
const play = async (name) => {
  await page.evaluate(() => window.opal.seek(Math.floor(window.opal.frames() * 0.6)));
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  report(`playing at 32×${name}`, await measure(page, 4, ''));
  if (await page.evaluate(() => window.opal.choices().playing))
    await page.getByRole('button', { name: 'Pause', exact: true }).click();
};
await play('');
await page.getByRole('tab', { name: 'Tree' }).click();
await play(', with the tree');
await page.evaluate(() => (location.hash = `#t=${window.opal.choices().time}&assoc=all`));
await page.waitForTimeout(300);
await play(', with all association lines');
const box = await page.locator('.pane-global .pane-top').boundingBox();
const pan = `const pane = document.querySelector('.pane-global .pane-top');
  const fire = (type, x) => pane.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, clientX: ${box.x} + x, clientY: ${box.y} + 200, bubbles: true }));
  if (k === 0) { pane.setPointerCapture = () => {}; fire('pointerdown', 200); }
  fire('pointermove', 200 + 100 * Math.sin(k / 20));`;
report('panning', await measure(page, 4, pan));
if (troubles.length > 0) console.log(troubles);
await browser.close();
