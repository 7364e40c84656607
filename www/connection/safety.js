// @ts-check
// The last things that are done when nobody is there any more: the robot has no time limit on a command to drive, so what
// isn't stopped goes on. Nothing helps where this computer falls silent without a word: a page or browser that crashes or is
// killed (by the end of a user's session, too), a cable that is pulled out, a computer that loses power. What is left then is
// the robot itself: in Safe, it stops at a cliff or when it is lifted, but not at a wall.

/**
 * Bytes that stop a robot whatever it was doing: wheels (145), twice, since a command that lost bytes on its way swallows the
 * beginning of the next one; brushes and vacuum (138); then Passive (128). None of them moves anything.
 */
export const STOP = Uint8Array.of(145, 0, 0, 0, 0, 145, 0, 0, 0, 0, 138, 0, 128);

/** Bytes that stop the wheels and leave the mode as it is, for a driver that may be back at once. */
export const HALT = STOP.slice(0, 10);

/** How long a page that goes away waits for its workers, ms. */
const HOLD_MS = 100;

/** Pages that are left say so two or three times. */
const ONCE_MS = 500;

/**
 * Calls `leave` with the reason when the page is about to be left, is hidden, is left or is frozen; nothing that happens later brings
 * the robot back to life by itself. Returns what ends the watch.
 *
 * While the robot may be moving, a page that is about to be left (another address, reload, back, a closed tab or window, a
 * browser that quits) stops it and has the browser ask the user. Browsers ask only on pages that were clicked or typed on, and
 * not at all when another program ends them; the robot has been stopped by then in any case in which the page hears of it.
 *
 * A worker ends with its page, whether or not it has done what it was told last. So if the robot may be moving, the page
 * keeps its own end waiting: while a handler of these events runs, the browser neither ends the page nor its workers, and
 * those run on threads of their own. That is what the busy loop is for; there is no way to wait for an answer in such a
 * handler. A worker needs a few milliseconds to hear of it and write (LINK_ROUNDS=100 node tests/e2e/run.mjs connection-stop);
 * `HOLD_MS` leaves room for a slow or busy computer, and is too short to be noticed. Without, five of 36 pages that were
 * closed or left in Chromium left the robot driving.
 * @param {(why: string) => void} leave
 * @param {() => boolean} mayMove
 */
export function watchPage(leave, mayMove) {
  let held = -Infinity;
  const gone = (/** @type {string} */ why) => {
    const waits = mayMove();
    leave(why);
    const start = performance.now();
    if (!waits || start - held < ONCE_MS) return;
    while (performance.now() - start < HOLD_MS);
    held = performance.now();
  };
  const leaving = (/** @type {BeforeUnloadEvent} */ event) => {
    if (!mayMove()) return;
    gone("You were about to leave the page.");
    event.preventDefault();
    // What older browsers need instead.
    event.returnValue = true;
  };
  const watch = new AbortController();
  const { signal } = watch;
  // Capturing, so that no other handler of the page comes first or stops it.
  const options = { capture: true, signal };
  window.addEventListener("beforeunload", leaving, options);
  document.addEventListener("visibilitychange", () => document.visibilityState === "hidden" && gone("The page was hidden."), options);
  document.addEventListener("freeze", () => gone("The browser put the page to sleep."), options);
  window.addEventListener("pagehide", () => gone("The page was left."), options);
  return () => watch.abort();
}

/** Silence of a worker after which the other one acts, and after which it counts as gone, ms. */
const SILENT_MS = 140;
const GONE_MS = 1000;
/** The same in steps of the one who watches: if it was held up itself, the other's words are still on their way. */
const SILENT_TICKS = 3;
const GONE_TICKS = 20;

/** Whether another worker still shows signs of life, which it does every 10 ms. */
export class Watch {
  #heardAt = performance.now();
  #ticks = 0;

  heard() {
    this.#heardAt = performance.now();
    this.#ticks = 0;
  }

  /** To be called every 10 ms. */
  tick() {
    this.#ticks += 1;
  }

  get isSilent() {
    return this.#ticks >= SILENT_TICKS && performance.now() - this.#heardAt > SILENT_MS;
  }

  get isGone() {
    return this.#ticks >= GONE_TICKS && performance.now() - this.#heardAt > GONE_MS;
  }
}

/** From when on a worker that didn't run is taken for asleep, ms. */
const SLEEP_MS = 1000;

/** Whether the computer slept, or the browser stood still, and didn't mind the robot. */
export class SleepWatch {
  /** By the time of day: a worker's own clock may stand still while the computer sleeps, ms. */
  #ranAt = Date.now();

  /** Whether it slept before this moment. */
  hasSlept() {
    const slept = Date.now() - this.#ranAt > SLEEP_MS;
    this.awake();
    return slept;
  }

  /** A pause that ends here was no sleep. */
  awake() {
    this.#ranAt = Date.now();
  }
}

/**
 * Says when the page was alive, by a worker's clock, s: what is returned takes the time when a beat arrives there, and the
 * page's when it was sent. On a busy computer a beat may come late, and must not prolong a hung page's life by that. Both
 * clocks run alike but began at different times; the fastest beat so far tells by how much.
 * @returns {(arrived: number, sent: number) => number}
 */
export function startBeats() {
  let ahead = Infinity;
  return (arrived, sent) => {
    ahead = Math.min(ahead, arrived - sent);
    return sent + ahead;
  };
}
