import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { openPage, startBrowser, whyNoBrowser } from './browser.mjs';
import { fillPage } from './fill_page.mjs';
import { Scene } from './make_replay.mjs';
import { ship } from './shapes.mjs';
import { piece } from './replay_writer.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const missing = await whyNoBrowser();
if (missing && process.env.NILAS_PAGE_TESTS_MAY_SKIP !== '1') throw new Error(missing);

/** A run that serves its page: frames come on request, and a viewer gets all from the start. */
class Run {
  commands = [];
  /** Answers to commands wait for this. */
  answering = Promise.resolve();
  viewers = new Set();
  token = 'secret';

  constructor(template) {
    this.scene = new Scene({ floes: 20, hasWaves: false });
    this.scene.writer.head(this.scene.head());
    this.scene.writer.shapes(ship(1, { length: 6, breadth: 1.3, depth: 0.75, draught: 0.35 }));
    this.next = 0;
    const page = fillPage(template, new Uint8Array(0), { title: 'A live run', live: true, token: this.token });
    this.server = createServer((request, response) => this.#answer(request, response, page));
  }

  listen() { return new Promise((resolve) => this.server.listen(0, '127.0.0.1', () => resolve(`http://127.0.0.1:${this.server.address().port}/`))); }

  #answer(request, response, page) {
    const url = new URL(request.url, 'http://localhost');
    if (url.pathname === '/') return response.setHeader('Content-Type', 'text/html').end(page);
    if (url.searchParams.get('token') !== this.token) return response.writeHead(403, 'Forbidden').end();
    if (url.pathname === '/events') {
      response.writeHead(200, { 'Content-Type': 'application/octet-stream' });
      for (const part of this.scene.writer.parts) response.write(part);
      this.viewers.add(response);
      return request.on('close', () => this.viewers.delete(response));
    }
    let body = '';
    request.on('data', (chunk) => { body += chunk; });
    return request.on('end', async () => {
      this.commands.push({ method: request.method, path: url.pathname, ...JSON.parse(body) });
      await this.answering;
      response.writeHead(204).end();
    });
  }

  #send(bytes) { for (const viewer of this.viewers) viewer.write(bytes); }

  advance(count) {
    for (let i = 0; i < count; ++i) {
      const from = this.scene.writer.parts.length;
      this.scene.step(this.next++);
      for (const part of this.scene.writer.parts.slice(from)) this.#send(part);
    }
  }

