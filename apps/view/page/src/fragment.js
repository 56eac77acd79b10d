import { OPTIONS } from './options.js';

/** Further words of the fragment, besides the options. */
export const WORDS = ['t', 'frame', 'pick', 'speed', 'play', 'camera'];

/**
 * Splits the address' fragment, such as `#t=12.3&view=top&ui=0`.
 * @returns {{options: [string, string][], words: Record<string, string>, unknown: string[]}}
 */
export function parseFragment(hash) {
  const options = [], words = {}, unknown = [];
  for (const [name, value] of new URLSearchParams(hash.replace(/^#/, ''))) {
    if (OPTIONS.some((option) => option.name === name)) options.push([name, value]);
    else if (WORDS.includes(name)) words[name] = value;
    else unknown.push(name);
  }
  return { options, words, unknown };
}
