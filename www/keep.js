// @ts-check
// Keeps the state over a reload: in the address; and in this browser rooms that were drawn or loaded. Every tab and every
// room is an entry of the browser's history.

/** @typedef {import("./main.js").App} App */

/** Own rooms, once there are any. @type {typeof import("./explore/own-rooms.js") | undefined} */
let own;
/** Whether the address was just followed: it may be written in another way, and is still the same place. */
let wasFollowed = true;
/** The fragment that was followed or written last. Another one in the address is on its way: back and forward change the
 * address before the page hears of it, and what is written in between would take the place of an entry of the history. */
let known = location.hash;
/** Whether the session on the page has been kept: before, it isn't anybody's. */
let hasKept = false;

const ownRooms = async () => (own ??= await import("./explore/own-rooms.js"));

/** @param {import("./main.js").App} app @param {string} link */
async function openRoomLink(app, link) {
  await ownRooms();
  return (await import("./explore/room-link.js")).openLink(app, link);
}

/** The page has heard of this fragment. @param {string} hash */
export const follow = (hash) => void (known = hash);

/** State of the history's entries that the page wrote: what they lead to may have been changed since. Links that are opened have none. */
export const WRITTEN = "written";

/** Writes the fragment of the address, which leads to what is shown. @param {string} hash @param {boolean} isElsewhere Whether that is another entry of the history. */
export function write(hash, isElsewhere = false) {
  history[isElsewhere ? "pushState" : "replaceState"](WRITTEN, "", hash);
  // As the browser writes it.
  known = location.hash;
}

/**
 * Restores the state of the address; an own room is read in a worker.
 * @param {App} app @param {string} link
 */
export async function restoreLink(app, link) {
  wasFollowed = true;
  const { is_shown, has_own_room, has_program } = app.playground.link_outline(link);
  // Back from another tab: the run goes on.
  if (hasKept && is_shown && (!has_own_room || link.split("&").includes(own?.pairOf(app) ?? ""))) return;
  const refusal = has_own_room ? await openRoomLink(app, link) : "";
  // The program has to be there before it is chosen.
  if (has_program) await holdProgram(app, link);
  // Robot and algorithm hold without it, too.
  app.act((p) => p.restore(link));
  if (refusal) app.act((p) => p.report_error(refusal));
}

/** @param {App} app @param {string} link */
async function holdProgram(app, link) {
  const { enterProgram } = await import("./program/enter.js");
  await (await enterProgram(app)).hold(link);
}

/** Keeps the state if it has changed. @param {App} app */
export function keepState(app) {
  if (location.hash !== known) return;
  let link = app.link();
  if (own) link = own.keep(app, link);
  else if (app.playground.link_outline(link).has_own_room) return void ownRooms();
  hasKept = true;
  const hash = link.startsWith("#") ? link : `#${link}`;
  const isElsewhere = !wasFollowed && place(hash) !== place(location.hash);
  wasFollowed = false;
  if (hash !== location.hash) write(hash, isElsewhere);
}

/** Undoes the last change of the room, also of one that is just coming back. @param {App} app */
export async function undo(app) {
  await own?.pastOf(app);
  if (app.view.can.undo) app.act((p) => p.undo());
}

/** Tab and room of a link. @param {string} hash */
function place(hash) {
  const pairs = new URLSearchParams(hash.slice(1));
  return ["tab", "room", "kept", "flat"].map((key) => pairs.get(key) ?? "").join();
}
