// @ts-check
// The user's program drives a connected robot: from the sandbox, it answers to the readings of each step. The driver's rules
// hold as for every other: speeds are limited, and without an answer for 200 ms the robot stops.
import { make } from "../dom.js";
import { style } from "../parts.js";
import { Given } from "./endless.js";
import { endOf } from "./faults.js";
import { kitFor } from "./kit.js";
import { isTrusted } from "./own-programs.js";
import { Inmate } from "./sandbox.js";
import { work } from "./work.js";

/** The one that drives, or did. @type {Inmate | undefined} */
let inmate;
let lastId = 0;
/** Texts that were shown and confirmed since the page was opened. @type {Set<string>} */
const allowed = new Set();

/** The plan of the program, for the place of a request. @param {{ name: string, language: "python" | "javascript", source: string }} program @param {{ place?: object }} request */
export async function planned(program, { place }) {
  const job = new TextEncoder().encode(JSON.stringify({ place, inputs: [], version: 0 }));
  const plan = await work({ program, job, seconds: 0 });
  if (!("cells" in plan)) throw "this program drives but doesn't plan";
  return plan;
}

/** A program that came from elsewhere drives a robot only after its text was shown. @param {{ name: string, source: string } | undefined} program */
export async function isAllowed(program) {
  if (!program || isTrusted(program.source) || allowed.has(program.source)) return true;
  const isConfirmed = await confirmed(program);
  if (isConfirmed) allowed.add(program.source);
  return isConfirmed;
}

/**
 * Gets the program ready.
 * @param {import("../main.js").App} app @param {import("../connection/client.js").ConnectionClient} connection @param {(text: string) => void} complain
 * @returns {Promise<boolean>} Whether it is ready.
 */
export async function pilot(app, connection, complain) {
  const program = app.playground.program();
  if (!program) return complain("There is no program any more. Choose one in the tab Program."), false;
  if (!(await isAllowed(program))) return false;
  const facts = await connection.facts();
  if (!facts) return complain("The robot doesn't fit into the room."), false;
  inmate?.end();
  const kit = await kitFor(program.language);
  const id = (lastId += 1);
  const given = new Given();
  /** @type {Extract<import("./types").ToWorker, { type: "load" }>} */
  const load = { type: "load", id, language: program.language, source: program.source, job: app.playground.program_job(), traced: false, breakpoints: [], from: 0, facts };
  return new Promise((resolve) => {
    const fail = (/** @type {string} */ text) => {
      complain(text);
      connection.answer(NaN, NaN);
      mine.end();
      resolve(false);
    };
    const mine = new Inmate(
      kit,
      (message) => {
        if (!("id" in Object(message)) || /** @type {{ id: number }} */ (message).id !== id) return;
        if (message.type === "loaded") {
          if (message.kind === "plan") return fail("This program plans but doesn't drive: choose a behaviour.");
          resolve(true);
        } else if (message.type === "drive") {
          if (message.isDone === true) mine.end();
          connection.answer(message.isDone === true ? NaN : Number(message.left), Number(message.right));
        } else if (message.type === "failed") fail(failure(message));
      },
      (why, text) => {
        fail(`${endOf(why, text, 0).message} The robot was stopped.`);
        // The robot rests. Where it never ended is told as soon as it is known, unless another run began.
        if (why === "silent") void given.again(load).then((message) => message && inmate === mine && complain(failure(message)));
      },
    );
    inmate = mine;
    connection.onreadings = (readings) => {
      if (!mine.isAlive) return;
      given.keep(readings);
      mine.ask({ type: "sense", id, readings });
    };
    mine.ask(load);
  });
}

/** @param {Extract<import("./types").FromWorker, { type: "failed" }>} said */
const failure = ({ line, message }) => `The program failed${Number(line) ? ` in line ${Number(line)}` : ""}: ${String(message).slice(0, 500)}. The robot was stopped.`;

/** Shows the text, and asks. @param {{ name: string, source: string }} program @returns {Promise<boolean>} */
async function confirmed({ name, source }) {
  await style(new URL("./program.css", import.meta.url).href);
  const yes = make("button", { type: "submit", value: "yes" }, "Let it drive the robot");
  const no = make("button", { type: "submit", value: "no", className: "primary" }, "Cancel");
  const dialog = make(
    "dialog",
    { className: "program-confirm", "aria-labelledby": "program-confirm-title" },
    make("form", { method: "dialog" }, make("h2", { id: "program-confirm-title" }, `Let “${name}” drive the robot?`), make("p", {}, "It came from a link or a file. Read what it does:"), make("pre", { tabIndex: 0 }, source), make("div", { className: "row" }, no, yes)),
  );
  document.body.append(dialog);
  dialog.showModal();
  return new Promise((resolve) =>
    dialog.addEventListener("close", () => {
      dialog.remove();
      resolve(dialog.returnValue === "yes");
    }),
  );
}
