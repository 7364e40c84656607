// @ts-check
// Games on the floor: the card that they share, and what begins them: a link, or the list of things to try.
import { byId, make, setHidden } from "../dom.js";
import { style } from "../parts.js";
import { startVersus } from "./versus.js";
import { startWorst } from "./worst.js";

/**
 * @typedef {import("../main.js").App} App
 * @typedef {import("../types").PageView} View
 * @typedef {object} Card Where a game is played: over the floor.
 * @property {HTMLElement} node
 * @property {(title: string, ...parts: (Node | string)[]) => void} show
 * @property {() => void} close
 * @typedef {object} Game
 * @property {string} key Its key in links.
 * @property {() => void} offer
 * @property {(value: string) => void} follow Begins as a link asks for it.
 * @property {(view: View) => void} update Once a frame while it is played.
 * @property {() => void} end
 * @property {() => string} link What leads back to it.
 */

/** @type {ReturnType<typeof start> | undefined} */
let started;

/** @param {App} app */
const games = (app) => (started ??= start(app));

/** @param {App} app */
export async function offerVersus(app) {
  const { begin, games: all } = await games(app);
  begin(/** @type {Game} */ (all[0]));
}

/** @param {App} app */
export async function offerWorst(app) {
  const { begin, games: all } = await games(app);
  begin(/** @type {Game} */ (all[1]));
}

/** Begins the games that links ask for. @param {App} app @param {string} link The fragment of the address when that was found. @returns {Promise<(view: View) => void>} */
export async function startGames(app, link) {
  const { update, followed } = await games(app);
  followed(link);
  return update;
}

/** @param {App} app */
async function start(app) {
  await style(new URL("./try.css", import.meta.url).href);
  /** @type {Game | undefined} */
  let now;
  const title = make("h2", { id: "game-title", tabIndex: -1 });
  const close = make("button", { type: "button", className: "quiet square", "aria-label": "End the game" });
  close.append(/** @type {Node} */ (byId("message-close").firstElementChild).cloneNode(true));
  const inside = make("div", { className: "inside" });
  const node = make("section", { className: "message game", id: "game", "aria-labelledby": "game-title", hidden: true }, make("header", {}, title, close), inside);
  byId("welcome").before(node);
  const end = () => {
    now?.end();
    now = undefined;
    app.extra = "";
    setHidden(node, true);
  };
  close.addEventListener("click", () => {
    end();
    byId("floor").focus();
  });
  /** @type {Card} */
  const card = {
    node,
    show: (text, ...parts) => {
      title.textContent = text;
      inside.replaceChildren(...parts);
      setHidden(node, false);
    },
    close: end,
  };
  const all = [startVersus(app, card), startWorst(app, card)];
  /** @param {Game} game */
  const begin = (game) => {
    end();
    now = game;
    game.offer();
    title.focus();
  };
  let seen = "";
  /** Begins the game of a link, unless that is the one that is played. @param {string} hash */
  const followed = (hash) => {
    seen = hash;
    const pairs = new URLSearchParams(hash.slice(1));
    const asked = all.find(({ key }) => pairs.has(key));
    const value = pairs.get(asked?.key ?? "") ?? "";
    if (!asked || (asked === now && value === now.link())) return;
    begin(asked);
    asked.follow(value);
  };
  return {
    games: all,
    begin,
    followed,
    update: (/** @type {View} */ view) => {
      if (location.hash !== seen) followed(location.hash);
      if (!now) return;
      now.update(view);
      const link = now?.link() ?? "";
      app.extra = link && now ? `${now.key}=${link}` : "";
    },
  };
}

/** A button of a card. @param {string} label @param {() => unknown} what @param {string} [className] */
export const act = (label, what, className = "") => make("button", { type: "button", className, onclick: () => void what() }, label);

/** Sends what is shown. @param {App} app */
export async function send(app) {
  const { copyLink } = await import("./share.js");
  await copyLink(app);
}
