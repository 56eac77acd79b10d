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
import { piece } from './replay_writer.mjs';
import { floeOnScreen, turnSwitches } from './visit.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const missing = await whyNoBrowser();
if (missing && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);

const check = (name, body) => test(name, { skip: missing ?? false, timeout: 600000 }, body);

let folder, browser, template;
const replay = makeReplay({ floes: 60, frames: 40 });

/** Writes a page with a replay. Returns its address. */
const write = (name, bytes, facts = {}, blockBytes = undefined) => {
  const path = join(folder, `${name}.html`);
  writeFileSync(path, fillPage(template, bytes, { title: 'A test', live: false, ...facts }, blockBytes));
  return `file://${path}`;
};
/** The picture is drawn by software, so a small one saves time. */
const open = (address, options) => openPage(browser, address, { width: 900, height: 560, ...options });

before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-page-'));
  execFileSync('node', [join(here, '../build.mjs'), folder]);
  template = readFileSync(join(folder, 'page.html'), 'utf8');
  browser = await startBrowser();
});
after(async () => {
  await browser?.close();
  if (folder) rmSync(folder, { recursive: true });
});

check('the template has every placeholder once, no address of another host that it would ask, and the licences', () => {
  for (const name of ['@NILAS_TITLE@', '@NILAS_FACTS@', '@NILAS_BLOCKS@']) assert.equal(template.split(name).length, 2, name);
  assert.doesNotMatch(template, /<(link|script|img)[^>]*(src|href)="?https?:/);
  assert.match(template, /Copyright .{0,40}three\.js authors/i);
  assert.match(template, /Leon Sorokin/);
  assert.equal(readFileSync(join(here, '../LICENSES.txt'), 'utf8'), readFileSync(join(folder, 'page-licences.txt'), 'utf8'));
});

check('it draws all bodies, and as many arrows as contacts, at any time', async () => {
  const { page, faults, requests } = await open(write('all', replay.bytes));
  assert.equal(await page.evaluate(() => window.nilas.frameCount), 40);
  for (const i of [0, 39, 17, 18, 5]) {
    const state = await page.evaluate(async (k) => {
      await window.nilas.seekFrame(k);
      window.nilas.capture();
      return window.nilas.state();
    }, i);
    const wanted = replay.frames[i];
    assert.equal(state.frame, i);
    assert.equal(state.bodies, wanted.bodies.length);
    assert.equal(state.contacts, wanted.contacts.length);
    assert.equal(state.arrows.length, wanted.contacts.length);
    assert.equal(state.crushed, wanted.contacts.filter(({ status }) => status === 3).length);
    assert.ok(state.rings <= state.crushed && (state.rings > 0) === (state.crushed > 0), `${state.rings} rings`);
    // Sums over pairs stand behind the exact contacts, so each arrow is sought by its bodies.
    for (const { on, by, force, position, exact } of state.arrows) {
      const found = wanted.contacts.find((c) => c.exact === exact && wanted.bodies[c.first].id === on && wanted.bodies[c.second].id === by);
      assert.ok(found, `${on} and ${by} do not touch`);
      const allowed = exact ? 1e-3 : 0.13 * Math.hypot(...found.force);
      force.forEach((f, k) => assert.ok(Math.abs(f - found.force[k]) < allowed, `force ${f} is not ${found.force[k]}`));
      position.forEach((x, k) => assert.ok(Math.abs(x - found.p[k]) < (exact ? 1e-4 : 5.4e-3)));
    }
  }
  assert.deepEqual(faults, []);
  assert.deepEqual(requests, []);
  await page.close();
});

check('the picture shows ice, hull and water, and changes with the time', async () => {
  const { page } = await open(write('picture', replay.bytes, {}, 30000) + '#ui=0&view=top&t=0.5', { width: 1280, height: 800 });
  const count = (time) => page.evaluate(async (t) => {
    await window.nilas.seek(t);
    const image = new Image();
    image.src = window.nilas.capture();
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height), context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height), found = { ice: 0, hull: 0, water: 0, sum: 0 };
    for (let k = 0; k < data.length; k += 4) {
      const [r, g, b] = data.subarray(k, k + 3);
      if (r > 225 && g > 235 && b > 240 && r > 238) ++found.ice;
      else if (r < 80 && g < 100 && b < 130 && b > r + 15) ++found.hull;
      else if (b > r + 40 && b > 150) ++found.water;
      found.sum = (found.sum * 31 + r + 7 * g + 13 * b) % 1000003;
    }
    return { ...found, pixels: data.length / 4 };
  }, time);
  const early = await count(0.5), late = await count(3.5);
  for (const { ice, hull, water, pixels } of [early, late]) {
    assert.equal(pixels, 1280 * 800);
    assert.ok(ice > 0.01 * pixels && hull > 0.02 * pixels && water > 0.1 * pixels, JSON.stringify({ ice, hull, water }));
  }
  assert.notEqual(early.sum, late.sum);
  assert.equal((await count(0.5)).sum, early.sum);
  await page.close();
});

