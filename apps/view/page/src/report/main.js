import 'uplot/dist/uPlot.min.css';
import { drawHullMap } from './hull_map.js';
import { HullStage } from './hull_stage.js';
import { Plots } from './plots.js';
import { onTheme } from './theme.js';
import { el } from '../ui/dom.js';

/** The hull in 3-D, drawn when it comes into sight, since a browser takes long to begin with WebGL. */
class LateHull {
  #stage = null;
  #hasFailed = false;

  constructor(box, hull) {
    Object.assign(this, { box, hull });
    new IntersectionObserver((seen) => { if (seen.some(({ isIntersecting }) => isIntersecting)) this.stage; }).observe(box);
  }

  /** Draws it if need be. Null where the browser cannot. */
  get stage() {
    if (this.#stage || this.#hasFailed) return this.#stage;
    try {
      this.#stage = new HullStage(this.box, this.hull);
    } catch {
      this.#hasFailed = true;
      this.box.append(el('p', {}, "The browser has no WebGL, so the hull cannot be drawn in 3-D. Allow it in the browser's settings."));
    }
    return this.#stage;
  }

  get isDrawn() { return this.#stage !== null; }
}

function main() {
  const data = JSON.parse(document.getElementById('report-data').textContent);
  const plots = new Plots(data.plots), box = document.getElementById('hull-stage');
  const late = data.hull && box ? new LateHull(box, data.hull) : null;
  if (late) drawHullMap(document.getElementById('hull-map'), data.hull);
  onTheme(() => {
    plots.redraw();
    if (late?.isDrawn) late.stage.repaint();
  });
  window.addEventListener('beforeprint', () => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    late?.stage?.freeze();
  });
  window.addEventListener('afterprint', () => late?.stage?.thaw());
  // Tests and scripts see what is drawn.
  window.nilasReport = { plots, get stage() { return late?.stage ?? null; } };
}

main();
