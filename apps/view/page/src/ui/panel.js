import { OPTIONS } from '../options.js';
import { el } from './dom.js';

/** The switches, made from the list of options. `isUseful(option)` says which ones have something to switch. */
export class Panel {
  #options;
  #inputs = new Map();

  constructor(box, options, isUseful) {
    this.#options = options;
    let group = '';
    for (const option of OPTIONS) {
      if (option.name === 'ui' || !isUseful(option)) continue;
      if (option.group !== group) box.append(el('h2', {}, group = option.group));
      box.append(this.#row(option));
    }
    options.addEventListener('change', (event) => this.#show(event.detail));
    for (const name of this.#inputs.keys()) this.#show(name);
  }

  #row(option) {
    const set = (value) => this.#options.set(option.name, value);
    const key = option.key ? el('kbd', { title: 'Key' }, option.key) : null;
    let input, isWide = false;
    if (option.kind === 'toggle') {
      input = el('input', { type: 'checkbox', change: () => set(input.checked) });
    } else if (option.kind === 'choice') {
      input = el('select', { change: () => set(input.value) },
                 ...Object.entries(option.values).map(([value, label]) => el('option', { value }, label)));
    } else {
      isWide = true;
      const [low, high] = [option.min, option.max].map(Math.log10);
      input = el('input', { type: 'range', min: low, max: high, step: (high - low) / 200, input: () => set(10 ** Number(input.value)) });
    }
    input.dataset.option = option.name;
    this.#inputs.set(option.name, input);
    return option.kind === 'toggle' ? el('label', {}, input, el('span', {}, option.label), key)
                                    : el('label', { class: isWide ? 'wide' : 'choice' }, el('span', {}, option.label), input, key);
  }

  #show(name) {
    const input = this.#inputs.get(name), value = this.#options.get(name);
    if (!input) return;
    if (input.type === 'checkbox') input.checked = value;
    else input.value = input.type === 'range' ? Math.log10(value) : value;
  }
}