check('every switch can be turned, and each leaves its trace', async () => {
  const { page, faults } = await open(write('switches', replay.bytes) + '#t=2');
  const trace = await turnSwitches(page);
  // The camera follows only once the time moves; a page's parts lie beside the picture and resize it.
  const silent = new Set(['follow']);
  for (const [name, changes] of Object.entries(trace)) {
    if (!silent.has(name)) assert.ok(changes.every(Boolean), `"${name}" changes nothing: ${changes}`);
  }
  assert.ok(Object.keys(trace).length >= 20, `only ${Object.keys(trace)}`);
  assert.deepEqual(faults, []);
  await page.close();
});

check('a click picks the floe under it, and the card tells what is known', async () => {
  const { page, faults } = await open(write('pick', replay.bytes) + '#t=2&view=top&graphs=0');
  const found = await floeOnScreen(page, 10);
  assert.ok(found, 'no floe was found on the screen');
  await page.mouse.click(found.x, found.y);
  await page.waitForFunction(() => !document.getElementById('card').hidden);
  assert.equal(await page.evaluate(() => window.nilas.state().picked), found.id);
  const body = await page.evaluate((id) => window.nilas.pick(id), found.id), frame = replay.frames[20], before = replay.frames[19];
  const wanted = frame.bodies.find(({ id }) => id === found.id), old = before.bodies.find(({ id }) => id === found.id);
  assert.ok(Math.abs(body.mass / wanted.mass - 1) < 1e-6);
  if (old) body.velocity.forEach((v, k) => assert.ok(Math.abs(v - (wanted.p[k] - old.p[k]) / 0.1) < 1e-3));
  const place = frame.bodies.indexOf(wanted);
  assert.equal(body.contacts.length, frame.contacts.filter(({ first, second }) => first === place || second === place).length);
  assert.match(await page.$eval('#card', (card) => card.textContent), new RegExp(`Floe ${found.id}.*Mass.*Thickness.*Speed`, 's'));
  const legend = () => page.$eval('#legend', (box) => box.textContent);
  assert.match(await legend(), /mooring line.*fairlead or anchor.*picked/);
  await page.keyboard.press('Escape');
  assert.equal(await page.evaluate(() => window.nilas.state().picked), null);
  assert.doesNotMatch(await legend(), /picked/);
  assert.deepEqual(faults, []);
  await page.close();
});

check('time moves by slider, keys, buttons, play and a click in a graph', async () => {
  const { page, faults } = await open(write('time', replay.bytes));
  const frame = () => page.evaluate(() => window.nilas.frame), rest = () => new Promise((resolve) => setTimeout(resolve, 300));
  await page.keyboard.press('ArrowRight');
  await rest();
  assert.equal(await frame(), 1);
  await page.keyboard.press('End');
  await rest();
  assert.equal(await frame(), 39);
  await page.keyboard.press('ArrowLeft');
  await rest();
  assert.equal(await frame(), 38);
  await page.$eval('#controls input', (slider) => {
    slider.value = 2.01;
    slider.dispatchEvent(new Event('input'));
  });
  await rest();
  assert.equal(await frame(), 20);
  const plot = await page.$('.chart .u-over'), box = await plot.boundingBox();
  await page.mouse.click(box.x + 0.25 * box.width, box.y + 20);
  await rest();
  assert.ok(Math.abs(await frame() - 10) <= 1, `frame ${await frame()}`);
  await page.keyboard.press('Space');
  await page.waitForFunction(() => window.nilas.time > 1.6, { timeout: 60000 });
  await page.keyboard.press('Space');
  await rest();
  const at = await frame();
  await rest();
  assert.equal(await frame(), at);
  await page.keyboard.press('?');
  assert.equal(await page.$eval('#help', (help) => help.open), true);
  await page.keyboard.press('Escape');
  assert.deepEqual(faults, []);
  await page.close();
});

