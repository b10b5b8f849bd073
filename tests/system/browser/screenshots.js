/// Pictures of the page for the eye: node screenshots.js OUT [PAGE.html]; with a page, of its data in the page as it is in
/// these sources, else of a synthetic run.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { launch, open } from './browser.js';
import { repack, writePage } from './page_file.js';
import { syntheticRun } from './synthetic_run.js';

const [, , out = 'screenshots', file] = process.argv;
const kShots = [
  ['laptop', { width: 1366, height: 768 }, 'light', 0.1, false],
  ['laptop-late', { width: 1366, height: 768 }, 'light', 0.75, true],
  ['laptop-dark', { width: 1366, height: 768 }, 'dark', 0.5, true],
  ['tablet', { width: 820, height: 1180 }, 'light', 0.5, true],
  ['tablet-wide', { width: 1180, height: 820 }, 'dark', 0.3, true],
  ['phone', { width: 390, height: 844 }, 'light', 0.5, true],
];
mkdirSync(out, { recursive: true });
const address = file ? repack(file) : writePage('shots', [syntheticRun({ frames: 300, hypotheses: 40 }).lines, 'out']);
const browser = await launch();
for (const [name, viewport, colorScheme, part, selects] of kShots) {
  const { page, context, troubles } = await open(browser, address, { viewport, colorScheme });
  await page.evaluate(([p]) => window.opal.seek(Math.floor(p * (window.opal.frames() - 1))), [part]);
  if (selects) await page.keyboard.press('b');
  if (name === 'laptop-dark') await page.keyboard.press('2');
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(out, `${name}.png`), fullPage: name === 'phone' || name === 'tablet' });
  if (troubles.length > 0) console.log(name, troubles);
  await context.close();
}
await browser.close();
