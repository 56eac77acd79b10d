import { RAMP_CSS } from '../scene/colours.js';
import { COLOURS } from '../scene/shading.js';
import { el } from './dom.js';
import { formatRound, formatValue, unitFor } from './format.js';

const css = (colour) => `#${colour.toString(16).padStart(6, '0')}`;

/** What the colours, dots and arrows of the picture mean. */
export class Legend {
  #box;
  #last = '';

  constructor(box) { this.#box = box; }

  /** @param {import('../scene/world.js').World} world */
  update(world, options) {
    const { legend } = world.colours, hasContacts = world.recording.head.contacts !== undefined;
    const key = JSON.stringify([legend, world.metresPerNewton, omitted(world), ['contacts', 'arrows', 'chains', 'crushed', 'normals'].map((n) => options.get(n))]);
    if (key === this.#last) return;
    this.#last = key;
    this.#box.replaceChildren(...[legend ? colourKey(legend) : null, hasContacts ? contactKey(world, options) : null].filter(Boolean));
  }
}

function colourKey({ title, unit, low, high, isLog, isList }) {
  if (isList) return el('div', {}, title);
  const [factor, text] = unitFor(high, unit);
  return el('div', {}, `${title}${text ? ` [${text}]` : ''}${isLog ? ', logarithmic' : ''}`,
            el('div', { class: 'ramp', style: `background: ${RAMP_CSS}` }),
            el('div', { class: 'ends' }, el('span', {}, formatRound(Number((factor * low).toPrecision(3)))), el('span', {}, formatRound(Number((factor * high).toPrecision(3))))));
}

/** How many forces of the frame are not drawn. */
const omitted = ({ contacts }) => contacts.count - contacts.drawn.length;

function contactKey(world, options) {
  const parts = [];
  const dot = (colour, text, shape = '') => parts.push(el('span', {}, el('i', { class: shape, style: `background: ${css(colour)}; border-color: ${css(colour)}` }), text));
  if (options.get('contacts')) {
    dot(COLOURS.stick, 'stick');
    dot(COLOURS.slip, 'slip');
    dot(COLOURS.open, 'open');
    if (!options.get('crushed')) dot(COLOURS.crush, 'crush');
  }
  if (options.get('crushed')) dot(COLOURS.crush, 'crush', 'ring');
  if (options.get('normals')) dot(COLOURS.normal, 'normal', 'arrow');
  if (options.get('arrows')) {
    dot(COLOURS.forceOnVessel, 'force on vessel or fixed body', 'arrow');
    dot(COLOURS.forceOnFloe, 'force on floe', 'arrow');
    if (omitted(world) > 0) parts.push(el('span', {}, `the ${world.contacts.drawn.length} largest of ${world.contacts.count} forces`));
    if (world.metresPerNewton > 0) parts.push(el('span', {}, `1 m of arrow is ${formatValue(1 / world.metresPerNewton, 'N')}`));
  }
  return parts.length > 0 ? el('div', { class: 'keys' }, ...parts) : null;
}