check('between two frames bodies are half way', async () => {
  const { page } = await open(write('between', replay.bytes));
  const places = await page.evaluate(async () => {
    const image = async (t, between) => {
      await window.nilas.seek(t, { between });
      return window.nilas.capture();
    };
    return [await image(1.0, false), await image(1.05, false), await image(1.05, true), await image(1.1, false)];
  });
  assert.equal(places[0], places[1]);
  assert.equal(new Set(places).size, 3);
  await page.close();
});

check('the legend and the card of what is picked never lie on each other', async () => {
  const { page, faults } = await open(write('corner', replay.bytes), { width: 900, height: 460 });
  await page.evaluate(() => window.nilas.seek(2).then(() => window.nilas.pick(12)));
  for (const [width, height, graphs] of [[900, 460, false], [760, 520, true], [1280, 800, true], [375, 720, false]]) {
    await page.setViewport({ width, height });
    await page.evaluate((shown) => window.nilas.set('graphs', shown), graphs);
    const [card, legend] = await page.evaluate(() => ['card', 'legend'].map((id) => {
      const box = document.getElementById(id).getBoundingClientRect();
      return { top: box.top, bottom: box.bottom, height: box.height };
    }));
    const where = `${width} x ${height}: ${JSON.stringify([card, legend])}`;
    assert.ok(card.height >= 50 && (legend.height === 0 || card.bottom <= legend.top), where);
    assert.equal(legend.height > 0, width > 700, where); // small screens show one of the two
  }
  assert.deepEqual(faults, []);
  await page.close();
});

check('on a phone nothing lies over the picture until it is asked for', async () => {
  const { page, faults } = await open(write('phone', replay.bytes), { width: 375, height: 720, isMobile: true });
  const layout = () => page.evaluate(() => ({
    wide: document.documentElement.scrollWidth, panel: document.getElementById('panel').hidden, dock: document.getElementById('dock').hidden,
    picture: document.querySelector('canvas').getBoundingClientRect().height,
    beyond: [...document.querySelectorAll('#facts *, #controls *')].filter((e) => e.getBoundingClientRect().right > 376).length,
  }));
  let now = await layout();
  assert.deepEqual([now.wide, now.panel, now.dock, now.beyond], [375, true, true, 0]);
  assert.ok(now.picture > 400, `the picture is ${now.picture} pixels high`);
  await page.evaluate(() => window.nilas.seek(2).then(() => window.nilas.pick(12)));
  const card = await page.$eval('#card', (box) => box.getBoundingClientRect().height);
  assert.ok(card > 50 && card < now.picture / 3, `the card is ${card} pixels high`);
  assert.match(await page.$eval('#facts', (facts) => facts.textContent), /Ice load.*N astern.*Points \+ pairs\d+ \+ \d+/);
  await page.evaluate(() => {
    window.nilas.set('panel', true);
    window.nilas.set('graphs', true);
  });
  now = await layout();
  assert.deepEqual([now.wide, now.panel, now.dock], [375, false, false]);
  await page.setViewport({ width: 1280, height: 800 });
  assert.equal((await layout()).wide, 1280);
  assert.deepEqual(faults, []);
  await page.close();
});

check('a replay that was cut is shown as far as it goes, and the page says so', async () => {
  const { page, faults } = await open(write('cut', replay.bytes.subarray(0, Math.floor(0.6 * replay.bytes.length))));
  const count = await page.evaluate(() => window.nilas.frameCount);
  assert.ok(count > 5 && count < 40, `${count} frames`);
  assert.match((await page.evaluate(() => window.nilas.notices)).join(), /ends in the middle of a piece/);
  assert.deepEqual(faults, []);
  await page.close();
});

check('a replay that cannot be shown gives a sentence', async () => {
  const other = Buffer.from(replay.bytes);
  other[7] = '9'.charCodeAt(0);
  const damaged = Buffer.from(replay.bytes);
  damaged.fill(0, Math.floor(0.5 * damaged.length), Math.floor(0.5 * damaged.length) + 4000);
  const cases = [['version', other, /has version 9, and this page reads version 4/], ['noise', Buffer.from('not a replay'), /not a replay of Nilas/],
                 ['empty', Buffer.from('NILASRP4'), /no frames/]];
  for (const [name, bytes, wanted] of cases) {
    const { page } = await open(write(name, bytes), { waits: false });
    await page.waitForSelector('#stage .message');
    assert.match(await page.$eval('#stage .message', (message) => message.textContent), wanted);
    await page.close();
  }
  const { page } = await open(write('damaged', damaged));
  assert.match((await page.evaluate(() => window.nilas.notices)).join(), /could not be read/);
  await page.close();
});

