/** What a user does on a page, for tests of several pages. */

/**
 * Turns every switch of the panel and back. Returns for each whether its values change the picture or the page.
 * @returns {Promise<Record<string, boolean[]>>}
 */
export function turnSwitches(page) {
  return page.evaluate(() => {
    const { nilas } = window, result = {};
    const read = () => ({ image: nilas.capture(), calls: nilas.stats().drawCalls, page: document.getElementById('page').innerHTML.length });
    for (const [name, value] of Object.entries(nilas.options())) {
      const input = document.querySelector(`[data-option="${name}"]`);
      if (!input) continue;
      const values = input.type === 'checkbox' ? [!value] : input.type === 'range' ? [3] : [...input.options].map((o) => o.value).filter((v) => v !== value);
      const before = read();
      result[name] = values.map((v) => {
        nilas.set(name, v);
        const now = read();
        return Object.keys(now).some((key) => now[key] !== before[key]);
      });
      nilas.set(name, value);
    }
    return result;
  });
}

/**
 * A floe that is seen on the screen, and where: {id, x, y}; null for none. Floes have identities from `least` on. On a busy
 * machine the parts of the page move with a delay, so it is sought again for some seconds.
 */
export async function floeOnScreen(page, least) {
  for (let left = 20; left > 0; --left) {
    const found = await seekFloe(page, least);
    if (found) return found;
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  return null;
}

function seekFloe(page, least) {
  return page.evaluate((leastId) => {
    const box = document.querySelector('canvas').getBoundingClientRect();
    for (let y = box.top + 30; y < box.bottom - 30; y += 9) {
      for (let x = box.left + 20; x < box.right - 20; x += 9) {
        if (document.elementFromPoint(x, y)?.tagName !== 'CANVAS') continue;
        const id = window.nilas.pickAt(x, y);
        if (id !== null && id >= leastId) {
          window.nilas.pick(null);
          return { id, x, y };
        }
      }
    }
    return null;
  }, least);
}
