import { RAMP_CSS } from '../scene/colours.js';
import { LINE_COLOURS, LineKind } from '../scene/lines.js';
import { COLOURS } from '../scene/shading.js';
import { el } from './dom.js';
import { formatRound, formatValue, unitFor } from './format.js';

/** What lines of each kind are, in the order of LineKind. */
const LINE_NAMES = ['mooring line', 'rod', 'thrust', 'force of the carriage', 'force of the wind', 'path, set-point, watch circle'];

const css = (colour) => `#${colour.toString(16).padStart(6, '0')}`;

/** What the colours, dots and arrows of the picture mean. */
export class Legend {
  #box;
  #last = '';

  constructor(box) { this.#box = box; }

  /** @param {import('../scene/world.js').World} world */
  update(world, options) {
    const { legend } = world.colours, hasContacts = world.recording.head.contacts !== undefined;
    const key = JSON.stringify([legend, world.metresPerNewton, omitted(world), world.picked, kindsOf(world),
                                ['contacts', 'arrows', 'chains', 'crushed', 'normals', 'lines'].map((n) => options.get(n))]);
    if (key === this.#last) return;
    this.#last = key;
    this.#box.replaceChildren(...[legend ? colourKey(legend) : null, thingsKey(world, options, hasContacts)].filter(Boolean));
  }
}

function colourKey({ title, unit, low, high, isLog, isList }) {
  if (isList) return el('div', {}, title);
  const [factor, text] = unitFor(high, unit);
  return el('div', {}, `${title}${text ? ` [${text}]` : ''}${isLog ? ', logarithmic' : ''}`,
            el('div', { class: 'ramp', style: `background: ${RAMP_CSS}` }),
            el('div', { class: 'ends' }, el('span', {}, formatRound(Number((factor * low).toPrecision(3)))), el('span', {}, formatRound(Number((factor * high).toPrecision(3))))));
}

/** The kinds of lines in the frame, ascending. */
const kindsOf = ({ frame }) => [...new Set(frame.lines.map(({ kind }) => kind))].filter((kind) => LINE_NAMES[kind]).sort();

/** How many forces of the frame are not drawn. */
const omitted = ({ contacts }) => contacts.count - contacts.drawn.length;

/** Dots, arrows and lines of the picture, and the body that was picked. */
function thingsKey(world, options, hasContacts) {
  const parts = [];
  const dot = (colour, text, shape = '') => parts.push(el('span', {}, el('i', { class: shape, style: `background: ${css(colour)}; border-color: ${css(colour)}` }), text));
  if (hasContacts) contactKey(world, options, dot, parts);
  if (options.get('lines')) {
    for (const kind of kindsOf(world)) {
      dot(LINE_COLOURS[kind], LINE_NAMES[kind], 'arrow');
      if (kind === LineKind.mooring) dot(LINE_COLOURS[kind], 'fairlead or anchor');
    }
  }
  if (world.picked !== null) dot(COLOURS.picked, 'picked', 'square');
  return parts.length > 0 ? el('div', { class: 'keys' }, ...parts) : null;
}

function contactKey(world, options, dot, parts) {
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
}
