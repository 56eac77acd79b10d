import { OPTIONS } from '../options.js';

/** What the keys do, for the help and for `listen`. */
export const KEYS = [
  ['space', 'Play or pause'], ['← →', 'One frame back or on'], ['shift ← →', 'Ten frames back or on'], ['Home End', 'To the start or the end'],
  ['- +', 'Slower or faster'], ['0 1 2 3 4', 'View of the scene, bow, side, above, astern'], ['Esc', 'Let go of the picked body'],
  ['s', 'Save the picture'], ['?', 'This help'],
];
const VIEWS = ['scene', 'bow', 'side', 'top', 'stern'];

/** Listens to keys. `actions`: {help, save, release}. */
export function listenToKeys(player, options, actions) {
  const keys = new Map(OPTIONS.filter((option) => option.key).map((option) => [option.key, () => options.advance(option.name)]));
  const step = (count) => (event) => player.step(event.shiftKey ? 10 * count : count);
  const jump = (number) => () => {
    player.pause();
    player.leaveLive();
    player.seekFrame(number);
  };
  keys.set(' ', () => player.toggle()).set('ArrowLeft', step(-1)).set('ArrowRight', step(1));
  keys.set('Home', jump(-Infinity)).set('End', jump(Infinity));
  keys.set('-', () => player.changeSpeed(-1)).set('+', () => player.changeSpeed(1)).set('=', () => player.changeSpeed(1));
  keys.set('?', actions.help).set('s', actions.save).set('Escape', actions.release);
  VIEWS.forEach((view, k) => keys.set(String(k), () => options.set('view', view)));
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (document.querySelector('dialog[open]')) return;
    const { tagName, type } = event.target;
    if (tagName === 'SELECT' || (tagName === 'INPUT' && type === 'text')) return;
    // A slider with the focus would move by itself, and a button would be pressed by the space bar.
    const action = keys.get(event.key.length === 1 ? event.key.toLowerCase() : event.key);
    if (!action) return;
    event.preventDefault();
    action(event);
  });
}
