import { el } from '../ui/dom.js';
import { addCopyButtons } from './copy.js';
import { FrontPlot, frontKey } from './front.js';
import { listenToRows, markRows } from './rows.js';
import { Tip } from './tip.js';

const data = JSON.parse(document.getElementById('plots-data')?.textContent ?? '[]');
const tip = new Tip(), plots = [];
let picked = null;

/** Picks a setting in the plots and tables; the same one again lets go. */
function pick(setting, goes = true) {
  picked = picked === setting ? null : setting;
  for (const plot of plots) plot.pick(picked);
  markRows(picked, goes && picked !== null);
}

/** The picture for papers stands behind a fold where there is one to point at. */
function foldPicture(name) {
  const picture = document.getElementById(`picture-${name}`);
  if (!picture) return null;
  const fold = el('details', {}, el('summary', {}, `The same picture for papers: ${name}.svg and ${name}.png`));
  fold.append(picture);
  return fold;
}

for (const plot of data) {
  const box = el('div', { class: 'plot' });
  const figure = el('figure', { class: 'front', id: `plot-${plot.name}` }, el('h3', {}, plot.title), el('div', { class: 'beside' }, box, frontKey(plot, pick)),
                    el('figcaption', {}, plot.caption), foldPicture(plot.name));
  document.getElementById('plots').append(figure);
  plots.push(new FrontPlot(box, plot, { pick, hover: (point, x, y) => (point ? tip.show(point, x, y) : tip.hide()) }));
}
window.addEventListener('scroll', () => plots.forEach((plot) => plot.hover(null)), { passive: true });
listenToRows(pick);
addCopyButtons();
/** For tests and scripts. */
window.nilas = { plots, pick, get picked() { return picked; } };
