import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { openPage, startBrowser, whyNoBrowser } from './browser.mjs';
import { fillPage } from './fill_page.mjs';
import { makeReplay } from './make_replay.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const missing = await whyNoBrowser();
if (missing && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);
const check = (name, body) => test(name, { skip: missing ?? false, timeout: 600000 }, body);

let folder, browser, address;
before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-pictures-'));
  execFileSync('node', [join(here, '../build.mjs'), folder]);
  const path = join(folder, 'replay.html');
  const replay = makeReplay({ floes: 40, frames: 20 });
  writeFileSync(path, fillPage(readFileSync(join(folder, 'page.html'), 'utf8'), replay.bytes, { title: 'A test', live: false }));
  address = `file://${path}`;
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});
const open = () => openPage(browser, address, { width: 900, height: 560 });
const shoot = async (page, time, between = false) => {
  await page.evaluate((t, b) => window.nilas.shoot(t, b), time, between);
  return Buffer.from(await page.screenshot()).toString('base64');
};
const shown = (page) => page.evaluate(() => Object.fromEntries(['#facts', '#legend', '#panel', '#dock', '#controls', '#facts .buttons']
  .map((name) => [name, document.querySelector(name).getClientRects().length > 0])));

check('a picture has the time and the legend, and none of what is for a user', async () => {
  const { page, faults } = await open();
  assert.deepEqual(await page.evaluate(() => window.nilas.compose('t=1.5&view=top', false)), []);
  await shoot(page, 1.5);
  assert.deepEqual(await shown(page), { '#facts': true, '#legend': true, '#panel': false, '#dock': false, '#controls': false, '#facts .buttons': false });
  assert.match(await page.$eval('#facts', (bar) => bar.textContent), /1\.5 s/);
  await page.evaluate(() => window.nilas.compose('t=1.5&view=top', true));
  assert.deepEqual(Object.values(await shown(page)), [false, false, false, false, false, false]);
  assert.deepEqual(await page.$eval('canvas', (canvas) => [canvas.clientWidth, canvas.clientHeight]), [900, 560]);
  assert.deepEqual(faults, []);
  await page.close();
});

check('the same words give the same picture, whatever was shown before', async () => {
  const { page } = await open();
  const words = 't=1&view=bow&color=speed&graphs=1';
  await page.evaluate((w) => window.nilas.compose(w, false), words);
  const first = await shoot(page, 1), later = await shoot(page, 1.5);
  assert.notEqual(first, later);
  await page.evaluate(() => window.nilas.compose('t=0.2&view=side', false));
  await shoot(page, 0.2);
  await page.evaluate((w) => window.nilas.compose(w, false), words);
  assert.equal(await shoot(page, 1), first);
  assert.notEqual(await shoot(page, 1.05, true), first);
  const other = await open();
  await other.page.evaluate((w) => window.nilas.compose(w, false), words);
  assert.equal(await shoot(other.page, 1), first);
  await page.close();
  await other.page.close();
});

check('wrong words are named', async () => {
  const { page } = await open();
  const faults = await page.evaluate(() => window.nilas.compose('t=1&colour=x&view=nowhere&camera=1,2', false));
  assert.match(faults.join(' '), /no option "colour".*"view" cannot be "nowhere".*six numbers/);
  assert.deepEqual(await page.evaluate(() => window.nilas.span.map((time) => Number(time.toFixed(6)))), [0, 1.9]);
  await page.close();
});
