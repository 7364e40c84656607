// @ts-check
// Runs in a worker of the sandbox: a program and the simulation that it drives, in slices, so that messages are heard in
// between. What crosses to the page is the log of what the program commanded, and what it printed and drew.
import { parser } from "@lezer/javascript";
import { load } from "../../../programs/javascript/runtime.js";
import files from "python-files";
import { initSync, ProgramRunner } from "../../../program.js";
import { harden } from "./harden.js";
import { Job } from "./job.js";

/** @typedef {import("../types").ToWorker} ToWorker */

self.onmessage = ({ data, ports }) => {
  self.onmessage = null;
  const port = /** @type {MessagePort} */ (ports[0]);
  // All that is needed from here on is taken before programs can change it.
  const send = port.postMessage.bind(port);
  const clock = performance.now.bind(performance);
  const loop = new MessageChannel();
  const again = loop.port2.postMessage.bind(loop.port2, 0);
  const { memory } = initSync({ module: data.simulator });
  const kit = { load, parser, micropython: { wasm: data.micropython, files }, memory, ProgramRunner, clock };
  /** @type {Job | undefined} */
  let job;
  loop.port1.onmessage = () => void job?.slice();
  port.onmessage = async (/** @type {MessageEvent<ToWorker>} */ { data: message }) => {
    if (message.type === "load") {
      job?.close();
      job = new Job(kit, message, send, again);
      await job.begin();
    } else job?.hear(message);
  };
  harden();
  send({ type: "ready" });
};
