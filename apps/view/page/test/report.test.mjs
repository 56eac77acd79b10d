/** The page of `nilas report`, as the program writes it. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { openPage, startBrowser, whyNoBrowser } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));
/** The program of the build that this folder was copied into. */
const PROGRAM = process.env.NILAS || join(here, '../../../nilas');
const missing = await whyNoBrowser() ?? (existsSync(PROGRAM) ? null : `There is no program at ${PROGRAM}. Name it in NILAS.`);
if (missing && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);

const check = (name, body) => test(name, { skip: missing ?? false, timeout: 600000 }, body);

/** A ship that breaks and crushes a sheet of 20 mm. */
const SCENE = `<scene version="1" name="sheet">
  <time step="0.01" end="1.4"/>
  <contact solver="nsgs" tolerance="1e-3" max_iterations="200" stabilisation="split-impulse" erp="0.3">
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
    <friction between="hull ice" static="0.1" kinetic="0.1"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="600"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.1"/>
  </vessel>
  <ice thickness="0.02"><floe name="sheet" fixed="true" breakable="true" outline="3.1 -2 6 -2 6 2 3.1 2"/></ice>
  <fracture flexural_strength="4e4" compressive_strength="1e5">
    <crushing model="explicit"/><bending model="nevel"/>
  </fracture>
  <output statistics="0.2 1.4"/>
</scene>`;
const SECTIONS = ['scene', 'loads', 'spectra', 'statistics', 'place', 'pressure', 'ice', 'breaks', 'energy', 'solver', 'time', 'gaps'];

let folder, browser, report;
const nilas = (...words) => execFileSync(PROGRAM, words, { cwd: folder, stdio: 'pipe' });
const open = (name, options) => openPage(browser, `file://${join(folder, name)}`, { waits: false, ...options });

before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-report-'));
  writeFileSync(join(folder, 'sheet.xml'), SCENE);
  nilas('run', 'sheet.xml', '--quiet', '--out', 'run');
  nilas('report', 'run');
  cpSync(join(folder, 'run'), join(folder, 'copy'), { recursive: true });
  nilas('report', 'run', 'copy', '--out', 'both');
  browser = await startBrowser();
  report = await open('run/report.html');
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

check('every section is there with its plots, and nothing is asked of a network', async () => {
  const { page, faults, requests } = report;
  const shown = await page.evaluate(() => ({
    sections: [...document.querySelectorAll('main > section')].map(({ id }) => id),
    empty: [...document.querySelectorAll('.plot')].filter((box) => !box.querySelector('canvas')).map(({ id }) => id),
    plots: window.nilasReport.plots.count, covered: window.nilasReport.plots.heights.concentration,
    headline: document.querySelector('#headline p').textContent,
    map: document.querySelectorAll('#hull-map rect').length,
    drawings: document.querySelectorAll('svg.drawing .hull').length,
  }));
  assert.deepEqual(shown.sections, SECTIONS);
  assert.deepEqual(shown.empty, []);
  assert.ok(shown.plots >= 12, `${shown.plots} plots`);
  assert.ok(shown.covered[1] <= 120, `ice covers up to ${shown.covered[1]} % of the water`);
  assert.match(shown.headline, /^Over .* the ice pushed the vessel back with .* on average/);
  assert.ok(shown.map > 5);
  assert.equal(shown.drawings, 4, 'from above and from the side, at the start and at the largest load');
  for (const id of ['plot-pressure-area', 'plot-breaks', 'plot-spectrum']) assert.ok(await page.$(`#${id}`), id);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
});

check('the hull in 3-D shows loaded and bare places', async () => {
  const { page, faults } = report;
  const colours = await page.evaluate(() => {
    const { stage } = window.nilasReport.stage;
    const picture = new Image();
    picture.src = stage.capture();
    return picture.decode().then(() => {
      const canvas = document.createElement('canvas');
      Object.assign(canvas, { width: picture.width, height: picture.height });
      const drawing = canvas.getContext('2d');
      drawing.drawImage(picture, 0, 0);
      const { data } = drawing.getImageData(0, 0, canvas.width, canvas.height);
      const seen = { bare: 0, loaded: 0 };
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = data.slice(i, i + 3), spread = Math.max(r, g, b) - Math.min(r, g, b);
        if (spread > 60) ++seen.loaded;
        else if (spread > 8 && r < 225) ++seen.bare;
      }
      return seen;
    });
  });
  assert.ok(colours.bare > 1000 && colours.loaded > 100, JSON.stringify(colours));
  assert.deepEqual(faults, []);
});

