/**
 * The page of runs of the program, which the environment variable NILAS names: a tow after its end and while it goes on,
 * level ice that breaks, and a moored ship in waves.
 */
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { openPage, startBrowser, whyNoBrowser } from './browser.mjs';
import { floeOnScreen, turnSwitches } from './visit.mjs';

const missing = await whyNoBrowser() ?? (process.env.NILAS ? null : 'NILAS does not name the program.');
if (missing && process.env.NILAS && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);

const CONTACT = `<contact law="coulomb" solver="nsgs" tolerance="1e-3" max_iterations="200" on_failure="record">
    <friction between="hull ice" static="0.1" kinetic="0.1"/><friction between="ice ice" static="0.3" kinetic="0.3"/>
  </contact>`;
const HULL = '<hull generate="icebreaker" length="3" beam="0.8" draught="0.2" depth="0.4" triangles="300"/>';

const TOWING = `<scene version="1" name="towing">
  <time step="0.01" end="2"/>${CONTACT}
  <water density="1005"/><hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">${HULL}<mass draught="0.2"/><carriage speed="0.5" ramp="0.05"/></vessel>
  <tank length="8" width="4" depth="1"/>
  <ice thickness="0.05">
    <floe name="port" outline="3 0.02 3.5 0.02 3.5 0.5 3 0.5"/><floe name="starboard" outline="3.05 -0.6 3.5 -0.6 3.5 -0.02 3.05 -0.02"/>
    <floe name="ahead" outline="3.55 -0.3 4.1 -0.3 4.1 0.4 3.55 0.4"/>
  </ice>
  <output trajectory_every="0.1"/>
</scene>`;

const LEVEL_ICE = `<scene version="1" name="level">
  <time step="0.01" end="2"/>${CONTACT}
  <water density="1005"/><hydro><buoyancy/><drag form="1" skin="0.005"/></hydro>
  <vessel name="ship" position="0 0">${HULL}<mass draught="0.2"/><carriage speed="0.5" ramp="0.05"/></vessel>
  <ice density="920" youngs_modulus="6e7" poisson="0.3" thickness="0.02">
    <field kind="level" region="2.9 -1.5 6 1.5" fixed="true" breakable="true"/>
  </ice>
  <fracture flexural_strength="4e4" compressive_strength="1e5" fracture_toughness="3e3" min_area="2e-3" max_aspect="8">
    <crushing model="explicit" between_floes="true"/><bending model="nevel"/>
  </fracture>
  <output trajectory_every="0.1"/>
</scene>`;

const line = (name, x, y) => `<line name="${name}" fairlead="${1.5 + 0.4 * Math.sign(x)} ${0.3 * Math.sign(y)} 0.3"
  anchor="${1.5 + x} ${y} -4" length="13" weight="3" stiffness="2e4" damping="10"/>`;
const MOORED = `<scene version="1" name="moored">
  <time step="0.01" end="2"/>${CONTACT}
  <water density="1005"><current velocity="-0.8 0 0"/><waves kind="regular" height="0.03" period="1.5" heading_deg="180"
    ramp="0.5" attenuation="exponential" attenuation_rate="0.3" ice_edge="4 0"/></water>
  <hydro><buoyancy/><drag form="1" skin="0.005"/><wave_loads/></hydro>
  <vessel name="ship" position="0 0">${HULL}<mass draught="0.2"/>
    <mooring depth="4" start="as-placed">${[['a', 12, 3], ['b', 12, -3], ['c', -12, 3], ['d', -12, -3]].map((l) => line(...l)).join('')}</mooring>
  </vessel>
  <ice thickness="0.05">
    <floe name="port" outline="2.9 0.02 3.4 0.02 3.4 0.5 2.9 0.5" velocity="-0.3 0 0"/>
    <floe name="starboard" outline="2.95 -0.6 3.4 -0.6 3.4 -0.02 2.95 -0.02" velocity="-0.3 0 0"/>
  </ice>
  <output trajectory_every="0.1"/>
</scene>`;

let folder, browser;
before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-runs-'));
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

