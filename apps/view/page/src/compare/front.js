import { el } from '../ui/dom.js';
import { formatRound } from '../ui/format.js';
import { placeLabels } from './labels.js';
import { logScale, svg } from './svg.js';

/** The ring around the recommended setting [pixels]. */
const RING = 10;
const MARGIN = { left: 58, right: 12, top: 10, bottom: 44 };
/** A pointer farther from every mark points at none [pixels]. */
const NEAR = 24;
const RANK = { best: 1, chance: 2, beaten: 3 };
const KEYS = [['best', 'none is both faster and better'], ['beaten', 'another is faster and better, or it failed'],
              ['chance', 'not significant: the error is below this']];

const rankOf = (point) => (point.chosen ? 0 : RANK[point.kind]);

/**
 * Computing time against error, a mark for each setting.
 * @param {HTMLElement} box that it fills
 * @param {object} data of the page, see front_view.cpp
 * @param {{hover: (point: object|null, x: number, y: number) => void, pick: (setting: number) => void}} actions
 */
export class FrontPlot {
  #box;
  #data;
  #actions;
  #marks = new Map();
  #runs = null;
  #picked = null;

  constructor(box, data, actions) {
    this.#box = box;
    this.#data = data;
    this.#actions = actions;
    // Important marks are drawn last, above the others, and get their labels first.
    this.points = [...data.points].sort((a, b) => rankOf(a) - rankOf(b) || a.setting - b.setting);
    new ResizeObserver(() => this.draw()).observe(box);
    this.draw();
  }

  draw() {
    const width = Math.max(this.#box.clientWidth, 240), height = Math.round(Math.min(Math.max(0.62 * width, 300), 460));
    if (width === this.width) return;
    this.width = width;
    const { x, y } = this.#data;
    this.frame = { left: MARGIN.left, right: width - MARGIN.right, top: MARGIN.top, bottom: height - MARGIN.bottom };
    this.x = logScale(x.low, x.high, this.frame.left, this.frame.right);
    this.y = logScale(y.low, y.high, this.frame.bottom, this.frame.top);
    this.#runs = svg('g', { class: 'runs' });
    this.picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, width, height, role: 'group', 'aria-label': this.#data.title,
                                pointermove: (event) => this.#point(event), pointerleave: () => this.hover(null),
                                click: (event) => this.#click(event) },
                       ...this.#axes(height), this.#referenceLine(), this.#runs, ...this.#drawMarks(), ...this.#labels());
    this.#box.replaceChildren(this.picture);
    if (this.#picked !== null) this.pick(this.#picked);
  }

  #axes(height) {
    const { left, right, top, bottom } = this.frame, { x, y } = this.#data, parts = [];
    let last = -Infinity;
    for (const tic of x.tics) {
      const at = this.x(tic), text = formatRound(tic);
      if (at < left || at > right) continue;
      parts.push(svg('line', { class: 'grid', x1: at, x2: at, y1: top, y2: bottom }));
      if (at - last < 8 * text.length) continue;
      last = at;
      parts.push(svg('text', { class: 'tic', x: at, y: bottom + 16, 'text-anchor': 'middle' }, text));
    }
    for (const tic of y.tics) {
      const at = this.y(tic);
      if (at < top || at > bottom) continue;
      parts.push(svg('line', { class: 'grid', x1: left, x2: right, y1: at, y2: at }),
                 svg('text', { class: 'tic', x: left - 6, y: at + 4, 'text-anchor': 'end' }, formatRound(tic)));
    }
    const middle = (top + bottom) / 2;
    return [...parts, svg('rect', { class: 'frame', x: left, y: top, width: right - left, height: bottom - top }),
            svg('text', { class: 'axis', x: (left + right) / 2, y: height - 8, 'text-anchor': 'middle' }, x.label),
            svg('text', { class: 'axis', x: 0, y: 0, 'text-anchor': 'middle', transform: `translate(12 ${middle}) rotate(-90)` }, y.label)];
  }

  #referenceLine() {
    const { reference_moves: moves } = this.#data;
    if (!moves) return null;
    return svg('line', { class: 'moves', x1: this.frame.left, x2: this.frame.right, y1: this.y(moves), y2: this.y(moves) });
  }

