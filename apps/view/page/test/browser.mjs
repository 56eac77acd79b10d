/** Starts the browser for the tests, and watches what a page does. */
import { existsSync, readdirSync, readFileSync } from 'node:fs';

export const CHROMIUM = process.env.CHROMIUM || '/usr/bin/chromium';

/**
 * Why the browser tests cannot run, null if they can. They fail then, unless NILAS_PAGE_TESTS_MAY_SKIP is 1.
 * @returns {Promise<string|null>}
 */
export async function whyNoBrowser() {
  if (!existsSync(CHROMIUM)) return `There is no browser at ${CHROMIUM}. Install chromium, or name one in CHROMIUM.`;
  try {
    await import('puppeteer-core');
  } catch {
    return 'The package puppeteer-core is missing. Run npm ci in apps/view/page.';
  }
  return null;
}

/** A browser that draws by software. It is patient, since a busy machine may stop it for a while. */
export async function startBrowser() {
  const { default: puppeteer } = await import('puppeteer-core');
  return puppeteer.launch({ executablePath: CHROMIUM, headless: true, args: ['--no-sandbox', '--use-angle=swiftshader',
    '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', '--disable-dev-shm-usage', '--hide-scrollbars',
    '--disable-gpu-watchdog', '--disable-hang-monitor', '--disable-extensions', '--disable-background-networking'], timeout: 120000,
    protocolTimeout: 600000 });
}

/** The processor time that the browser has used so far, over all its processes and threads [ms]. Linux only. */
export function processorTime(browser) {
  const stats = new Map();
  for (const name of readdirSync('/proc').filter((n) => /^\d+$/.test(n))) {
    try {
      const fields = readFileSync(`/proc/${name}/stat`, 'latin1').replace(/^.*\) /, '').split(' ');
      stats.set(Number(name), { parent: Number(fields[1]), ticks: Number(fields[11]) + Number(fields[12]) });
    } catch {
      // The process has ended meanwhile.
    }
  }
  const isOurs = (pid) => pid === browser.process().pid || (stats.has(pid) && isOurs(stats.get(pid).parent));
  let ticks = 0;
  for (const [pid, stat] of stats) if (isOurs(pid)) ticks += stat.ticks;
  return 10 * ticks;
}

/** A new page. The library waits for half a minute, which is too short on a very busy machine. */
async function newPage(browser) {
  for (let left = 3;; --left) {
    try {
      return await browser.newPage();
    } catch (error) {
      if (left === 0 || !/Timed out/.test(error.message)) throw error;
    }
  }
}

/**
 * Opens a page. `faults` collects errors of its console and scripts; `requests` those that go beyond its own file or server.
 * @param {import('puppeteer-core').Browser} browser
 */
export async function openPage(browser, address, { width = 1280, height = 800, isMobile = false, waits = true } = {}) {
  const page = await newPage(browser), faults = [], requests = [];
  page.setDefaultTimeout(120000);
  await page.setViewport({ width, height, isMobile, hasTouch: isMobile });
  page.on('console', (message) => {
    if (['error', 'warn'].includes(message.type()) && !isAboutDriver(message.text())) faults.push(message.text());
  });
  page.on('pageerror', (error) => faults.push(String(error)));
  const origin = new URL(address).protocol === 'file:' ? address.split('#')[0] : new URL(address).origin;
  page.on('request', (request) => {
    const url = request.url();
    if (!url.startsWith(origin) && !url.startsWith('data:') && !url.startsWith('blob:')) requests.push(url);
  });
  await page.goto(address, { timeout: 120000 });
  if (waits) await page.evaluate(() => window.nilas.ready);
  return { page, faults, requests };
}

/** The browser's own remarks on slow reading from its software renderer are no fault of the page. */
const isAboutDriver = (text) => /GPU stall due to ReadPixels|Automatic fallback to software WebGL/.test(text);
