import { RAMP_CSS } from '../scene/colours.js';
import { el } from '../ui/dom.js';
import { formatRound, formatValue } from '../ui/format.js';
import { leastOf, loadColour } from './load_colour.js';

const WIDTH = 1060, LEFT = 56, RIGHT = 12, TOP = 14, FOOT = 46, LEAST_HEIGHT = 150, MOST_HEIGHT = 420;

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

/**
 * The impulse by place on the unrolled surface: along the waterline to the right, the height above the water upwards.
 * Heights are stretched where the picture would be too flat to read.
 */
export function drawHullMap(box, hull) {
  const { cells, width: side, outline, water } = hull;
  const largest = Math.max(...cells.map((cell) => cell[5]));
  const heights = cells.map((cell) => cell[1] - water);
  const low = Math.min(...heights, 0) - 2 * side, high = Math.max(...heights, 0) + 2 * side;
  const across = (WIDTH - LEFT - RIGHT) / outline;
  const height = Math.min(Math.max(across * (high - low), LEAST_HEIGHT), MOST_HEIGHT), up = height / (high - low);
  const x = (along) => LEFT + (along + outline / 2) * across, y = (z) => TOP + (high - z) * up;
  const picture = svg('svg', { viewBox: `0 0 ${WIDTH} ${TOP + height + FOOT}`, role: 'img', 'aria-label': 'Impulse by place on the unrolled surface' });
  picture.append(svg('rect', { class: 'axis', x: LEFT, y: TOP, width: WIDTH - LEFT - RIGHT, height }));
  for (const at of ticks(-outline / 2, outline / 2, 10))
    picture.append(svg('text', { x: x(at), y: TOP + height + 16, 'text-anchor': 'middle' }, formatRound(at)));
  for (const at of ticks(low, high, 5))
    picture.append(svg('text', { x: LEFT - 6, y: y(at) + 4, 'text-anchor': 'end' }, formatRound(at)));
  for (const [along, z, , , , impulse, peak] of cells) {
    const title = svg('title', {}, `${formatValue(impulse, 'Ns')}; at most ${formatValue(peak, 'N')} in one step`);
    picture.append(svg('rect', { x: x(along - side / 2), y: y(z - water + side / 2), width: side * across, height: side * up,
                                 fill: `rgb(${loadColour(impulse, largest).join(' ')})` }, title));
  }
  picture.append(svg('line', { class: 'waterline', x1: LEFT, x2: WIDTH - RIGHT, y1: y(0), y2: y(0) }));
  const ends = hull.vessel ? 'along the waterline [m]: starboard left of the bow at 0, port right' : 'along the waterline [m], 0 towards the ice';
  picture.append(svg('text', { x: LEFT, y: TOP + height + 36 }, `${ends}. Upwards: height above the water [m]${up > 1.01 * across ? `, stretched ${(up / across).toPrecision(2)} times` : ''}`));
  const ramp = el('i', { style: `background: ${RAMP_CSS}` });
  box.append(picture, el('div', { class: 'ramp' }, `up to ${formatValue(leastOf(largest), 'Ns')}`, ramp, `${formatValue(largest, 'Ns')} per square, logarithmic`));
}
