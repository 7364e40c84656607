// @ts-check
// Photographs as floor plans: the browser decodes JPEG and WebP, which its programs then needn't.

/** Most pixels on a side of a map; as MAX_SIDE in crates/robovac-core/src/floor_plan/mod.rs. */
const MOST_SIDE = 4096;

/**
 * Files as the programs read them: photographs become grey images (PGM), upright and no larger than a map can be.
 * Throws messages for users.
 * @param {File[]} files @returns {Promise<{ name: string, bytes: Uint8Array<ArrayBuffer> }[]>}
 */
export const readable = (files) =>
  Promise.all(
    files.map(async (file) => {
      const bytes = new Uint8Array(await file.arrayBuffer());
      return { name: file.name, bytes: isPhoto(bytes) ? await grey(file) : bytes };
    }),
  );

/** Whether the bytes are those of a JPEG or WebP. @param {Uint8Array} bytes */
function isPhoto(bytes) {
  const text = (/** @type {number} */ from, /** @type {number} */ to) => String.fromCharCode(...bytes.subarray(from, to));
  return text(0, 3) === "\xff\xd8\xff" || (text(0, 4) === "RIFF" && text(8, 12) === "WEBP");
}

/** @param {File} file */
async function grey(file) {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw `"${file.name}" is damaged: the browser can't decode it. Export it again, best as PNG.`;
  });
  const factor = Math.min(1, MOST_SIDE / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(factor * side)));
  const context = new OffscreenCanvas(width, height).getContext("2d", { alpha: false, willReadFrequently: true });
  if (!context) throw `"${file.name}" is too large for this browser. Save a smaller picture.`;
  context.fillStyle = "#fff";
  context.fillRect(0, 0, width, height);
  context.drawImage(bitmap, 0, 0, width, height);
  bitmap.close();
  const head = new TextEncoder().encode(`P5\n${width} ${height}\n255\n`);
  const bytes = new Uint8Array(head.length + width * height);
  bytes.set(head);
  // In bands: all of a large picture in four channels is more than some phones give.
  const band = 256;
  for (let top = 0, at = head.length; top < height; top += band) {
    const { data } = context.getImageData(0, top, width, Math.min(band, height - top));
    for (let i = 0; i < data.length; i += 4) bytes[at++] = Math.round((data[i] + data[i + 1] + data[i + 2]) / 3);
  }
  return bytes;
}
