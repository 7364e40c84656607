// @ts-check
// Games on the floor: the card that they share, and what begins them: a link, or the list of things to try.
import { byId, make, setHidden, setText } from "../dom.js";
import { style } from "../parts.js";
import { settingsOf } from "../settings-link.js";
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

/** Begins the games that links ask for. @param {App} app @returns {Promise<(view: View) => void>} */
export const startGames = (app) => games(app).then(({ update }) => update);

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
  byId("search-box").before(node);
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
      setText(title, text);
      inside.replaceChildren(...parts);
      setHidden(node, false);
    },
    close: end,
  };
  // The floor alone has no tools to draw with.
  const isAlone = document.documentElement.classList.contains("embed");
  const all = [startVersus(app, card), ...(isAlone ? [] : [startWorst(app, card)])];
  /** @param {Game} game @param {() => void} how */
  const begin = (game, how = game.offer) => {
    end();
    now = game;
    how();
    title.focus();
  };
  const asks = () => all.some(({ key }) => settingsOf(app.followed).has(key));
  /** The link that was followed last; one that asks for no game has nothing to say of one that was chosen meanwhile. */
  let seen = asks() ? "" : app.followed;
  /** Begins the game of the link that was followed. */
  const follow = () => {
    seen = app.followed;
    const pairs = settingsOf(seen);
    const asked = all.find(({ key }) => pairs.has(key));
    if (asked) begin(asked, () => asked.follow(pairs.get(asked.key) ?? ""));
    else end();
  };
  return {
    games: all,
    begin,
    update: (/** @type {View} */ view) => {
      if (app.followed !== seen) follow();
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
