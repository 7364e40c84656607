// @ts-check
// Tunes by WebAudio. Browsers let a page sound once its user has done something.

/** Of a piano's A, and its MIDI number. */
const [A, A_NUMBER] = [440, 69];
/** Lowest note that isn't a rest, as in the Open Interface (opcode 140). */
const LOWEST = 31;

/** @type {AudioContext | undefined} */
let context;
let muted = false;
/** When what sounds now is over, s on the context's clock. */
let free = 0;

export const isMuted = () => muted;

/** @param {boolean} on */
export function hush(on) {
  muted = on;
  if (on) silence();
}

/** Ends all tunes. */
export function silence() {
  void context?.close();
  context = undefined;
  free = 0;
}

/** Plays notes of MIDI number and 1/64 s, behind what sounds already. @param {[note: number, duration: number][]} notes */
export function sound(notes) {
  if (muted || typeof AudioContext !== "function") return;
  context ??= new AudioContext();
  if (context.state === "suspended") void context.resume();
  let at = Math.max(free, context.currentTime + 0.02);
  for (const [note, duration] of notes) {
    const end = at + duration / 64;
    if (note >= LOWEST && note <= 127) tone(context, A * 2 ** ((note - A_NUMBER) / 12), at, end);
    at = end;
  }
  free = at;
}

/** @param {AudioContext} on @param {number} hertz @param {number} from @param {number} to */
function tone(on, hertz, from, to) {
  const [pitch, volume] = [on.createOscillator(), on.createGain()];
  // A robot's beeper is no flute.
  pitch.type = "square";
  pitch.frequency.value = hertz;
  volume.gain.setValueAtTime(0, from);
  volume.gain.linearRampToValueAtTime(0.05, from + 0.005);
  volume.gain.setValueAtTime(0.05, Math.max(from + 0.005, to - 0.015));
  volume.gain.linearRampToValueAtTime(0, to);
  pitch.connect(volume).connect(on.destination);
  pitch.start(from);
  pitch.stop(to);
}
