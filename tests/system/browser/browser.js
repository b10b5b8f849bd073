/// A real browser for the tests: Debian's chromium, or what OPAL_CHROMIUM names.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const kPath = process.env.OPAL_CHROMIUM ?? '/usr/bin/chromium';
export const kLaptop = { width: 1366, height: 768 };

export async function launch() {
  if (!existsSync(kPath)) throw new Error(`expected a browser at ${kPath}; set OPAL_CHROMIUM`);
  const args = ['--disable-gpu', '--force-color-profile=srgb'];
  if (process.getuid?.() === 0) args.push('--no-sandbox');
  return chromium.launch({ executablePath: kPath, args });
}

/// Opens a page and waits until its data is read. `troubles` collects what the page must never do.
export async function open(browser, address, { viewport = kLaptop, ...more } = {}) {
  const context = await browser.newContext({ viewport, ...more });
  const page = await context.newPage();
  const troubles = [];
  page.on('pageerror', (error) => troubles.push(`error: ${error.message}`));
  page.on('console', (message) => message.type() === 'error' && troubles.push(`console: ${message.text()}`));
  page.on('dialog', (dialog) => {
    troubles.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  await page.goto(address);
  await page.waitForFunction(() => window.opal);
  await page.evaluate(() => window.opal.ready.then(() => window.opal.settled()));
  return { page, context, troubles };
}
