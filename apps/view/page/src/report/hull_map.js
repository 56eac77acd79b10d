import { RAMP_CSS } from '../scene/colours.js';
import { el } from '../ui/dom.js';
import { formatRound, formatValue } from '../ui/format.js';
import { leastOf, loadColour } from './load_colour.js';

const LEFT = 46, RIGHT = 12, TOP = 14, FOOT = 24, LEAST_WIDTH = 260, LEAST_HEIGHT = 150, MOST_HEIGHT = 420, PIXELS_PER_TICK = 70;

/** An element of SVG. */
function svg(tag, attributes = {}, ...children) {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

/** Round numbers within a range, at most `most` of them. */
function ticks(low, high, most) {
  const power = 10 ** Math.floor(Math.log10((high - low) / most));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => (high - low) / s <= most) ?? 10 * power;
  const list = [];
  for (let k = Math.ceil(low / step); k * step <= high + 1e-9 * step; ++k) list.push(k * step);
  return list;
}

/** A ring where the largest load acted, with the name of what made it. */
function peakMark({ name }, x, y, right) {
  const isRight = x > 0.6 * right;
  return [svg('circle', { class: 'mark', cx: x, cy: y, r: 8 }),
          svg('text', { class: 'mark-name', x: x + (isRight ? -12 : 12), y: y - 8, 'text-anchor': isRight ? 'end' : 'start' }, name)];
}

/** Draws the map in a box, and again whenever the width of the box changes, so that letters keep their size. */
export function drawHullMap(box, hull) {
  let drawn = 0;
  new ResizeObserver(() => {
    const width = Math.max(box.clientWidth, LEAST_WIDTH);
    if (width === drawn) return;
    drawn = width;
    box.replaceChildren(...hullMap(hull, width));
  }).observe(box);
  drawn = Math.max(box.clientWidth, LEAST_WIDTH);
  box.replaceChildren(...hullMap(hull, drawn));
}

/**
 * The impulse by place on the unrolled surface: along the waterline to the right, the height above the water upwards.
 * Heights are stretched where the picture would be too flat to read.
 */
function hullMap({ cells, width: side, outline, water, peak: load, vessel }, whole) {
  const largest = Math.max(...cells.map((cell) => cell[5]));
  const heights = cells.map((cell) => cell[1] - water);
  const low = Math.min(...heights, 0) - 2 * side, high = Math.max(...heights, 0) + 2 * side;
  const across = (whole - LEFT - RIGHT) / outline;
  const height = Math.min(Math.max(across * (high - low), LEAST_HEIGHT), MOST_HEIGHT), up = height / (high - low);
  const x = (along) => LEFT + (along + outline / 2) * across, y = (z) => TOP + (high - z) * up;
  const picture = svg('svg', { viewBox: `0 0 ${whole} ${TOP + height + FOOT}`, role: 'img', 'aria-label': 'Impulse by place on the unrolled surface' });
  picture.append(svg('rect', { class: 'axis', x: LEFT, y: TOP, width: whole - LEFT - RIGHT, height }));
  for (const at of ticks(-outline / 2, outline / 2, Math.min(10, Math.floor(whole / PIXELS_PER_TICK))))
    picture.append(svg('text', { x: x(at), y: TOP + height + 16, 'text-anchor': 'middle' }, formatRound(at)));
  for (const at of ticks(low, high, 5))
    picture.append(svg('text', { x: LEFT - 6, y: y(at) + 4, 'text-anchor': 'end' }, formatRound(at)));
  for (const [along, z, , , , impulse, peak] of cells) {
    const title = svg('title', {}, `${formatValue(impulse, 'Ns')}; at most ${formatValue(peak, 'N')} in one step`);
    picture.append(svg('rect', { x: x(along - side / 2), y: y(z - water + side / 2), width: side * across, height: side * up,
                                 fill: `rgb(${loadColour(impulse, largest).join(' ')})` }, title));
  }
  picture.append(svg('line', { class: 'waterline', x1: LEFT, x2: whole - RIGHT, y1: y(0), y2: y(0) }));
  if (load) picture.append(...peakMark(load, x(load.along), y(load.height - water), whole));
  const ends = vessel ? 'along the waterline [m], with the bow at 0, starboard left and port right' : 'along the waterline [m], with 0 towards the ice';
  const stretched = up > 1.01 * across ? `, stretched ${(up / across).toPrecision(2)} times` : '';
  const ramp = el('i', { style: `background: ${RAMP_CSS}` });
  return [picture, el('p', {}, `To the right: ${ends}. Upwards: height above the water [m]${stretched}.`),
          el('div', { class: 'ramp' }, `up to ${formatValue(leastOf(largest), 'Ns')}`, ramp, `${formatValue(largest, 'Ns')} per square, logarithmic`)];
}
