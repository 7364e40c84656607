// @ts-check
// Songs: up to 16 notes in each of four places, written on a small piano or as text.
import { byId, make, setAttribute, setEnabled, setText } from "../dom.js";
import { keep, kept } from "./dialogs.js";
import { silence, sound } from "./sound.js";

/** @typedef {[note: number, duration: number]} Note MIDI number and 1/64 s. */

const NAMES = ["C", "C♯", "D", "D♯", "E", "F", "F♯", "G", "G♯", "A", "A♯", "B"];
/** MIDI numbers of the piano's keys: two octaves from C4. */
const [FIRST, LAST] = [60, 84];
const MOST = 16;
/** A note that isn't played: below 31 (Open Interface, opcode 140). */
const REST = 30;
const LENGTHS = [8, 16, 24, 32, 64];
const KEY = "connection-songs";
/** The initial songs. */
const FIRST_SONGS = ["C5:16 E5:16 G5:16 C6:32", "G4:16 G4:16 G4:16 D♯4:48", "E5:12 D5:12 C5:24 r:12 C5:12 D5:12 E5:24", ""];

/** @param {number} note */
const named = (note) => (note < 31 ? "r" : `${NAMES[note % 12]}${Math.floor(note / 12) - 1}`);
/** @param {Note[]} notes */
export const written = (notes) => notes.map(([note, duration]) => `${named(note)}:${duration}`).join(" ");

/** Notes such as "C5:16 F#4:8 r:16"; says which one it doesn't know. @param {string} text @returns {{ notes: Note[], fault: string }} */
export function readNotes(text) {
  /** @type {Note[]} */
  const notes = [];
  for (const [index, word] of text.split(/[\s,;]+/).filter(Boolean).entries()) {
    const parts = /^(r|[a-g](?:[#♯b♭])?-?\d)(?::(\d+))?$/i.exec(word);
    if (!parts) return { notes, fault: `Note ${index + 1} ("${word}") is unclear: write C5:16, F#4:8, or r:16 for a rest.` };
    const duration = Number(parts[2] ?? 16);
    const number = parts[1]?.toLowerCase() === "r" ? REST : numberOf(parts[1] ?? "");
    if (number !== REST && (number < 31 || number > 127)) return { notes, fault: `Note ${index + 1} ("${word}") is out of range: G1 to G9.` };
    if (duration < 1 || duration > 255) return { notes, fault: `Note ${index + 1} ("${word}") must last 1 to 255 sixty-fourths of a second.` };
    notes.push([number, duration]);
  }
  return notes.length > MOST ? { notes: notes.slice(0, MOST), fault: `A song has ${MOST} notes at most; these are ${notes.length}.` } : { notes, fault: "" };
}

/** @param {string} name */
function numberOf(name) {
  const letter = { c: 0, d: 2, e: 4, f: 5, g: 7, a: 9, b: 11 }[name.charAt(0).toLowerCase()] ?? 0;
  const sign = /[#♯]/.test(name) ? 1 : /.[b♭]/.test(name) ? -1 : 0;
  return 12 * (Number(/-?\d$/.exec(name)?.[0]) + 1) + letter + sign;
}

/** @param {import("./tab.js").ConnectionTab} it @returns {(view: import("./types").ConnectionView) => void} */
export function startSongs(it) {
  /** @type {string[]} */
  const songs = remembered();
  let slot = 0;
  let duration = 16;

  const slots = songs.map((_, index) => make("button", { type: "button", "aria-pressed": String(index === 0) }, `Song ${index + 1}`));
  const text = make("input", { type: "text", spellcheck: false, autocomplete: "off", "aria-label": "Notes", "aria-describedby": "song-told" });
  const told = make("p", { className: "note", id: "song-told", role: "status" });
  const lengths = make("select", { "aria-label": "Length of the next note" }, ...LENGTHS.map((value) => make("option", { value, selected: value === duration }, `${value}/64 s`)));
  const rest = make("button", { type: "button" }, "Rest");
  const back = make("button", { type: "button" }, "Delete last");
  const hear = make("button", { type: "button" }, "Listen here");
  const play = make("button", { type: "button", className: "primary" }, "Play on the robot");
  const keys = [];
  for (let note = FIRST; note <= LAST; note += 1) {
    const isBlack = (NAMES[note % 12] ?? "").length > 1;
    const key = make("button", { type: "button", className: isBlack ? "black" : "white", "aria-label": named(note) }, isBlack ? "" : note % 12 === 0 ? named(note) : "");
    key.addEventListener("click", () => add([note, duration]));
    keys.push(key);
  }
  const piano = make("div", { className: "piano", role: "group", "aria-label": "Piano: adds notes" }, ...keys);
  byId("connection-songs").append(
    make("div", { className: "connection-tools" }, make("div", { className: "segments", role: "group", "aria-label": "Song" }, ...slots), lengths, rest, back, hear, play),
    make("label", { className: "song-text" }, text),
    told,
    piano,
  );

  const read = () => readNotes(text.value);
  const tell = () => {
    const { notes, fault } = read();
    const seconds = notes.reduce((sum, [, length]) => sum + length, 0) / 64;
    setAttribute(text, "aria-invalid", String(fault !== ""));
    told.classList.toggle("fault", fault !== "");
    setText(told, fault || `${notes.length} of ${MOST} notes, ${seconds.toFixed(1)} s. Note, octave, and length in 1/64 s.`);
    return { notes, fault };
  };
  const store = () => {
    songs[slot] = text.value;
    keep(KEY, JSON.stringify(songs));
    tell();
  };
  const open = (/** @type {number} */ next) => {
    slot = next;
    text.value = songs[slot] ?? "";
    slots.forEach((node, index) => setAttribute(node, "aria-pressed", String(index === slot)));
    tell();
  };
  const add = (/** @type {Note} */ note) => {
    sound([note]);
    const { notes, fault } = read();
    if (fault || notes.length >= MOST) {
      setText(told, fault || `A song has ${MOST} notes at most: continue in the next one.`);
      return;
    }
    text.value = written([...notes, note]);
    store();
  };
  slots.forEach((node, index) => node.addEventListener("click", () => open(index)));
  text.addEventListener("input", store);
  lengths.addEventListener("change", () => (duration = Number(lengths.value)));
  rest.addEventListener("click", () => add([REST, duration]));
  back.addEventListener("click", () => {
    text.value = written(read().notes.slice(0, -1));
    store();
  });
  hear.addEventListener("click", () => {
    silence();
    sound(read().notes);
  });
  play.addEventListener("click", () => {
    const { notes, fault } = tell();
    if (!fault && notes.length > 0) void it.request({ do: "song", number: slot, notes });
  });
  open(0);
  return ({ can }) => setEnabled(play, can.drive);
}

/** @returns {string[]} */
function remembered() {
  try {
    const songs = JSON.parse(kept(KEY) ?? "null");
    if (Array.isArray(songs) && songs.length === FIRST_SONGS.length && songs.every((song) => typeof song === "string")) return songs;
  } catch {
    // Then those to begin with.
  }
  return [...FIRST_SONGS];
}
