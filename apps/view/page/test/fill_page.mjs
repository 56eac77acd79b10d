#!/usr/bin/env node
/**
 * Puts a replay into the page, as `nilas view` does.
 *
 * usage: node fill_page.mjs PAGE.html REPLAY.bin OUT.html [TITLE]
 */
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';

/** Bytes of a block. A multiple of three, so that no block but the last is padded. */
const BLOCK_BYTES = 6000000;

/** @param {string} page the template @param {Uint8Array} bytes of the replay @param {object} facts */
export function fillPage(page, bytes, facts, blockBytes = BLOCK_BYTES) {
  const blocks = [];
  for (let at = 0; at < bytes.length; at += blockBytes) {
    const text = Buffer.from(bytes.subarray(at, at + blockBytes)).toString('base64');
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