check('an unknown kind of piece and an unknown option are named', async () => {
  const bytes = Buffer.concat([replay.bytes, piece('Q', { later: true })]);
  const { page } = await open(write('unknown', bytes) + '#colour=x&view=nowhere');
  const notices = (await page.evaluate(() => window.nilas.notices)).join(' ');
  assert.match(notices, /does not know: Q/);
  assert.match(notices, /no option "colour"/);
  assert.match(notices, /"view" cannot be "nowhere"\. Allowed: scene, bow, side, top, stern/);
  await page.close();
});

check('a scene without water, vessel, tank, contacts and channels is shown', async () => {
  const { ReplayWriter } = await import('./replay_writer.mjs'), { prism } = await import('./shapes.mjs');
  const writer = new ReplayWriter();
  writer.head({ scene: 'bare', every: 0.5, until: 1, water_level: null, tank: null, view: { camera_distance: 5, target: [0, 0, 0] }, channels: [], contacts: 'none', damage: false, hull: null });
  writer.shapes([prism(1, [[-1, -1], [1, -1], [1, 1], [-1, 1]], 0.5)]);
  for (let i = 0; i < 3; ++i) {
    const floe = { id: 7, kind: 0, shape: 1, fixed: false, thickness: 0.5, mass: 1, p: [0, 0, 0.1 * i], q: [1, 0, 0, 0], speed: 0.2 };
    writer.frame({ time: 0.5 * i, step: i, stepLength: 0.5, unit: 1e-4, bodies: [floe, { ...floe, id: 8, kind: 3, shape: null, fixed: true }] });
  }
  const { page, faults } = await open(write('bare', writer.bytes()));
  assert.equal((await page.evaluate(() => window.nilas.state())).bodies, 1);
  assert.deepEqual(faults, []);
  await page.close();
});

check('all of 100 000 contacts in a frame are drawn, and the largest forces', async () => {
  const { ReplayWriter } = await import('./replay_writer.mjs'), { prism } = await import('./shapes.mjs');
  const writer = new ReplayWriter(), count = 100000;
  writer.head({ scene: 'many', every: 1, until: 1, water_level: 0, tank: null, view: null, channels: [], contacts: 'all', damage: false, hull: null });
  writer.shapes([prism(1, [[-1, -1], [1, -1], [1, 1], [-1, 1]], 0.5)]);
  const floe = (id, x) => ({ id, kind: 0, shape: 1, fixed: false, thickness: 0.5, mass: 1, p: [x, 0, 0], q: [1, 0, 0, 0], speed: 0 });
  const contacts = Array.from({ length: count }, (_, i) => ({ status: i % 4, exact: true, stored: true, first: i % 2, second: 1 - i % 2,
    p: [1, (i % 300) / 150 - 1, Math.floor(i / 300) / 1000], n: [1, 0, 0], force: [1 + i % 7, 0, 0] }));
  const bodies = [floe(1, 0), floe(2, 2)];
  writer.frame({ time: 0, step: 0, stepLength: 1, unit: 1e-4, bodies, contacts: contacts.slice(0, 1) });
  writer.frame({ time: 1, step: 1, stepLength: 1, unit: 1e-4, bodies, contacts });
  const { page, faults } = await open(write('many', writer.bytes()), { width: 320, height: 240 });
  const { numbers, least, frameMs, legend } = await page.evaluate(async () => {
    const { frameMs: mean } = await window.nilas.measure(2), { contacts: points, crushed, arrows } = window.nilas.state();
    return { numbers: [points, crushed, arrows.length], least: Math.min(...arrows.map(({ force }) => Math.abs(force[0]))), frameMs: 2 * mean,
             legend: document.getElementById('legend').textContent };
  });
  assert.deepEqual(numbers, [count, count / 4, 20000]);
  assert.equal(least, 6, 'forces are 1 to 7 N in turn, so those of 6 and 7 N are more than 20 000');
  assert.match(legend, /the 20000 largest of 100000 forces/);
  assert.ok(frameMs > 0);
  console.log(`a frame with ${count} contacts takes ${Math.round(frameMs)} ms at 320 x 240`);
  assert.deepEqual(faults, []);
  await page.close();
});
