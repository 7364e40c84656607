// @ts-check
// Where lessons come from: this page, a file, a link that contains one, or another site.
import { pack, unpack } from "../explore/pack.js";

/**
 * @typedef {{ id: string, file: string, title: string, minutes: number, about: string, explains: string[] }} Entry A lesson of this page.
 * @typedef {object} Source
 * @property {string} text
 * @property {string} place What leads here, behind `#lesson=`.
 * @property {boolean} isOurs Whether it comes with the page.
 * @property {boolean} [isFile] Whether it was opened from a file: by its author, or who looks it over.
 */

/** Most letters of a lesson in a link; some programs cut longer ones off. */
const MOST_LINK = 8000;
/** Largest lesson, as in the parser. */
const MOST_LETTERS = 300_000;
const PACKED = "text:";

const index = new URL("../../lessons/index.json", import.meta.url);
/** @type {Promise<Entry[]> | undefined} */
let entries;

/** The lessons of this page. */
export function lessons() {
  entries ??= textOf(index).then((text) => JSON.parse(text));
  entries.catch(() => (entries = undefined));
  return entries;
}

/** @param {URL} address */
async function textOf(address) {
  const response = await fetch(address, { cache: "no-cache" });
  if (!response.ok) throw new Error(`it could not be fetched (status ${response.status})`);
  return response.text();
}

/** @param {File} file @returns {Promise<Source>} */
export async function ofFile(file) {
  if (file.size > MOST_LETTERS) throw new Error(`"${file.name}" has ${Math.round(file.size / 1000)} kB; a lesson has at most ${MOST_LETTERS / 1000} kB`);
  const text = await file.text();
  const packed = await pack(text);
  return { text, place: packed.length <= MOST_LINK ? PACKED + packed : "", isOurs: false, isFile: true };
}

/** Whether a place is on another site. @param {string} place */
export const isFar = (place) => /^https?:/i.test(place);

/** The lesson of a place on this page or in the link itself. @param {string} place @returns {Promise<Source>} */
export async function ofPlace(place) {
  if (place.startsWith(PACKED)) return { text: await unpack(place.slice(PACKED.length)), place, isOurs: false };
  const entry = (await lessons()).find(({ id }) => id === place);
  if (!entry) throw new Error(`there is no lesson "${place}" here; choose one of the list`);
  return { text: await textOf(new URL(entry.file, index)), place, isOurs: true };
}

/** Checks the address of a lesson elsewhere. @param {string} place @returns {URL} */
export function addressOf(place) {
  const url = new URL(place);
  const isNear = ["localhost", "127.0.0.1", "[::1]"].includes(url.hostname);
  if (url.protocol !== "https:" && !isNear) throw new Error("lessons are fetched by https only; ask for an address that begins with https://");
  if (url.username || url.password) throw new Error("the address contains a user's name; ask for one without");
  return url;
}

/** Fetches a lesson from another site, after the reader has agreed. @param {URL} url @returns {Promise<Source>} */
export async function ofSite(url) {
  let response;
  try {
    response = await fetch(url, { credentials: "omit", referrerPolicy: "no-referrer", cache: "no-cache" });
  } catch {
    throw new Error(
      `${url.host} can't be reached, or it forbids other sites to read the file (it sends no Access-Control-Allow-Origin). Download the file and drop it on this page, or keep it where that is allowed, such as GitHub Pages or raw.githubusercontent.com`,
    );
  }
  if (!response.ok) throw new Error(`${url.host} answers with status ${response.status}; check the address`);
  const text = await response.text();
  if (text.length > MOST_LETTERS) throw new Error(`it has ${Math.round(text.length / 1000)} kB; a lesson has at most ${MOST_LETTERS / 1000} kB`);
  if (/^\s*<(!doctype|html)/i.test(text)) throw new Error("the address leads to a web page, not to the file itself; on GitHub, use the button Raw");
  return { text, place: url.href, isOurs: false };
}
