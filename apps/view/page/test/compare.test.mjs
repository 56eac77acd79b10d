/** The page of a comparison that the program wrote. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { openPage, startBrowser, whyNoBrowser } from './browser.mjs';

const here = dirname(fileURLToPath(import.meta.url));
/** The program beside the folder in which the build runs the tests, or that of the build of the sources. */
const program = [process.env.NILAS, join(here, '../../../nilas'), join(here, '../../../../build/release/nilas')]
  .find((file) => file && existsSync(file) && statSync(file).isFile());
const missing = await whyNoBrowser() ?? (program ? null : 'There is no program nilas to make the page. Name it in NILAS.');
if (missing && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);
const check = (name, body) => test(name, { skip: missing ?? false, timeout: 600000 }, body);

const SCENE = `<scene version="1" name="ship">
  <time step="0.01" end="1"/>
  <contact law="coulomb" solver="auto" tolerance="1e-6">
    <friction between="hull ice" static="0.2" kinetic="0.1"/>
    <friction between="ice ice" static="0.3" kinetic="0.3"/>
  </contact>
  <water density="1005"/>
  <hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">
    <hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="300"/>
    <mass draught="0.2"/>
    <carriage speed="0.5" ramp="0.05"/>
  </vessel>
  <ice thickness="0.05">
    <floe name="port" outline="2.9 0.02 3.4 0.02 3.4 0.5 2.9 0.5"/>
    <floe name="starboard" outline="2.95 -0.6 3.4 -0.6 3.4 -0.02 2.95 -0.02"/>
  </ice>
</scene>`;

/** The same ship at a sheet that breaks, and moored in a current that drives floes at her. */
const OTHERS = {
  level: SCENE.replace('name="ship">', 'name="level">').replace(/<ice [^]*<\/ice>/, `<ice thickness="0.05">
    <field kind="level" region="2.9 -1 4.5 1" fixed="true" breakable="true"/>
  </ice>
  <fracture flexural_strength="4e4" compressive_strength="1e5" fracture_toughness="3e3">
    <crushing model="explicit" between_floes="true"/><bending model="nevel"/>
  </fracture>`),
  moored: SCENE.replace('name="ship">', 'name="moored">').replace('<water density="1005"/>', '<water density="1005"><current velocity="-0.3 0 0"/></water>')
    .replace(/<carriage[^>]*>/, `<mooring>
      ${[[-1, -1], [-1, 1], [1, -1], [1, 1]].map(([x, y], i) => `<spring_line name="l${i}" fairlead="${1.4 + 1.1 * x} ${0.3 * y} 0.1" anchor="${1.4 + 7 * x} ${6 * y} 0" length="6.5" stiffness="2000"/>`).join('\n')}
    </mooring>`),
};

let folder, browser, address, json;
before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-compare-'));
  writeFileSync(join(folder, 'a ship.xml'), SCENE);
  execFileSync(program, ['compare', 'a ship.xml', '--out', 'out', '--solvers', 'auto,nsgs,pgs', '--dt', '0.01,0.005', '--seeds', '2', '--quiet'], { cwd: folder });
  json = JSON.parse(readFileSync(join(folder, 'out/compare.json'), 'utf8'));
  address = `file://${join(folder, 'out/compare.html')}`;
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});
const open = (options = {}) => openPage(browser, address, { width: 1280, height: 900, waits: false, ...options });
/** Moves the pointer to the mark of a setting. */
const pointAt = async (page, setting) => {
  const [x, y] = await page.evaluate(async (number) => {
    const plot = window.nilas.plots[0];
    plot.picture.scrollIntoView({ block: 'center', behavior: 'instant' });
    // To scroll hides the card, one picture later.
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return plot.placeOf(plot.points.find((point) => point.setting === number));
  }, setting);
  await page.mouse.move(x + 1, y);
  return [x, y];
};
const settings = (page) => page.evaluate(() => window.nilas.plots[0].points.map(({ setting }) => setting));

check('a mark shows the figures and the runs of its setting', async () => {
  const { page, faults, requests } = await open();
  const numbers = await settings(page);
  assert.ok(numbers.length >= 3, `${numbers}`);
  for (const number of numbers) {
    await pointAt(page, number);
    const shown = await page.evaluate(() => window.nilas.plots[0].hovered?.setting);
    if (shown !== number) continue;  // another mark lies at the same place
    const text = await page.$eval('#tip', (tip) => (tip.hidden ? '' : tip.textContent));
    const setting = json.settings[number - 1];
    assert.ok(text.includes(setting.label), `${text} has no ${setting.label}`);
    assert.ok(text.includes(setting.solver) && /computing time/.test(text));
    assert.equal(await page.$$eval('#tip table tr', (rows) => rows.length), 1 + setting.runs);
  }
  await page.mouse.move(5, 5);
  assert.equal(await page.$eval('#tip', (tip) => tip.hidden), true);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
});

check('a click marks the row, and a click on a row marks the mark', async () => {
  const { page, faults } = await open();
  const [number] = await settings(page), [x, y] = await pointAt(page, number);
  await page.mouse.click(x, y);
  const picked = await page.evaluate(() => window.nilas.picked);
  const rows = await page.$$eval('#settings tr.picked', (list) => list.map((row) => Number(row.dataset.setting)));
  assert.deepEqual(rows, [picked]);
  const other = (await settings(page)).find((n) => n !== picked);
  await page.click(`#settings tr[data-setting="${other}"] td.name`);
  assert.equal(await page.evaluate(() => window.nilas.picked), other);
  assert.deepEqual(await page.$$eval('#plot-front .mark.picked', (list) => list.map((mark) => Number(mark.dataset.setting))), [other]);
  await page.click(`#settings tr[data-setting="${other}"] td.name`);
  assert.equal(await page.evaluate(() => window.nilas.picked), null);
  assert.deepEqual(faults, []);
  await page.close();
});