  #drawMarks() {
    this.#marks.clear();
    return [...this.points].reverse().map((point) => {
      const x = this.x(point.time), y = this.y(point.error), { time_low: fast, time_high: slow, error_low: low, error_high: high } = point;
      const mark = svg('g', { class: `mark ${point.kind}${point.chosen ? ' chosen' : ''}`, tabindex: 0, role: 'button',
                              'aria-label': `Setting ${point.setting}: ${point.label}`, 'data-setting': point.setting,
                              focus: () => this.hover(point), blur: () => this.hover(null),
                              keydown: (event) => { if (event.key === 'Enter') this.#actions.pick(point.setting); } },
                       slow > fast ? svg('line', { x1: this.x(fast), x2: this.x(slow), y1: y, y2: y }) : null,
                       high > low ? svg('line', { x1: x, x2: x, y1: this.#inside(this.y(low)), y2: this.#inside(this.y(high)) }) : null,
                       point.chosen ? svg('circle', { class: 'ring', cx: x, cy: y, r: RING }) : null, shapeOf(point.kind, x, y));
      this.#marks.set(point.setting, mark);
      return mark;
    });
  }

  #inside(y) { return Math.min(Math.max(y, this.frame.top), this.frame.bottom); }

  #labels() {
    const marks = this.points.map((point) => {
      const x = this.x(point.time), y = this.y(point.error);
      return { x, y, ...(point.chosen ? { radius: RING + 1 } : {}), text: String(point.setting), bars: [
        { left: this.x(point.time_low), right: this.x(point.time_high), top: y - 1, bottom: y + 1 },
        { left: x - 1, right: x + 1, top: this.#inside(this.y(point.error_high)), bottom: this.#inside(this.y(point.error_low)) }] };
    });
    this.labels = placeLabels(marks, this.frame);
    return this.labels.map((label, k) => {
      const { x, y } = marks[k];
      return svg('g', { class: `label ${this.points[k].chosen ? 'best' : this.points[k].kind}`, 'data-setting': this.points[k].setting },
                 label.isFar ? svg('line', { x1: x, y1: y, x2: label.end[0], y2: label.end[1] }) : null,
                 svg('text', { x: label.x, y: label.y + 4.5, 'text-anchor': 'middle' }, marks[k].text));
    });
  }

  /** Where the mark of a point is, on the screen. */
  placeOf(point) {
    const box = this.picture.getBoundingClientRect();
    return [box.left + this.x(point.time), box.top + this.y(point.error)];
  }

  /** The mark nearest to a place on the screen, null if none is near. */
  nearest(clientX, clientY) {
    let best = null, least = NEAR;
    for (const point of this.points) {
      const [x, y] = this.placeOf(point), distance = Math.hypot(x - clientX, y - clientY);
      if (distance < least) [best, least] = [point, distance];
    }
    return best;
  }

  #point(event) { this.hover(this.nearest(event.clientX, event.clientY)); }

  #click(event) {
    const point = this.nearest(event.clientX, event.clientY);
    this.hover(point);
    if (point) this.#actions.pick(point.setting);
  }

  /** Shows a setting's runs and figures; null for none. */
  hover(point) {
    if (this.hovered === point) return;
    this.hovered = point;
    for (const [setting, mark] of this.#marks) mark.classList.toggle('hovered', setting === point?.setting);
    this.#runs.replaceChildren(...(point ? this.#runMarks(point) : []));
    this.#actions.hover(point, ...(point ? this.placeOf(point) : [0, 0]));
  }

  #runMarks(point) {
    const { left, right, top, bottom } = this.frame, x = this.x(point.time), y = this.y(point.error), parts = [];
    for (const run of point.runs) {
      if (!(run.time > 0) || !(run.error > 0)) continue;
      const at = [this.x(run.time), this.y(run.error)];
      if (at[0] < left || at[0] > right || at[1] < top || at[1] > bottom) continue;
      parts.push(svg('line', { x1: x, y1: y, x2: at[0], y2: at[1] }), svg('circle', { cx: at[0], cy: at[1], r: 3.5 }));
    }
    return parts;
  }

  /** Marks the setting that was picked. */
  pick(setting) {
    this.#picked = setting;
    for (const [number, mark] of this.#marks) mark.classList.toggle('picked', number === setting);
  }
}

function shapeOf(kind, x, y) {
  if (kind === 'chance') return svg('path', { class: 'shape', d: `M${x - 5} ${y - 4}h10l-5 9z` });
  return svg('circle', { class: 'shape', cx: x, cy: y, r: kind === 'best' ? 4.5 : 3.5 });
}

/** What the marks mean, and the names of the settings that none beats. */
export function frontKey(data, pick) {
  const kinds = el('ul', { class: 'kinds' });
  const add = (mark, text) => {
    const sample = svg('svg', { width: 26, height: 16, class: 'sample' });
    sample.append(...mark);
    const item = el('li', {}, text);
    item.prepend(sample);
    kinds.append(item);
  };
  if (data.points.some((point) => point.chosen)) add([svg('g', { class: 'mark chosen' }, svg('circle', { class: 'ring', cx: 13, cy: 8, r: 6 }))], 'recommended');
  for (const [kind, text] of KEYS) {
    if (data.points.some((point) => point.kind === kind)) add([svg('g', { class: `mark ${kind}` }, shapeOf(kind, 13, 8))], text);
  }
  if (data.reference_moves) add([svg('line', { class: 'moves', x1: 0, x2: 26, y1: 8, y2: 8 })], 'change of the reference with its step');
  add([svg('g', { class: 'mark beaten' }, svg('line', { x1: 3, x2: 23, y1: 8, y2: 8 }))], `scatter of times${data.time_scatter ? ` (${data.time_scatter})` : ': not measured'}`);
  const names = el('ul', { class: 'names' });
  for (const point of data.points.filter(({ in_key: isNamed }) => isNamed)) {
    names.append(el('li', {}, el('button', { type: 'button', 'data-setting': point.setting, click: () => pick(point.setting) },
                                 el('b', {}, String(point.setting)), point.label)));
  }
  return el('div', { class: 'key' }, kinds, names);
}
