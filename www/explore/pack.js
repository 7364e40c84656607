// @ts-check
// A room in the text of a link: compressed, in letters that links may have.

/** Largest room that is unpacked, bytes: a link could pretend to anything. */
const MOST = 32 << 20;

/** @param {string} text @returns {Promise<string>} */
export async function pack(text) {
  const packed = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(packed).arrayBuffer());
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return btoa(letters).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}

/** What was packed. @param {string} text @returns {Promise<string>} */
export async function unpack(text) {
  const letters = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  const packed = new Blob([Uint8Array.from(letters, (letter) => letter.charCodeAt(0))]).stream();
  const reader = packed.pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const parts = [];
  for (let size = 0; ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > MOST) throw new Error("the room in the link is too large");
    parts.push(value);
  }
  return new Blob(parts).text();
}
