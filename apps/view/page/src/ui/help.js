import { OPTIONS } from '../options.js';
import { KEYS } from './keys.js';
import { el } from './dom.js';

const SENTENCES = [
  ['Move', 'Drag to turn the view. Drag with the right button, or with two fingers, to shift it. Turn the wheel or pinch to zoom.'],
  ['Pick', 'Click a floe or the hull to see its mass, speed and contact forces. Click beside it to let go.'],
  ['Graphs', 'Click a graph to go to that time. The line is the value at each frame, the band reaches from the smallest to the largest value since the frame before.'],
  ['Arrows', 'An arrow ends at its contact and shows the force on the vessel, else on a fixed body, else on a floe. One length scale holds for all arrows.'],
  ['Contacts', 'Two free floes have one contact a frame: the mean point and the sum of the forces. Contacts of the vessel are drawn one by one.'],
  ['Waves', 'The water shows the waves of the run, weaker under ice where the scene says so. Floes and hull do not change them. Very short ones are left out.'],
  ['Forces of pairs', 'The force between two free floes is rounded to 4 %, and its point to 1 % of the size of the floe. Those on the vessel are exact.'],
];

/** The help, with the licences of what the page is made of. */
export function fillHelp(dialog, program, licences) {
  const keys = el('div', { class: 'keys' });
  for (const [key, text] of [...KEYS, ...OPTIONS.filter((o) => o.key).map((o) => [o.key, o.label])]) {
    keys.append(el('p', {}, el('span', {}, text), el('kbd', {}, key)));
  }
  dialog.append(
    el('button', { type: 'button', class: 'close', autofocus: true, click: () => dialog.close() }, 'Close'), el('h2', {}, 'Help'), ...SENTENCES.map(([title, text]) => el('p', {}, el('b', {}, `${title}. `), text)),
    el('h3', {}, 'Keys'), keys,
    el('h3', {}, 'About'), el('p', {}, `${program ? `Written by ${program}. ` : ''}The page asks no other computer for anything.`),
    el('details', {}, el('summary', {}, 'Licences of three.js and uPlot'), el('pre', {}, licences)));
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  dialog.addEventListener('keydown', (event) => { if (event.key === '?') dialog.close(); });
}
