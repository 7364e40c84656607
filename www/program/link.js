// @ts-check
// A program in the text of a link.
import { pack, unpack } from "../explore/pack.js";
import { MOST_LETTERS, freeName, freshId } from "./own-programs.js";

/** @typedef {import("./own-programs.js").Program} Program */

/** Longest packed program in a link: some programs cut longer links off. */
const MOST_PACKED = 8000;

/** @param {Omit<Program, "id">} program @returns {Promise<string>} */
export const packProgram = ({ name, language, source }) => pack(JSON.stringify({ name, language, source }));

/** What a link that carries a program has more. @param {Omit<Program, "id">} program @returns {Promise<string>} Throws messages for users. */
export async function shareProgram(program) {
  const code = await packProgram(program);
  if (code.length > MOST_PACKED) throw `this program takes ${Math.ceil(code.length / 1000)} KB in a link, more than the ${MOST_PACKED / 1000} KB that every other program passes on. Export it and send the file.`;
  return `code=${code}`;
}

/** The program of a link. @param {string} text @returns {Promise<Program>} Throws messages for users. */
export async function unpackProgram(text) {
  const damaged = "The program in this link is damaged, perhaps because the link was cut off. Ask its author for the whole link, or for the file.";
  /** @type {Record<string, unknown>} */
  let found;
  try {
    found = JSON.parse(await unpack(text));
  } catch (error) {
    console.warn(error);
    throw damaged;
  }
  const { name, language, source } = found ?? {};
  if (typeof name !== "string" || typeof source !== "string" || (language !== "python" && language !== "javascript")) throw damaged;
  if (source.length > MOST_LETTERS) throw `The program in this link has ${Math.ceil(source.length / 1000)} KB, more than the ${MOST_LETTERS / 1000} KB that a program may have.`;
  return { id: freshId(), name: freeName(name), language, source, isForeign: true };
}
