/**
 * Unpacks zlib data (RFC 1950).
 * @param {Uint8Array} packed
 * @returns {Promise<Uint8Array>}
 */
export async function inflate(packed) {
  const stream = new DecompressionStream('deflate');
  const writer = stream.writable.getWriter();
  // A fault shows at the readable side, so that of the writer is not awaited.
  writer.write(packed).catch(() => {});
  writer.close().catch(() => {});
  return new Uint8Array(await new Response(stream.readable).arrayBuffer());
}

/** Unpacks a JSON object. */
export async function inflateJson(packed) { return JSON.parse(new TextDecoder().decode(await inflate(packed))); }
