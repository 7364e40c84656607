// @ts-check
// A WebM file from the chunks of a video encoder: the few elements that players need (RFC 9559, https://www.webmproject.org/docs/container/).

/**
 * @typedef {{ bytes: Uint8Array, ms: number, isKey: boolean }} Chunk
 */

/** Most milliseconds in a cluster: the times of its blocks have 16 bits. */
const MOST_MS = 30_000;

/** A whole number in as few bytes as it needs. @param {number} value @returns {Uint8Array} */
function whole(value) {
  const bytes = [];
  for (let rest = value; rest > 0 || bytes.length === 0; rest = Math.floor(rest / 256)) bytes.unshift(rest % 256);
  return Uint8Array.from(bytes);
}

/** @param {number} value */
function float(value) {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return bytes;
}

const letters = (/** @type {string} */ text) => new TextEncoder().encode(text);

/** An element: its id, its size in eight bytes, its content. @param {number} id @param {...Uint8Array} content */
function element(id, ...content) {
  const size = content.reduce((sum, { length }) => sum + length, 0);
  const head = whole(id);
  const all = new Uint8Array(head.length + 8 + size);
  all.set(head);
  const view = new DataView(all.buffer, head.length);
  view.setUint32(0, 0x01000000 + Math.floor(size / 2 ** 32));
  view.setUint32(4, size % 2 ** 32);
  let at = head.length + 8;
  for (const part of content) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

/** A picture, at so many milliseconds after its cluster. @param {Chunk} chunk @param {number} start */
function block({ bytes, ms, isKey }, start) {
  const head = new Uint8Array(4);
  head[0] = 0x81;
  new DataView(head.buffer).setInt16(1, ms - start);
  head[3] = isKey ? 0x80 : 0;
  return element(0xa3, head, bytes);
}

/**
 * @param {Chunk[]} chunks In order; the first is a key frame.
 * @param {{ codec: "V_VP8" | "V_VP9", width: number, height: number, ms: number }} video Its duration in milliseconds.
 */
export function webm(chunks, { codec, width, height, ms }) {
  /** @type {Chunk[][]} */
  const clusters = [];
  for (const chunk of chunks) {
    const last = clusters.at(-1);
    if (!last || chunk.isKey || chunk.ms - (last[0]?.ms ?? 0) > MOST_MS) clusters.push([chunk]);
    else last.push(chunk);
  }
  const head = element(0x1a45dfa3, element(0x4286, whole(1)), element(0x42f7, whole(1)), element(0x42f2, whole(4)), element(0x42f3, whole(8)), element(0x4282, letters("webm")), element(0x4287, whole(4)), element(0x4285, whole(2)));
  // Times are in milliseconds.
  const info = element(0x1549a966, element(0x2ad7b1, whole(1_000_000)), element(0x4489, float(ms)), element(0x4d80, letters("Robovac Playground")), element(0x5741, letters("Robovac Playground")));
  const track = element(0xae, element(0xd7, whole(1)), element(0x73c5, whole(1)), element(0x9c, whole(0)), element(0x83, whole(1)), element(0x86, letters(codec)), element(0xe0, element(0xb0, whole(width)), element(0xba, whole(height))));
  const parts = clusters.map((cluster) => {
    const start = cluster[0]?.ms ?? 0;
    return element(0x1f43b675, element(0xe7, whole(start)), ...cluster.map((chunk) => block(chunk, start)));
  });
  const segment = element(0x18538067, info, element(0x1654ae6b, track), ...parts);
  return new Blob([head, segment], { type: "video/webm" });
}
