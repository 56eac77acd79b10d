import { el } from '../ui/dom.js';

const GAP = 14;

/** The card beside a mark, with the figures and the runs of its setting. */
export class Tip {
  constructor() {
    this.box = el('div', { id: 'tip', role: 'tooltip', hidden: true });
    document.body.append(this.box);
  }

  hide() { this.box.hidden = true; }

  /** Shows a point of the plot at a place on the screen. */
  show(point, x, y) {
    const facts = el('dl');
    for (const [name, value] of point.facts) facts.append(el('dt', {}, name), el('dd', {}, value));
    this.box.replaceChildren(el('h3', {}, `${point.setting}  ${point.label}`), el('p', {}, point.full), facts, ...runTable(point));
    this.box.hidden = false;
    const { offsetWidth: width, offsetHeight: height } = this.box, { clientWidth, clientHeight } = document.documentElement;
    const right = x + GAP + width < clientWidth ? x + GAP : x - GAP - width;
    this.box.style.left = `${Math.max(4, Math.min(right, clientWidth - width - 4))}px`;
    // Where there is no room beside the mark, the card goes above or below it.
    const isBeside = right >= 0;
    const top = isBeside ? y - height / 2 : y + GAP + height < clientHeight ? y + GAP : y - GAP - height;
    this.box.style.top = `${Math.max(4, Math.min(top, clientHeight - height - 4))}px`;
  }
}

function runTable({ runs, run_unit: unit }) {
  if (runs.length === 0) return [];
  const table = el('table', {}, el('tr', {}, ...['realisation', 'time [s/s]', `difference [${unit}]`].map((title) => el('th', {}, title))));
  for (const run of runs) {
    table.append(run.status === 'done' ? el('tr', {}, el('td', {}, String(run.realisation)), el('td', {}, run.time_text), el('td', {}, run.error_text))
                                       : el('tr', {}, el('td', {}, String(run.realisation)), el('td', { colspan: 2 }, run.status)));
  }
  return [table];
}
