// Map files, made in memory: every test says itself what is in the file that it loads.
import { Buffer } from "node:buffer";
import { deflateSync } from "node:zlib";

/** A file as pickers and drops take it. */
const file = (name, content) => ({ name, bytes: Buffer.from(content) });

/** `rows` of `#`, `.`, `?` and `S` as a text map. */
export const textMap = (name, rows, { resolution = 0.1 } = {}) => file(name, `; resolution ${resolution}\n${rows.join("\n")}\n`);

/** An open room, `width` by `height` cells within its walls, with the start `S` in column `x` and row `y` of the inside. */
export function openRoom(width, height, [x, y] = [width >> 1, height >> 1]) {
  const wall = "#".repeat(width + 2);
  const floor = `#${".".repeat(width)}#`;
  const rows = [wall, ...Array.from({ length: height }, () => floor), wall];
  rows[y + 1] = `#${".".repeat(x)}S${".".repeat(width - x - 1)}#`;
  return rows;
}

/** A square of floor with pillars of `pillar` cells every `every` cells: much to plan, however large. */
export function pillars(side, { every = 10, pillar = 2 } = {}) {
  const open = ".".repeat(side);
  const crowded = (".".repeat(every - pillar) + "#".repeat(pillar)).repeat(Math.ceil(side / every)).slice(0, side);
  return Array.from({ length: side }, (_, row) => (row % every < every - pillar ? open : crowded));
}

const SHADES = { "#": 0, ".": 255, S: 255 };

/** Grey values of a room: walls 0, floor 255, all else 128. Rows that are alike are made once. */
function greys(rows) {
  const made = new Map([...new Set(rows)].map((row) => [row, Uint8Array.from(row, (cell) => SHADES[cell] ?? 128)]));
  return rows.map((row) => made.get(row));
}

/** `rows` as a PNG with 8 bits of grey a pixel. */
export function png(name, rows) {
  const lines = greys(rows).map((line) => Buffer.concat([Buffer.from([0]), line]));
  return file(name, Buffer.concat([pngHeader(rows[0].length, rows.length), chunk("IDAT", deflateSync(Buffer.concat(lines))), chunk("IEND")]));
}

/** A PNG that announces its size and then ends. */
export const pngOfSize = (name, width, height) => file(name, Buffer.concat([pngHeader(width, height), chunk("IDAT", deflateSync(Buffer.alloc(64))), chunk("IEND")]));

/** `rows` as a PGM image, as ROS saves its maps. */
export function pgm(name, rows) {
  return file(name, Buffer.concat([Buffer.from(`P5\n${rows[0].length} ${rows.length}\n255\n`), ...greys(rows)]));
}

/** The description that ROS saves beside an image. */
export function mapYaml(name, image, { resolution = 0.05 } = {}) {
  return file(name, `image: ${image}\nresolution: ${resolution}\norigin: [-1.0, -2.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n`);
}

/** Any text or bytes. */
export const anyFile = file;

function pngHeader(width, height) {
  const header = Buffer.alloc(13);
  header.writeUInt32BE(width, 0);
  header.writeUInt32BE(height, 4);
  header.set([8, 0, 0, 0, 0], 8);
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), chunk("IHDR", header)]);
}

function chunk(type, data = Buffer.alloc(0)) {
  const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
  const [length, sum] = [Buffer.alloc(4), Buffer.alloc(4)];
  length.writeUInt32BE(data.length);
  sum.writeUInt32BE(crc32(body));
  return Buffer.concat([length, body, sum]);
}

function crc32(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit += 1) sum = (sum >>> 1) ^ (sum & 1 ? 0xedb88320 : 0);
  }
  return (sum ^ 0xffffffff) >>> 0;
}
