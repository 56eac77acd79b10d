#!/usr/bin/env node
/**
 * Measures the page with synthetic replays of 100, 1000 and 10 000 floes, in a browser that draws by software.
 *
 * Times on a busy machine say little; `CPU ms` is the processor time of a frame, over all threads of the browser.
 *
 * usage: node measure.mjs [FRAMES] [FLOES ...]
 */
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { openPage, processorTime, startBrowser } from './browser.mjs';
import { fillPage } from './fill_page.mjs';
import { makeReplay } from './make_replay.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const [frames = 100, ...given] = process.argv.slice(2).map(Number);
const folder = mkdtempSync(join(tmpdir(), 'nilas-measure-'));
execFileSync('node', [join(here, '../build.mjs'), folder]);
const template = readFileSync(join(folder, 'page.html'), 'utf8');
console.log(`page without data: ${Math.round(template.length / 1000)} kB`);
const rows = [];
for (const floes of given.length > 0 ? given : [100, 1000, 10000]) {
  const { bytes } = makeReplay({ floes, frames, keepsFrames: false }), file = join(folder, `${floes}.html`);
  writeFileSync(file, fillPage(template, bytes, { title: `${floes} floes`, live: false }));
  const browser = await startBrowser();
  const { page, faults } = await openPage(browser, `file://${file}`, { width: 1280, height: 800 });
  const loaded = await page.evaluate(() => window.nilas.stats());
  const opened = processorTime(browser), count = Math.min(frames, floes > 5000 ? 10 : 40);
  const forward = await page.evaluate((n) => window.nilas.measure(n), count);
  const work = (processorTime(browser) - opened) / count;
  const seek = await page.evaluate(async (count) => {
    const start = performance.now();
    for (let k = 0; k < 3; ++k) await window.nilas.seekFrame(Math.floor(((k * 7 + 3) % 10) / 10 * count));
    return (performance.now() - start) / 3;
  }, frames);
  const stats = await page.evaluate(() => window.nilas.stats());
  rows.push({ floes, 'replay kB': Math.round(bytes.length / 1000), 'bytes a floe-frame': (bytes.length / floes / frames).toFixed(2),
              'page kB': Math.round(statSync(file).size / 1000), 'first picture ms': Math.round(loaded.firstPictureMs), 'all read ms': Math.round(loaded.readyMs),
              'decode ms': stats.decodeMs.toFixed(2), 'draw ms': forward.drawMs.toFixed(1), 'CPU ms': Math.round(work), 'start CPU ms': opened, 'frames/s': forward.framesPerSecond.toFixed(1),
              'seek ms': Math.round(seek), 'heap MB': Math.round(stats.heapBytes / 1e6), 'draw calls': stats.drawCalls, triangles: stats.triangles });
  if (faults.length > 0) console.log(faults);
  await browser.close();
}
console.table(rows);
rmSync(folder, { recursive: true });
