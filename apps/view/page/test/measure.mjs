#!/usr/bin/env node
/**
 * Measures the page in a browser that draws by software, with replays of runs, or with synthetic ones of so many floes.
 *
 * Times on a busy machine say little; `CPU ms` is the processor time of a frame, over all threads of the browser.
 *
 * usage: node measure.mjs [FRAMES] [FLOES | REPLAY.bin ...]
 */
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPage, processorTime, startBrowser } from './browser.mjs';
import { fillPage } from './fill_page.mjs';
import { makeReplay } from './make_replay.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [frames = '100', ...given] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'nilas-measure-'));

/** The times of a page with this replay. */
async function measure(name, bytes, template) {
  const file = join(folder, 'page.html');
  writeFileSync(file, fillPage(template, bytes, { title: name, live: false }));
  const browser = await startBrowser();
  const { page, faults } = await openPage(browser, `file://${file}`, { width: 1280, height: 800 });
  if (faults.length > 0) console.log(faults);
  const loaded = await page.evaluate(() => window.nilas.stats());
  const opened = processorTime(browser), { frameCount, floes } = await page.evaluate(() => ({
    frameCount: window.nilas.frameCount, floes: Number(document.querySelectorAll('#facts .fact b')[2].textContent) }));
  const count = Math.min(frameCount, floes > 5000 ? 10 : 40);
  const forward = await page.evaluate((n) => window.nilas.measure(n), count);
  const work = (processorTime(browser) - opened) / count;
  const seek = await page.evaluate(async (total) => {
    const start = performance.now();
    for (const share of [0.3, 0.9, 0.4]) await window.nilas.seekFrame(Math.floor(share * total));
    return (performance.now() - start) / 3;
  }, frameCount);
  const stats = await page.evaluate(() => window.nilas.stats());
  await browser.close();
  return { replay: name, floes, frames: frameCount, 'replay kB': Math.round(bytes.length / 1000), 'page kB': Math.round(statSync(file).size / 1000),
           'first picture ms': Math.round(loaded.firstPictureMs), 'all read ms': Math.round(loaded.readyMs), 'decode ms': stats.decodeMs.toFixed(2),
           'draw ms': forward.drawMs.toFixed(1), 'frames/s': forward.framesPerSecond.toFixed(1), 'CPU ms': Math.round(work),
           'start CPU ms': opened, 'seek ms': Math.round(seek), 'heap MB': Math.round(stats.heapBytes / 1e6), 'draw calls': stats.drawCalls };
}

execFileSync('node', [join(here, '../build.mjs'), folder]);
const template = readFileSync(join(folder, 'page.html'), 'utf8'), rows = [];
console.log(`page without data: ${Math.round(template.length / 1000)} kB`);
for (const what of given.length > 0 ? given : ['100', '1000', '10000']) {
  const bytes = existsSync(what) ? readFileSync(what) : makeReplay({ floes: Number(what), frames: Number(frames), keepsFrames: false }).bytes;
  rows.push(await measure(what, bytes, template));
}
console.table(rows);
rmSync(folder, { recursive: true });