  state(state) { this.#send(piece('L', state)); }
  end() {
    this.#send(this.scene.writer.add('E', { reason: 'The run reached its end.' }));
    for (const viewer of this.viewers) viewer.end();
  }

  drop() { for (const viewer of this.viewers) viewer.destroy(); }
}

const check = (name, body) => test(name, { skip: missing ?? false, timeout: 300000 }, body);

let folder, browser, template, run, address;
before(async () => {
  if (missing) return;
  folder = mkdtempSync(join(tmpdir(), 'nilas-live-'));
  execFileSync('node', [join(here, '../build.mjs'), folder]);
  template = readFileSync(join(folder, 'page.html'), 'utf8');
  browser = await startBrowser();
  run = new Run(template);
  address = await run.listen();
});
after(async () => {
  await browser?.close();
  run?.drop();
  run?.server.close();
  if (folder) rmSync(folder, { recursive: true });
});
// A page in the background draws no pictures, so conditions are not asked for at each picture.
const until = (page, condition, ...values) => page.waitForFunction(condition, { timeout: 120000, polling: 100 }, ...values);
const count = (page) => page.evaluate(() => window.nilas.frameCount);
const waitForFrames = (page, n) => until(page, (k) => window.nilas.frameCount === k, n);
const press = (page, label) => page.evaluate((text) => [...document.querySelectorAll('#controls button')].find((b) => b.textContent === text).click(), label);

const says = (page, text) => until(page, (wanted) => window.nilas.notices.some((notice) => notice.includes(wanted)), text);

check('two pages follow a run, and one of them looks back', async () => {
  run.advance(3);
  const { page, faults, requests } = await openPage(browser, address), other = await openPage(browser, address);
  assert.equal(await count(page), 3);
  run.advance(5);
  await waitForFrames(page, 8);
  await waitForFrames(other.page, 8);
  await until(page, () => window.nilas.frame === 7);
  await page.keyboard.press('Home');
  await until(page, () => window.nilas.frame === 0);
  run.advance(4);
  await waitForFrames(page, 12);
  await until(other.page, () => window.nilas.frame === 11);
  assert.equal(await page.evaluate(() => window.nilas.frame), 0, 'a user who looks back is not pulled on');
  await press(page, 'Live');
  await until(page, () => window.nilas.frame === 11);
  await page.evaluate(() => window.nilas.seekFrame(2));
  run.advance(2);
  await waitForFrames(page, 14);
  await until(other.page, () => window.nilas.frame === 13);
  assert.equal(await page.evaluate(() => window.nilas.frame), 2, 'nor is a script that seeks');
  assert.deepEqual([...faults, ...other.faults], []);
  assert.deepEqual([...requests, ...other.requests], []);
  await page.close();
  await other.page.close();
});

check('its buttons steer the run, and show what others did', async () => {
  run.advance(2);
  const { page, faults } = await openPage(browser, address), hasResume = () => until(page, () =>
    [...document.querySelectorAll('#controls button')].some((b) => b.textContent === 'Resume the run'));
  const told = async (number) => {
    for (let k = 0; k < 100 && run.commands.length < number; ++k) await new Promise((resolve) => setTimeout(resolve, 50));
    return run.commands.map(({ method, path, action, factor }) => [method, path, action, factor]);
  };
  await press(page, 'Pause the run');
  await hasResume();
  await press(page, 'Step');
  await told(2);
  await press(page, 'Resume the run');
  await told(3);
  await page.select('#controls .run select', '0.2');
  assert.deepEqual(await told(4), [['POST', '/control', 'pause', undefined], ['POST', '/control', 'step', undefined],
                                   ['POST', '/control', 'resume', undefined], ['POST', '/control', 'slow', 0.2]]);
  let answer;
  run.answering = new Promise((resolve) => { answer = resolve; });
  await press(page, 'Step');
  await told(5);
  await page.keyboard.press('Home');
  await until(page, () => window.nilas.frame === 0);
  answer();
  await hasResume();
  assert.equal(await page.evaluate(() => window.nilas.frame), 0, 'an answer that comes late pulls no user on');
  run.state({ paused: true, factor: 0.5 });
  await until(page, () => document.querySelector('#controls .run select').value === '0.5');
  await hasResume();
  assert.equal(await page.$eval('#controls .run select', (select) => select.value), '0.5');
  assert.deepEqual(faults, []);
  await page.close();
});

check('it connects again, says when the run ended, and can then still be moved', async () => {
  run.advance(2);
  const { page, faults } = await openPage(browser, address), before = await count(page);
  // The notice goes as soon as the page is connected again, so it is watched.
  await page.evaluate(() => {
    window.seen = '';
    new MutationObserver(() => { window.seen += document.getElementById('notices').textContent; }).observe(document.getElementById('notices'), { childList: true });
  });
  run.drop();
  await until(page, () => window.seen.includes('connection to the run was lost'));
  run.advance(2);
  await waitForFrames(page, before + 2);
  await until(page, () => !window.nilas.notices.some((text) => text.includes('was lost')));
  await until(page, (last) => window.nilas.frame === last, before + 1);
  run.end();
  await says(page, 'The run reached its end.');
  await page.evaluate(() => window.nilas.seekFrame(2));
  assert.equal(await page.evaluate(() => window.nilas.frame), 2);
  // A stream that breaks off is a fault for the browser's console, and meant here.
  assert.deepEqual(faults.filter((text) => !text.includes('net::ERR')), []);
  await page.close();
});

check('a wrong token is refused in plain words', async () => {
  const refused = new Run(template);
  const place = await refused.listen();
  refused.token = 'another';
  const { page } = await openPage(browser, place, { waits: false });
  await until(page, () => window.nilas.notices.some((text) => /The run refused the page \(403/.test(text)));
  await page.close();
  refused.server.close();
});
