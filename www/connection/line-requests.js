// @ts-check
// What a connection asks of its line: bytes, a stop, the BRC line, another baud rate; in its order, at once.

/**
 * @typedef {import("../../workshop.js").Connection} Connection
 * @typedef {import("./types").Transport} Transport
 */

export class LineRequests {
  #connection;
  #broke;
  #goesOn;
  /** The line is about to go on at another baud rate. */
  #isChanging = false;

  /**
   * @param {Connection} connection
   * @param {(error: unknown) => void} broke The line doesn't do what it is asked for.
   * @param {() => void} goesOn The line has its baud rate: more may be asked.
   */
  constructor(connection, broke, goesOn) {
    this.#connection = connection;
    this.#broke = broke;
    this.#goesOn = goesOn;
  }

  /** @param {Transport | undefined} line */
  pass(line) {
    const connection = this.#connection;
    // Unsent bytes must not be sent later: a line that returns can lead to another robot.
    if (line?.view.state !== "open") return connection.discard();
    while (!this.#isChanging) {
      const wanted = connection.take_line();
      if (!wanted) {
        const bytes = connection.take_tx();
        if (!bytes.length) return;
        line.write(bytes, connection.is_acting());
      } else if (wanted === "stop") line.stop?.();
      else if ("brc" in wanted) line.setBrc(wanted.brc).catch(this.#broke);
      else this.#changeBaud(line, wanted.baud);
    }
  }

  /** @param {Transport} line @param {number} baud */
  async #changeBaud(line, baud) {
    this.#isChanging = true;
    try {
      await line.setBaud(baud);
    } catch (error) {
      return this.#broke(error);
    }
    this.#isChanging = false;
    this.#goesOn();
  }
}