check('the force of the carriage is scaled to the time after its ramp, and shows the ramp where that is enlarged', async () => {
  const { page } = report;
  const shown = await page.evaluate(async () => {
    const { plots } = window.nilasReport, drawn = () => new Promise((resolve) => { setTimeout(resolve, 50); });
    const { y_range: range, curves: [{ y, high }] } = plots.list.find(({ id }) => id === 'force-carriage');
    const first = plots.heights['force-carriage'], [from, to] = plots.ranges['force-carriage'];
    plots.zoom('force-carriage', 0, 0.2);
    await drawn();
    const ramp = plots.heights['force-carriage'];
    plots.zoom('force-carriage', from, to);
    await drawn();
    return { range, first, ramp, again: plots.heights['force-carriage'], largest: Math.max(...(high.length > 0 ? high : y)) };
  });
  assert.ok(shown.range[1] < shown.largest / 2, JSON.stringify(shown));
  assert.deepEqual(shown.first, shown.range);
  assert.deepEqual(shown.again, shown.range);
  assert.ok(shown.ramp[1] >= shown.largest, JSON.stringify(shown));
});

check('a stretch of time that one graph shows is shown by all over time', async () => {
  const { page } = report;
  const ranges = await page.evaluate(async () => {
    const { plots } = window.nilasReport;
    plots.zoom('load-along', 0.5, 0.9);
    await new Promise((resolve) => { setTimeout(resolve, 50); });
    return plots.ranges;
  });
  assert.deepEqual(ranges['load-along'], [0.5, 0.9]);
  assert.deepEqual(ranges.residual, [0.5, 0.9]);
  assert.notDeepEqual(ranges.spectrum, [0.5, 0.9]);
});

check('on a phone nothing is wider than the screen, and graphs are resized', async () => {
  const { page, faults } = report;
  await page.setViewport({ width: 390, height: 800, isMobile: true, hasTouch: true });
  await page.waitForFunction(() => [...document.querySelectorAll('.plot .uplot')].every((plot) => plot.clientWidth <= 390));
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 390);
  const map = await page.$eval('#hull-map', (box) => {
    const letters = box.querySelector('text'), { width, height } = letters.getBoundingClientRect();
    return { height, width, mark: box.querySelectorAll('.mark').length, name: box.querySelector('.mark-name').textContent };
  });
  assert.ok(map.height >= 11, `letters are ${map.height} pixels high`);
  assert.equal(map.mark, 1);
  assert.match(map.name, /^floe \d+$/);
  // Nothing of the hull is beyond the edge of its picture.
  const isWhole = await page.evaluate(() => {
    const { stage } = window.nilasReport.stage, picture = new Image();
    picture.src = stage.capture();
    return picture.decode().then(() => {
      const canvas = document.createElement('canvas'), { width, height } = picture;
      Object.assign(canvas, { width, height });
      const drawing = canvas.getContext('2d');
      drawing.drawImage(picture, 0, 0);
      const { data } = drawing.getImageData(0, 0, width, height), at = (x, y) => data.slice(4 * (x + y * width), 4 * (x + y * width) + 4).join();
      const edge = [...Array.from({ length: width }, (_, x) => [[x, 0], [x, height - 1]]).flat(),
                    ...Array.from({ length: height }, (_, y) => [[0, y], [width - 1, y]]).flat()];
      return edge.every(([x, y]) => at(x, y) === at(0, 0));
    });
  });
  assert.ok(isWhole, 'the hull is cut by the edge of its picture');
  assert.deepEqual(faults, []);
});

check('the page has light and dark colours, and prints light ones', async () => {
  const { page, faults } = report;
  const paper = () => page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: 'dark' }]);
  assert.equal(await paper(), 'rgb(17, 25, 31)');
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  assert.equal(await paper(), 'rgb(255, 255, 255)');
  assert.ok(await page.$('#hull-stage img'), 'printers get a picture of the hull');
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.equal(await paper(), 'rgb(17, 25, 31)');
  assert.deepEqual(faults, []);
});

check('a comparison draws the curves of all runs over each other', async () => {
  const { page, faults, requests } = await open('both/comparison.html');
  const labels = await page.evaluate(() => [...document.querySelectorAll('#plot-load-along .u-label')].map((label) => label.textContent));
  assert.equal(labels.filter((label) => /^(run|copy)/.test(label)).length, 2);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
});
