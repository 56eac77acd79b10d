import uPlot from 'uplot';
import { el, isNarrow, setText } from './dom.js';
import { channelTitle, formatRound, formatValue, unitFor } from './format.js';

const HEIGHT = 118, MOST_AT_START = 4, REFRESH_MS = 500;
const GROUPS = { load: 'Loads', cell: 'Load cells', motion: 'Motion', module: 'Modules', solver: 'Solver', energy: 'Energy', time: 'Time per step' };

/** The channels that are drawn at first: ice loads, the carriage's and the moorings' pull, else what there is. */
export function firstChannels(channels) {
  const rank = ({ name, group }) => {
    if (group === 'time') return 99;
    const at = [/ice_resistance$/, /^carriage_fx$/, /ice_side$/, /mooring_fx$/, /^contact_fz$/, /thruster_fx$/].findIndex((p) => p.test(name));
    return at >= 0 ? at : group === 'load' ? 20 : group === 'solver' && (name === 'contacts' || name === 'floes') ? 30 : 98;
  };
  const ranked = channels.map((channel, c) => [rank(channel), c]).filter(([r]) => r < 98).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return ranked.slice(0, MOST_AT_START).map(([, c]) => c);
}

/** Graphs of channels over the time, with a mark at the time that is shown. */
export class Graphs {
  #charts = new Map();
  #lastRefresh = 0;

