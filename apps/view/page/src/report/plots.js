import uPlot from 'uplot';
import { isNarrow } from '../ui/dom.js';
import { formatRound } from '../ui/format.js';
import { styleOf } from './theme.js';

const HEIGHT = 270, HEIGHT_NARROW = 230, COLOURS = 12;
/** A logarithmic axis shows at most so many decades below the largest value. */
const DECADES = 8;

/** The colour of the k-th curve, opaque or as that of its range. */
const colourOf = (k) => styleOf(`curve-${k % COLOURS}`);
const withAlpha = (colour, alpha) => `${colour}${Math.round(255 * alpha).toString(16).padStart(2, '0')}`;

/** A curve as columns over ascending x, as uPlot needs them. */
function columnsOf({ x, y, low, high }, hasRange) {
  const order = x.map((_, i) => i);
  if (x.length > 1 && x[0] > x[x.length - 1]) order.reverse();
  const pick = (list) => order.map((i) => list[i]);
  const columns = [pick(x), pick(y)];
  if (hasRange) columns.push(pick(low), pick(high));
  return columns;
}

/** A marked value as columns: a straight line over the whole of x, with the ends of its band. */
function columnsOfLevel({ y, half_width: half }, low, high) {
  const columns = [[low, high], [y, y]];
  if (half > 0) columns.push([y - half, y - half], [y + half, y + half]);
  return columns;
}

/** The series of one line and, where it has one, of its range. `first`: the number of its series. */
function seriesOf({ name, colour, dots, isSingle, steps, dash, width = 1.3, range }, first) {
  const line = { label: name, stroke: colour, width: dots ? 0 : width, dash, points: { show: Boolean(dots), size: dots && isSingle ? 9 : 4, fill: colour },
                 value: (_, value) => value == null ? '–' : formatRound(Number(value.toPrecision(4))) };
  if (steps) line.paths = uPlot.paths.stepped({ align: 1 });
  if (dots) line.paths = () => null;
  if (!range) return { series: [line], bands: [] };
  const edge = { label: '', stroke: 'transparent', width: 0, points: { show: false }, value: () => '', class: 'edge' };
  return { series: [line, edge, edge], bands: [{ series: [first + 2, first + 1], fill: range }] };
}

/** The data and the series of a plot. */
function contentOf({ curves, levels, x_label: xLabel }) {
  const tables = [], series = [{ label: xLabel, value: (_, x) => x == null ? '–' : formatRound(Number(x.toPrecision(5))) }], bands = [];
  const add = (columns, look) => {
    const made = seriesOf(look, series.length);
    tables.push(columns);
    series.push(...made.series);
    bands.push(...made.bands);
  };
  const xs = curves.flatMap(({ x }) => x.length > 0 ? [x[0], x[x.length - 1]] : []);
  for (const level of levels) {
    const columns = columnsOfLevel(level, Math.min(...xs), Math.max(...xs));
    add(columns, { name: level.name, colour: styleOf('soft'), dash: [6, 4], range: columns.length > 2 ? styleOf('band') : null });
  }
  curves.forEach((curve, k) => {
    const hasRange = curve.low.length > 0, colour = colourOf(k);
    add(columnsOf(curve, hasRange), { name: curve.name, colour, dots: curve.dots, isSingle: curve.x.length === 1, steps: curve.steps, dash: k < COLOURS ? undefined : [8, 3],
                                      range: hasRange ? withAlpha(colour, 0.25) : null });
  });
  return { data: uPlot.join(tables), series, bands };
}

/** The range of a logarithmic axis. */
function decadesOf(_, low, high) {
  return high > 0 ? uPlot.rangeLog(Math.max(low, high / 10 ** DECADES), high, 10, true) : [0.1, 1];
}

const MARGIN = 0.1;

/** The range of an axis. One of a value that never changes reaches to zero. */
function rangeOf(_, low, high) {
  if (low == null || high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high))) return uPlot.rangeNum(low ?? 0, high ?? 1, MARGIN, true);
  const end = (1 + MARGIN) * high;
  return end > 0 ? [0, end] : end < 0 ? [end, 0] : [0, 1];
}

