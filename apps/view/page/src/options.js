/**
 * What a user can switch. This one list makes the panel, the keys, the address' fragment and `nilas.set`.
 * A `choice` has `values`; a `range` goes from `min` to `max` in powers of ten; a `toggle` is on or off.
 */
export const OPTIONS = [
  { name: 'view', kind: 'choice', group: 'Camera', label: 'View', value: 'scene', key: 'v',
    values: { scene: 'as the scene says', bow: 'from the bow', side: 'from the side', top: 'from above', stern: 'from astern' } },
  { name: 'follow', kind: 'toggle', group: 'Camera', label: 'Follow the vessel', value: false, key: 'f' },

  { name: 'color', kind: 'choice', group: 'Ice', label: 'Colour by', value: 'plain', key: 'o',
    values: { plain: 'ice', speed: 'speed', thickness: 'thickness', force: 'force on the floe', island: 'island',
              residual: 'residual of the island', damage: 'damage' } },
  { name: 'floes', kind: 'toggle', group: 'Ice', label: 'Floes', value: true, key: 'i' },
  { name: 'edges', kind: 'toggle', group: 'Ice', label: 'Edges', value: true, key: 'e' },

  { name: 'contacts', kind: 'toggle', group: 'Contacts', label: 'Contact points', value: true, key: 'c' },
  { name: 'normals', kind: 'toggle', group: 'Contacts', label: 'Normals', value: false, key: 'n' },
  { name: 'arrows', kind: 'toggle', group: 'Contacts', label: 'Force arrows', value: true, key: 'a' },
  { name: 'chains', kind: 'toggle', group: 'Contacts', label: 'Force chains', value: false, key: 'k' },
  { name: 'crushed', kind: 'toggle', group: 'Contacts', label: 'Mark crushed contacts', value: true, key: 'r' },
  { name: 'through', kind: 'toggle', group: 'Contacts', label: 'Show through bodies', value: true, key: 't' },
  { name: 'scale', kind: 'range', group: 'Contacts', label: 'Length of arrows', value: 1, min: 0.05, max: 20 },

  { name: 'hull', kind: 'choice', group: 'Vessel', label: 'Hull', value: 'fluid', key: 'h',
    values: { fluid: 'fluid mesh', collision: 'collision pieces', none: 'hidden' } },
  { name: 'wireframe', kind: 'toggle', group: 'Vessel', label: 'Wireframe', value: false, key: 'x' },
  { name: 'facenormals', kind: 'toggle', group: 'Vessel', label: 'Normals of its faces', value: false, key: 'm' },
  { name: 'lines', kind: 'toggle', group: 'Vessel', label: 'Lines, rods, thrusters, carriage', value: true, key: 'l' },

  { name: 'water', kind: 'toggle', group: 'Surroundings', label: 'Water', value: true, key: 'w' },
  { name: 'tank', kind: 'toggle', group: 'Surroundings', label: 'Tank and walls', value: true, key: 'b' },

  { name: 'graphs', kind: 'toggle', group: 'Page', label: 'Graphs', value: true, key: 'g' },
  { name: 'timings', kind: 'toggle', group: 'Page', label: 'Time per step', value: false, key: 'd' },
  { name: 'panel', kind: 'toggle', group: 'Page', label: 'This panel', value: true, key: 'p' },
  { name: 'ui', kind: 'toggle', group: 'Page', label: 'Bars and panels', value: true, key: 'u' },
];

/** The present values. Event `change`: `detail` is the name. */
export class Options extends EventTarget {
  #values = new Map(OPTIONS.map((option) => [option.name, option.value]));

  get(name) { return this.#values.get(name); }

  /** Sets an option from a value or its text. Throws an error that names what is allowed. */
  set(name, value) {
    this.#values.set(name, checked(optionNamed(name), value));
    this.dispatchEvent(Object.assign(new Event('change'), { detail: name }));
  }

  /** The next value: the other one of a toggle, the next of a choice. */
  advance(name) {
    const option = optionNamed(name);
    if (option.kind === 'toggle') return this.set(name, !this.get(name));
    const values = Object.keys(option.values);
    return this.set(name, values[(values.indexOf(this.get(name)) + 1) % values.length]);
  }

  all() { return Object.fromEntries(this.#values); }
}

/** What is wrong with a name that no option has. */
export function unknownOption(name) {
  return `There is no option "${name}". Allowed: ${OPTIONS.map((o) => o.name).join(', ')}.`;
}

function optionNamed(name) {
  const option = OPTIONS.find((o) => o.name === name);
  if (!option) throw new Error(unknownOption(name));
  return option;
}

function checked(option, value) {
  const fault = (allowed) => new Error(`Option "${option.name}" cannot be "${value}". Allowed: ${allowed}.`);
  if (option.kind === 'toggle') {
    if (![true, false, 'true', 'false', '1', '0', 1, 0].includes(value)) throw fault('1 or 0');
    return value === true || value === 'true' || value === '1' || value === 1;
  }
  if (option.kind === 'choice') {
    if (!(value in option.values)) throw fault(Object.keys(option.values).join(', '));
    return value;
  }
  const number = Number(value);
  if (!(number >= option.min && number <= option.max)) throw fault(`${option.min} to ${option.max}`);
  return number;
}
