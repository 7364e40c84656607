// @ts-check
// Photographs as floor plans: the browser decodes JPEG and WebP, which its programs then needn't.

/** Most pixels on a side of a map; as MAX_SIDE in crates/robovac-core/src/floor_plan/mod.rs. */
const MOST_SIDE = 4096;
/** Most pixels of a picture, and most columns that every browser draws; as MAX_PIXELS in crates/robovac-core/src/floor_plan/files/raster.rs. */
const [MOST_PIXELS, MOST_COLUMNS] = [2 ** 26, 2 ** 14];
/** As TAKEN in crates/robovac-core/src/floor_plan/files/foreign.rs. */
export const TAKEN = "Accepted formats: drawings (DXF, SVG, GeoJSON), images (PNG, JPEG, WebP, PGM), ROS maps (YAML with its image), text maps of # and ., and saved scenarios (JSON).";

/**
 * Files as the programs read them: photographs become grey images (PGM), upright and with at most `most` pixels on a side,
 * those of a map unless a program reduces them itself. Throws messages for users.
 * @param {File[]} files @param {number} [most] @returns {Promise<{ name: string, bytes: Uint8Array<ArrayBuffer> }[]>}
 */
export const readable = (files, most = MOST_SIDE) =>
  Promise.all(
    files.map(async (file) => {
      const bytes = new Uint8Array(await file.arrayBuffer());
      return { name: file.name, bytes: isPhoto(bytes) ? await grey(file, most) : bytes };
    }),
  );

/** Whether the bytes are those of a JPEG or WebP. @param {Uint8Array} bytes */
function isPhoto(bytes) {
  const text = (/** @type {number} */ from, /** @type {number} */ to) => String.fromCharCode(...bytes.subarray(from, to));
  return text(0, 3) === "\xff\xd8\xff" || (text(0, 4) === "RIFF" && text(8, 12) === "WEBP");
}

/** @param {File} file @param {number} most */
async function grey(file, most) {
  const bitmap = await createImageBitmap(file).catch(() => {
    throw `"${file.name}" is damaged: the browser can't decode it. Export it again, best as PNG. ${TAKEN}`;
  });
  const factor = Math.min(1, most / Math.max(bitmap.width, bitmap.height));
  const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(factor * side)));
  if (width * height > MOST_PIXELS || width > MOST_COLUMNS) throw `"${file.name}" has ${width} x ${height} pixels, but at most ${Math.floor(MOST_PIXELS / 1e6)} million are read, ${MOST_COLUMNS} in a row. Scale it down. ${TAKEN}`;
  // In bands: all of a large picture in four channels is more than some phones give. One that is scaled would have seams.
  const band = factor < 1 ? height : Math.min(height, 256);
  const context = new OffscreenCanvas(width, band).getContext("2d", { alpha: false, willReadFrequently: true });
  if (!context) throw `"${file.name}" is too large for this browser. Save a smaller picture. ${TAKEN}`;
  context.fillStyle = "#fff";
  const head = new TextEncoder().encode(`P5\n${width} ${height}\n255\n`);
  const bytes = new Uint8Array(head.length + width * height);
  bytes.set(head);
  for (let top = 0, at = head.length; top < height; top += band) {
    context.fillRect(0, 0, width, band);
    context.drawImage(bitmap, 0, -top, width, height);
    const { data } = context.getImageData(0, 0, width, Math.min(band, height - top));
    for (let i = 0; i < data.length; i += 4) bytes[at++] = Math.round((data[i] + data[i + 1] + data[i + 2]) / 3);
  }
  bitmap.close();
  return bytes;
}
