import { BodyKind } from '../data/frame.js';
import { el, setText } from './dom.js';
import { formatTime, formatValue } from './format.js';

/** The bar above: the scene, the time and the ice load now. */
export class FactsBar {
  #texts = new Map();

  constructor(box, title, recording, options, openHelp) {
    this.recording = recording;
    box.append(el('h1', { title: recording.head?.program ?? '' }, title || recording.head?.scene || 'Nilas'));
    const list = el('div', { class: 'list' });
    box.append(list);
    for (const [name, label, isMinor] of [['time', 'Time'], ['load', 'Ice load'], ['floes', 'Floes', true], ['contacts', 'Contact points', true]]) {
      const value = el('b', {}, '–'), small = el('small', {}, label);
      this.#texts.set(name, { value, small });
      list.append(el('div', { class: isMinor ? 'fact minor' : 'fact' }, small, value));
    }
    const toggle = (name, label) => {
      const button = el('button', { type: 'button', click: () => options.advance(name) }, label);
      const show = () => button.setAttribute('aria-pressed', options.get(name));
      options.addEventListener('change', show);
      show();
      return button;
    };
    box.append(el('div', { class: 'buttons' }, toggle('graphs', 'Graphs'), toggle('panel', 'Switches'),
                  el('button', { type: 'button', title: 'Help (?)', 'aria-label': 'Help', click: openHelp }, '?')));
  }

  update(frame) {
    const { head } = this.recording;
    const set = (name, text) => setText(this.#texts.get(name).value, text);
    const time = formatTime(frame.time, head.every || 0.1);
    set('time', head.until > 0 ? `${time} s of ${Number(head.until.toPrecision(6))} s` : `${time} s`);
    const load = iceLoad(head, frame);
    setText(this.#texts.get('load').small, load.label);
    set('load', load.value === null ? '–' : load.sides ? sidedForce(load.value, load.sides) : formatValue(load.value, 'N'));
    let floes = 0;
    for (const kind of frame.bodies.kind) if (kind === BodyKind.floe) ++floes;
    set('floes', String(floes));
    const { label, value, meaning } = contactCount(frame, head);
    const { small } = this.#texts.get('contacts');
    setText(small, label);
    small.parentElement.title = meaning;
    set('contacts', value);
  }
}

/** A force with its side instead of its sign. */
function sidedForce(value, [positive, negative]) {
  const text = formatValue(Math.abs(value), 'N');
  return Number.isFinite(value) && value !== 0 ? `${text} ${value > 0 ? positive : negative}` : text;
}

/** The contacts of a frame. Those between floes are summed, one a pair, unless the run stores all. */
function contactCount({ contacts }, head) {
  let points = 0;
  for (const isExact of contacts.exact.subarray(0, contacts.count)) if (isExact) ++points;
  if (head.contacts === 'all' || points === contacts.count)
    return { label: 'Contact points', value: String(contacts.count), meaning: 'The points in which bodies touch' };
  return { label: 'Points + pairs', value: `${points} + ${contacts.count - points}`,
           meaning: 'Contact points of the vessel and of fixed bodies, and pairs of floes that touch. A pair has several points.' };
}

/**
 * The ice load of a frame [N], with words for its signs where it has a sign: the resistance in the ice if the run has it, else the sum of the contact forces on the
 * vessel or on fixed bodies.
 */
export function iceLoad(head, frame) {
  const c = head.channels.findIndex(({ name }) => /(^|_)ice_resistance$/.test(name));
  if (c >= 0) {
    const isVessel = head.channels[c].name === 'ice_resistance';
    return { label: 'Ice load', value: frame.channels[3 * c], sides: isVessel ? ['astern', 'forward'] : ['along the drift', 'against it'] };
  }
  const sum = [0, 0, 0], { bodies, contacts } = frame;
  const carries = (b) => bodies.kind[b] === BodyKind.vessel || bodies.kind[b] === BodyKind.part ||
    (bodies.kind[b] === BodyKind.rigid && bodies.fixed[b]);
  if (!Array.from(bodies.id, (_, b) => b).some(carries)) return { label: 'Ice load', value: null };
  for (let i = 0; i < contacts.count; ++i) {
    const one = carries(contacts.first[i]), other = carries(contacts.second[i]);
    if (one === other) continue;
    for (let k = 0; k < 3; ++k) sum[k] += (one ? 1 : -1) * contacts.force[3 * i + k];
  }
  return { label: 'Ice load', value: Math.hypot(...sum) };
}
