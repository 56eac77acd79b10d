#!/usr/bin/env node
/**
 * Puts a replay into the page, as `nilas view` does.
 *
 * usage: node fill_page.mjs PAGE.html REPLAY.bin OUT.html [TITLE]
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** Bytes of a block. */
const BLOCK_BYTES = 6000000;
const LETTERS = Array.from({ length: 94 }, (_, k) => String.fromCharCode(33 + k)).filter((letter) => !'"&<'.includes(letter));

/** Bytes as the letters of a block: 13 bits are two letters, and at the end up to 6 are one. */
export function blockText(bytes) {
  const letters = [];
  let waiting = 0, count = 0;
  const put = (width) => {
    const value = waiting & ((1 << width) - 1);
    letters.push(LETTERS[value % 91]);
    if (width > 6) letters.push(LETTERS[Math.floor(value / 91)]);
    waiting >>>= width;
    count -= width;
  };
  for (const byte of bytes) {
    waiting |= byte << count;
    count += 8;
    if (count >= 13) put(13);
  }
  if (count > 0) put(count);
  return letters.join('');
}

/** @param {string} page the template @param {Uint8Array} bytes of the replay @param {object} facts */
export function fillPage(page, bytes, facts, blockBytes = BLOCK_BYTES) {
  const blocks = [];
  for (let at = 0; at < bytes.length; at += blockBytes) {
    const text = blockText(bytes.subarray(at, at + blockBytes));
    blocks.push(`<script type="application/octet-stream" id="replay-${blocks.length}">${text}</script>`);
  }
  const escaped = facts.title.replaceAll('&', '&amp;').replaceAll('<', '&lt;');
  return page.replace('@NILAS_TITLE@', () => escaped).replace('@NILAS_BLOCKS@', () => blocks.join('\n'))
    .replace('@NILAS_FACTS@', () => JSON.stringify(facts).replaceAll('<', '\\u003c'));
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const [page, replay, out, title = 'synthetic'] = process.argv.slice(2);
  writeFileSync(out, fillPage(readFileSync(page, 'utf8'), readFileSync(replay), { title, live: false }));
}
