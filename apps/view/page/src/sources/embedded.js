import { PieceReader } from '../data/pieces.js';
import { bytesOfBlock } from './block_text.js';

/** Lets the page draw between two parts of a long task. */
const pause = () => new Promise((resolve) => setTimeout(resolve));

/** The blocks `replay-0`, `replay-1` ... of the page. */
export function embeddedBlocks() {
  const blocks = [];
  for (let k = 0;; ++k) {
    const block = document.getElementById(`replay-${k}`);
    if (!block) return blocks;
    blocks.push(block);
  }
}

/**
 * Reads the replay in the page's blocks into a recording.
 * @returns {Promise<{bytes: number, isCut: boolean}>} whether the last piece was incomplete
 */
export async function readEmbedded(blocks, recording) {
  const reader = new PieceReader();
  let bytes = 0;
  for (const block of blocks) {
    const part = bytesOfBlock(block.textContent.trim());
    block.remove();
    bytes += part.length;
    await recording.add(reader.push(part));
    await pause();
  }
  reader.check();
  return { bytes, isCut: reader.pending > 0 };
}

/** Reads a file that the user chose. */
export async function readFile(file, recording) {
  const reader = new PieceReader();
  const step = 8 << 20;
  for (let at = 0; at < file.size; at += step) {
    await recording.add(reader.push(new Uint8Array(await file.slice(at, at + step).arrayBuffer())));
    await pause();
  }
  reader.check();
  return { bytes: file.size, isCut: reader.pending > 0 };
}