check('labels cover neither each other nor a mark', async () => {
  const { page } = await open();
  const boxes = await page.$$eval('#plot-front .label text', (list) => list.map((text) => text.getBoundingClientRect().toJSON()));
  assert.equal(boxes.length, (await settings(page)).length);
  const rings = await page.$$eval('#plot-front [data-setting] .ring', (list) => list.map((ring) => ring.getBoundingClientRect().toJSON()));
  assert.equal(rings.length, 1);
  boxes.forEach((a, i) => [...rings, ...boxes.slice(i + 1)].forEach((b) => {
    const wide = Math.min(a.right, b.right) - Math.max(a.left, b.left), high = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
    assert.ok(wide < 1 || high < 4, `a label covers another or the ring by ${wide} x ${high} pixels`);
  }));
  await page.close();
});

check('the recommended command is copied, and it runs', async () => {
  const context = browser.defaultBrowserContext();
  await context.overridePermissions(address, ['clipboard-read', 'clipboard-write', 'clipboard-sanitized-write']).catch(() => {});
  const { page, faults } = await open();
  assert.ok(json.chosen_command, 'no setting was recommended');
  assert.equal(await page.$eval('.command code', (code) => code.textContent), json.chosen_command);
  // The clipboard belongs to the system; what the page hands over is what counts.
  await page.evaluate(() => { navigator.clipboard.writeText = async (text) => { window.copied = text; }; });
  await page.click('.command button');
  await page.waitForFunction(() => document.querySelector('.command button').textContent === 'Copied');
  assert.equal(await page.evaluate(() => window.copied), json.chosen_command);
  await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error('refused')); });
  await page.waitForFunction(() => document.querySelector('.command button').textContent === 'Copy');
  await page.click('.command button');
  await page.waitForFunction(() => document.querySelector('.command button').textContent !== 'Copy');
  assert.equal(await page.evaluate(() => getSelection().toString().trim()), json.chosen_command);
  assert.deepEqual(faults, []);
  execFileSync('sh', ['-c', `${json.chosen_command.replace('nilas', `'${program}'`)} --quiet --out run`], { cwd: folder });
  assert.equal(JSON.parse(readFileSync(join(folder, 'run/summary.json'), 'utf8')).status, 'done');
  await page.close();
});

check('on a phone nothing is wider than the screen', async () => {
  const { page, faults } = await open({ width: 375, height: 720, isMobile: true });
  const layout = () => page.evaluate(() => ({ page: document.documentElement.scrollWidth, plot: window.nilas.plots[0].picture.getBoundingClientRect().width,
                                              letters: parseFloat(getComputedStyle(document.querySelector('.plot svg')).fontSize) }));
  let now = await layout();
  assert.ok(now.page <= 375 && now.plot <= 360 && now.letters >= 11, JSON.stringify(now));
  await page.setViewport({ width: 1280, height: 800 });
  await page.waitForFunction(() => window.nilas.plots[0].picture.getBoundingClientRect().width > 500);
  now = await layout();
  assert.ok(now.page <= 1280, JSON.stringify(now));
  assert.deepEqual(faults, []);
  await page.close();
});

check('without its script the page has everything but the plot that moves', async () => {
  const { page } = await openPage(browser, 'about:blank', { waits: false });
  await page.setJavaScriptEnabled(false);
  await page.goto(address);
  assert.ok(await page.$('#picture-front svg'), 'no picture');
  assert.equal(await page.$eval('.command code', (code) => code.textContent), json.chosen_command);
  assert.equal(await page.$eval('.command button', (button) => button.getClientRects().length), 0);
  await page.close();
});

for (const [name, scene] of Object.entries(OTHERS)) {
  check(`a comparison of the ${name} scene is shown, on a desk and on a phone`, async () => {
    writeFileSync(join(folder, `${name}.xml`), scene);
    execFileSync(program, ['compare', `${name}.xml`, '--out', name, '--solvers', 'auto,nsgs', '--dt', '0.01,0.005', '--seeds', '1', '--quiet'], { cwd: folder });
    const found = JSON.parse(readFileSync(join(folder, name, 'compare.json'), 'utf8'));
    for (const size of [{ width: 1280, height: 900 }, { width: 390, height: 800 }]) {
      const { page, faults, requests } = await openPage(browser, `file://${join(folder, name, 'compare.html')}`, { waits: false, ...size });
      const numbers = await settings(page);
      assert.ok(numbers.length >= 2 && numbers.length <= found.settings.length, `${numbers}`);
      assert.ok((await page.$eval('body', (body) => body.textContent)).includes(name));
      assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth + 1), `${name} is wider than ${size.width} pixels`);
      await page.click(`#settings tr[data-setting="${numbers[0]}"] td.name`);
      assert.equal(await page.evaluate(() => window.nilas.picked), numbers[0]);
      assert.deepEqual(faults, []);
      assert.deepEqual(requests, []);
      await page.close();
    }
  });
}
