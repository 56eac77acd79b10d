import { el } from './dom.js';

/** Sentences above the picture, each under a name so that it can be replaced or taken back. */
export class Notices {
  #box;
  #shown = new Map();

  constructor(box) { this.#box = box; }

  /** @param {boolean} isGrave whether something failed */
  show(name, text, isGrave = false) {
    this.hide(name);
    if (!text) return;
    const line = el('p', { class: isGrave ? 'grave' : null }, text,
                    el('button', { type: 'button', 'aria-label': 'Close the notice', click: () => this.hide(name) }, '✕'));
    this.#shown.set(name, line);
    this.#box.append(line);
  }

  hide(name) {
    this.#shown.get(name)?.remove();
    this.#shown.delete(name);
  }

  get texts() { return [...this.#shown.values()].map((line) => line.firstChild.textContent); }
}