  constructor(box, recording, player) {
    Object.assign(this, { box, recording, player });
    const { channels } = recording.head;
    this.grid = el('div', { class: 'charts' });
    box.append(el('div', { class: 'head' }, this.#chooser(channels), el('span', {}, 'Click a graph to go to that time.')), this.grid);
    for (const c of firstChannels(channels)) this.#add(c);
    recording.addEventListener('grown', () => this.#refreshLater());
    player.addEventListener('shown', () => this.mark());
    new ResizeObserver(() => this.resize()).observe(this.grid);
  }

  /** Names of the channels that are drawn. */
  get shown() { return [...this.#charts.keys()].map((c) => this.recording.head.channels[c].name); }

  /** Draws or removes a channel. */
  toggle(c, isShown) {
    if (isShown && !this.#charts.has(c)) this.#add(c);
    if (!isShown && this.#charts.has(c)) {
      const { plot, element } = this.#charts.get(c);
      plot.destroy();
      element.remove();
      this.#charts.delete(c);
    }
    this.checks[c].checked = isShown;
  }

  #chooser(channels) {
    this.checks = [];
    const first = new Set(firstChannels(channels));
    const list = el('div', { class: 'list' });
    for (const [group, title] of Object.entries(GROUPS)) {
      const members = channels.map((channel, c) => ({ ...channel, c })).filter((channel) => channel.group === group);
      if (members.length > 0) list.append(el('h4', {}, title));
      for (const { name, unit, c } of members) {
        const check = el('input', { type: 'checkbox', change: () => this.toggle(c, check.checked) });
        check.checked = first.has(c);
        this.checks[c] = check;
        list.append(el('label', { title: name }, check, `${channelTitle(name)}${unit ? ` [${unitFor(0, unit)[1]}]` : ''}`));
      }
    }
    const summary = el('summary', {}, 'Choose channels');
    const details = el('details', { class: 'choose', toggle: () => {
      // The list is fixed, since its box scrolls.
      const place = summary.getBoundingClientRect();
      list.style.left = `${Math.max(8, Math.min(place.left, innerWidth - 300))}px`;
      list.style.bottom = `${innerHeight - place.top + 4}px`;
    } }, summary, list);
    document.addEventListener('pointerdown', (event) => { if (!details.contains(event.target)) details.open = false; });
    return details;
  }

  #add(c) {
    const { name, unit } = this.recording.head.channels[c];
    const data = this.#data(c);
    const [factor, text] = unitFor(largestShown(data, name), unit);
    const value = el('b'), box = el('div'), note = el('small');
    const title = `${channelTitle(name)}${text ? ` [${text}]` : ''}`;
    const element = el('div', { class: 'chart' }, el('h3', { title: name }, el('span', {}, title, note), value), box);
    this.grid.append(element);
    const now = el('div', { class: 'now' });
    // The plot takes over new data and sizes only when it draws, so the mark is placed then.
    const hooks = { draw: [({ data: drawn }) => {
      const isCut = hasRamp(name) && rangeAfterRamp(drawn) !== null;
      setText(note, isCut ? ` up to ${formatValue(largest(drawn), unit)} at the start` : '');
      this.mark();
    }] };
    const plot = new uPlot({ ...chartOptions(factor, this.#width(), hasRamp(name)), hooks }, data, box);
    plot.over.append(now);
    plot.over.addEventListener('click', (event) => {
      this.player.pause();
      this.player.leaveLive();
      this.player.seek(plot.posToVal(event.offsetX, 'x'));
    });
    this.#charts.set(c, { plot, element, value, now, unit });
    this.mark();
  }

  #data(c) {
    const { entries } = this.recording;
    // The first frame knows no values; null leaves a gap.
    const column = (k) => entries.map(({ channels }) => Number.isFinite(channels[3 * c + k]) ? channels[3 * c + k] : null);
    return [Float64Array.from(entries, ({ time }) => time), column(1), column(2), column(0)];
  }

  #width() { return Math.max(this.grid.clientWidth > 0 ? this.#columnWidth() : 300, 160); }

  /** The width of a column of the grid. */
  #columnWidth() {
    const inner = this.grid.clientWidth - 28;
    const columns = isNarrow() ? 1 : Math.max(1, Math.floor((inner + 14) / 314));
    return Math.floor((inner - 14 * (columns - 1)) / columns);
  }

  resize() {
    if (this.box.hidden || this.grid.clientWidth === 0) return;
    const width = this.#width();
    for (const { plot } of this.#charts.values()) if (plot.width !== width) plot.setSize({ width, height: HEIGHT });
    this.mark();
  }

  /** Moves the marks to the time that is shown. */
  mark() {
    if (this.box.hidden || this.player.number < this.recording.first || this.player.number >= this.recording.end) return;
    const { channels } = this.recording.entry(this.player.number);
    for (const [c, { plot, now, value, unit }] of this.#charts) {
      const at = plot.valToPos(this.player.time, 'x');
      now.style.transform = `translateX(${Number.isFinite(at) ? at : -10}px)`;
      setText(value, formatValue(channels[3 * c], unit));
    }
  }

  #refreshLater() {
    if (this.timer) return;
    const wait = Math.max(0, REFRESH_MS - (performance.now() - this.#lastRefresh));
    this.timer = setTimeout(() => this.refreshNow(), wait);
  }

  /** Takes over all frames at once. */
  refreshNow() {
    clearTimeout(this.timer);
    this.timer = null;
    this.#lastRefresh = performance.now();
    if (this.box.hidden) return;
    for (const [c, { plot }] of this.#charts) plot.setData(this.#data(c));
  }

  /** Brings all up to date after the graphs were hidden. */
  refresh() {
    this.#refreshLater();
    this.resize();
  }
}

function largest([, low, high]) {
  let size = 0;
  for (const values of [low, high]) for (const x of values) if (Math.abs(x) > size) size = Math.abs(x);
  return size;
}

/** Whether a channel is the pull of a carriage, whose ramp at the start is no load of the ice. */
const hasRamp = (name) => /^(carriage|cell\d)/.test(name);

const RAMP_SHARE = 0.25, MUCH = 2.5, MARGIN = 0.1;

/** The range of the later part of a channel where the start would make it flat, else null. */
function rangeAfterRamp([time, low, high]) {
  const end = time[0] + RAMP_SHARE * (time[time.length - 1] - time[0]);
  const all = [Infinity, -Infinity], late = [Infinity, -Infinity];
  for (let k = 0; k < time.length; ++k) {
    if (low[k] === null) continue;
    for (const range of time[k] > end ? [all, late] : [all]) {
      range[0] = Math.min(range[0], low[k]);
      range[1] = Math.max(range[1], high[k]);
    }
  }
  const size = late[1] - late[0];
  return size > 0 && all[1] - all[0] > MUCH * size ? [late[0] - MARGIN * size, late[1] + MARGIN * size] : null;
}

/** The largest size in the range that is shown. */
function largestShown(data, name) {
  const late = hasRamp(name) ? rangeAfterRamp(data) : null;
  return late ? Math.max(...late.map(Math.abs)) : largest(data);
}

function chartOptions(factor, width, isRamped) {
  const axis = { stroke: '#5a6b78', font: '11px system-ui, sans-serif', grid: { stroke: '#e6ecf0', width: 1 }, ticks: { show: false } };
  return {
    width, height: HEIGHT, legend: { show: false }, padding: [6, 14, 0, 0],
    scales: { x: { time: false },
              y: isRamped ? { range: ({ data }, low, high) => rangeAfterRamp(data) ?? uPlot.rangeNum(low ?? 0, high ?? 1, MARGIN, true) } : {} },
    cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
    axes: [{ ...axis, size: 22, values: (_, ticks) => ticks.map((t) => `${formatRound(t)} s`) },
           { ...axis, size: 46, values: (_, ticks) => ticks.map((y) => formatRound(factor * y)) }],
    bands: [{ series: [2, 1], fill: 'rgba(11, 99, 181, 0.22)' }],
    series: [{}, { stroke: 'transparent', points: { show: false } }, { stroke: 'transparent', points: { show: false } },
             { stroke: '#0b63b5', width: 1.3, points: { show: false } }],
  };
}