/** The columns of vessel.csv in the step that ends at a time. */
function vesselAt(name, time) {
  const [head, ...rows] = readFileSync(join(folder, name, 'vessel.csv'), 'utf8').trim().split('\n').map((row) => row.split(','));
  const row = rows.find(([t]) => Math.abs(Number(t) - time) < 1e-6);
  return Object.fromEntries(head.map((column, k) => [column, Number(row[k])]));
}

/** The arrows on the vessel add up to the contact force of vessel.csv, as the rows of contacts.h5 do. */
function demandArrowsOfTable({ arrows, time }, name) {
  const row = vesselAt(name, time), vessel = arrows.filter(({ on, exact }) => on === 1 && exact);
  assert.ok(vessel.length > 0, `no arrow on the vessel at ${time} s`);
  ['x', 'y', 'z'].forEach((axis, k) => {
    const sum = vessel.reduce((total, { force }) => total + force[k], 0), size = vessel.reduce((total, { force }) => total + Math.abs(force[k]), 0);
    assert.ok(Math.abs(sum - row[`contact_f${axis}_N`]) <= 1e-5 * size + 1e-9, `${sum} N along ${axis} instead of ${row[`contact_f${axis}_N`]} N`);
  });
}

const nilas = (...words) => execFileSync(process.env.NILAS, words, { cwd: folder, stdio: ['ignore', 'pipe', 'inherit'] });

/** Runs a scene. Returns the address of its page. */
function pageOf(name, scene) {
  writeFileSync(join(folder, `${name}.xml`), scene);
  nilas('run', `${name}.xml`, '--quiet', '--out', name);
  nilas('view', name);
  return `file://${join(folder, name, 'replay.html')}`;
}

/** Opens the report of a run, also on a phone. Returns its first sentence. */
async function visitReport(name) {
  nilas('report', name);
  const { page, faults, requests } = await openPage(browser, `file://${join(folder, name, 'report.html')}`, { width: 640, height: 480, waits: false });
  await page.waitForFunction(() => [...document.querySelectorAll('.plot')].every((box) => box.querySelector('canvas')));
  const sentence = await page.$eval('#headline p', (first) => first.textContent);
  await page.setViewport({ width: 375, height: 720, isMobile: true, hasTouch: true });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth) <= 375);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
  return sentence;
}