/** The range of an axis that has this one while all of x is shown, and that of the values in sight where x is enlarged. */
function rangeOfWhole(whole, curves) {
  const xs = curves.flatMap(({ x }) => [x[0], x[x.length - 1]]), from = Math.min(...xs), to = Math.max(...xs);
  // The x of the first and the last point in sight are known before the new scale of x is.
  return ({ series: [x] }, low, high) => (x.min <= from && x.max >= to ? whole : uPlot.rangeNum(low, high, MARGIN, true));
}

/** All plots of the page. Those over the time of the run show the same stretch of it. */
export class Plots {
  #shown = [];
  #zooms = false;

  constructor(list) {
    this.list = list.filter(({ id }) => document.getElementById(`plot-${id}`));
    this.redraw();
    new ResizeObserver(() => this.#resize()).observe(document.body);
  }

  get count() { return this.#shown.length; }
  /** Names of the plots, and the stretch of x that each shows. */
  get ranges() { return Object.fromEntries(this.#shown.map(({ id, plot }) => [id, [plot.scales.x.min, plot.scales.x.max]])); }

  /** The stretch of y that each plot shows. */
  get heights() { return Object.fromEntries(this.#shown.map(({ id, plot }) => [id, [plot.scales.y.min, plot.scales.y.max]])); }

  /** Shows a stretch of x in a plot, and with it in all plots over time where it is one of them. */
  zoom(id, min, max) { this.#shown.find((shown) => shown.id === id).plot.setScale('x', { min, max }); }

  redraw() {
    for (const { plot } of this.#shown) plot.destroy();
    this.#shown = this.list.map((entry) => this.#draw(entry));
  }

  #draw(entry) {
    const box = document.getElementById(`plot-${entry.id}`), content = contentOf(entry);
    const hooks = { setScale: [(plot, key) => { if (key === 'x' && entry.over_time) this.#follow(plot); }] };
    const plot = new uPlot({ ...this.#options(entry, box.clientWidth), series: content.series, bands: content.bands, hooks }, content.data, box);
    // The ends of a range are no curves of their own.
    plot.root.querySelectorAll('.u-series.edge').forEach((row) => { row.style.display = 'none'; });
    return { id: entry.id, plot, box, overTime: entry.over_time };
  }

  #options({ x_label: xLabel, y_label: yLabel, log_x: logX, log_y: logY, y_range: range, curves }, width) {
    const axis = { stroke: styleOf('soft'), font: '12px system-ui, sans-serif', labelFont: '13px system-ui, sans-serif', labelSize: 22,
                   grid: { stroke: styleOf('grid'), width: 1 }, ticks: { stroke: styleOf('grid'), width: 1 },
                   values: (_, ticks) => ticks.map((tick) => tick == null ? '' : formatRound(tick)) };
    return {
      width: Math.max(width, 200), height: isNarrow() ? HEIGHT_NARROW : HEIGHT,
      scales: { x: { time: false, distr: logX ? 3 : 1 }, y: logY ? { distr: 3, range: decadesOf } : { range: range ? rangeOfWhole(range, curves) : rangeOf } },
      axes: [{ ...axis, label: xLabel, size: 32 }, { ...axis, label: yLabel, size: 62 }],
      cursor: { drag: { x: true, y: false }, points: { size: 6 } }, padding: [8, 12, 0, 0],
    };
  }

  /** Shows the stretch of time of this plot in all plots over time. */
  #follow(leader) {
    if (this.#zooms) return;
    const { min, max } = leader.scales.x;
    if (min == null || !this.#shown.some(({ plot }) => plot === leader)) return;
    this.#zooms = true;
    for (const { plot, overTime } of this.#shown) if (overTime && plot !== leader) plot.setScale('x', { min, max });
    // The plots take over a new scale after this turn.
    queueMicrotask(() => { this.#zooms = false; });
  }

  #resize() {
    for (const { plot, box } of this.#shown) {
      const width = Math.max(box.clientWidth, 200), height = isNarrow() ? HEIGHT_NARROW : HEIGHT;
      if (plot.width !== width) plot.setSize({ width, height });
    }
  }
}