/** Runs a scene for long with its live page, and calls `look(address, run)` meanwhile. */
async function lookWhileItRuns(name, scene, look) {
  writeFileSync(join(folder, `${name}.xml`), scene.replace('end="2"', 'end="600"').replace('length="8"', 'length="400"'));
  const run = spawn(process.env.NILAS, ['run', `${name}.xml`, '--quiet', '--out', name, '--view'], { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
  try {
    // The stream stays open: a run whose words nobody reads would end.
    await look(await new Promise((resolve) => {
      let said = '';
      run.stderr.on('data', (part) => {
        said += part;
        if (/http\S+\n/.test(said)) resolve(said.match(/http\S+/)[0]);
      });
    }));
    assert.equal(run.exitCode, null, 'to close the page ended the run');
  } finally {
    const ended = once(run, 'exit');
    run.kill('SIGINT');
    await ended;
  }
}

const frame = (page) => page.evaluate(() => window.nilas.frame);

/** Moves the time, turns the switches, picks a floe, and looks at it on a phone. */
async function visit(address, { silent, at = 1.23 }) {
  const { page, faults, requests } = await openPage(browser, address, { width: 640, height: 480 });
  await page.keyboard.press('End');
  await page.waitForFunction(() => window.nilas.frame === window.nilas.frameCount - 1);
  await page.keyboard.press('ArrowLeft');
  await page.evaluate((t) => window.nilas.seek(t), at);
  assert.equal(await frame(page), Math.floor(10 * at));
  for (const [name, changes] of Object.entries(await turnSwitches(page))) {
    if (!silent.includes(name)) assert.ok(changes.some(Boolean), `"${name}" changes nothing`);
  }
  await page.evaluate(() => {
    for (const name of ['graphs', 'panel']) window.nilas.set(name, false);
    window.nilas.set('view', 'top');
  });
  const floe = await floeOnScreen(page, 2);
  assert.ok(floe, 'no floe is on the screen');
  await page.mouse.click(floe.x, floe.y);
  await page.waitForFunction(() => !document.getElementById('card').hidden);
  assert.match(await page.$eval('#card', (card) => card.textContent), /Mass.*Speed/);
  const state = await page.evaluate(() => ({ ...window.nilas.state(), notices: window.nilas.notices,
    time: window.nilas.frame / 10, legendText: document.getElementById('legend').textContent }));
  assert.equal(state.picked, floe.id);
  assert.match(state.legendText, /picked/);
  assert.deepEqual(state.notices, []);
  await page.setViewport({ width: 375, height: 720, isMobile: true, hasTouch: true });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 375);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
  return state;
}

const check = (name, body) => test(name, { skip: missing ?? false, timeout: 300000 }, body);

check('a tow is shown, with the forces of its table', async () => {
  const state = await visit(pageOf('towing', TOWING), { silent: ['follow', 'damage'] });
  assert.match(state.legendText, /force of the carriage/);
  demandArrowsOfTable(state, 'towing');
  assert.match(await visitReport('towing'), /the ice pushed the vessel/);
});

check('a tow is shown while it goes on, from this machine alone', () => lookWhileItRuns('long', TOWING, async (live) => {
  const { page, faults, requests } = await openPage(browser, live, { width: 640, height: 480 });
  await page.waitForFunction(() => window.nilas.frameCount > 20);
  await page.evaluate(() => [...document.querySelectorAll('#controls button')].find((button) => button.textContent === 'Pause the run').click());
  // Who looks back is not pulled on.
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.nilas.frame === 0);
  await page.evaluate(() => window.nilas.seek(1.23));
  assert.equal(await frame(page), 12);
  for (const [name, changes] of Object.entries(await turnSwitches(page)))
    if (!['follow', 'damage'].includes(name)) assert.ok(changes.some(Boolean), `"${name}" changes nothing`);
  await page.evaluate(() => {
    for (const name of ['graphs', 'panel']) window.nilas.set(name, false);
    window.nilas.set('view', 'top');
  });
  const floe = await floeOnScreen(page, 2);
  await page.mouse.click(floe.x, floe.y);
  await page.waitForFunction(() => !document.getElementById('card').hidden);
  const state = await page.evaluate(() => ({ ...window.nilas.state(), time: window.nilas.frame / 10 }));
  assert.equal(state.picked, floe.id);
  demandArrowsOfTable(state, 'long');
  await page.setViewport({ width: 375, height: 720, isMobile: true, hasTouch: true });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 375);
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
}));

check('level ice and a moored ship are shown while they go on, on a phone', async () => {
  for (const [name, scene] of [['long-level', LEVEL_ICE], ['long-moored', MOORED]]) {
    await lookWhileItRuns(name, scene, async (live) => {
      const { page, faults, requests } = await openPage(browser, live, { width: 375, height: 720, isMobile: true });
      await page.waitForFunction(() => window.nilas.frameCount > 14);
      await page.evaluate(() => [...document.querySelectorAll('#controls button')].find((button) => button.textContent === 'Pause the run').click());
      const state = await page.evaluate(async () => {
        await window.nilas.seek(1.23);
        return { ...window.nilas.state(), time: window.nilas.frame / 10 };
      });
      assert.equal(state.time, 1.2);
      demandArrowsOfTable(state, name);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 375);
      assert.deepEqual(faults, []);
      assert.deepEqual(requests, []);
      await page.close();
    });
  }
});

check('a run in level ice is shown, with the pieces that break off', async () => {
  const state = await visit(pageOf('level', LEVEL_ICE), { silent: ['follow', 'tank', 'lines', 'damage'] });
  assert.ok(state.bodiesInFrame > 4, `${state.bodiesInFrame} bodies`);
  demandArrowsOfTable(state, 'level');
  assert.match(await visitReport('level'), /the ice pushed the vessel/);
});

check('a moored ship in waves is shown with its lines, and with the waves on the water', async () => {
  const state = await visit(pageOf('moored', MOORED), { silent: ['follow', 'tank'] });
  demandArrowsOfTable(state, 'moored');
  assert.match(state.legendText, /mooring line.*fairlead or anchor/);
  assert.equal(state.lines, 4);
  assert.equal(state.waves, 1);
  assert.equal(state.bodies, 3);
  assert.match(await visitReport('moored'), /the ice pushed the vessel/);
});
