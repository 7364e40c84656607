// @ts-check
/// <reference path="./python-files.d.ts" />
// Runs in a worker of the sandbox: a program and the simulation that it drives, in slices, so that messages are heard in
// between. What crosses to the page is the log of what the program commanded, and what it printed and drew.
import { parser } from "@lezer/javascript";
import { load } from "../../../programs/javascript/runtime.js";
import files from "python-files";
import { initSync, ProgramRunner } from "../../../program.js";
import { harden } from "./harden.js";
import { Job } from "./job.js";
import { Rooms } from "./rooms.js";

/** @typedef {import("../types").ToWorker} ToWorker */

self.onmessage = ({ data, ports }) => {
  self.onmessage = null;
  const port = /** @type {MessagePort} */ (ports[0]);
  // All that is needed from here on is taken before programs can change it.
  const post = port.postMessage.bind(port);
  let heard = 0;
  const send = (/** @type {import("../types").FromWorker} */ message, /** @type {Transferable[]} */ transfer = []) => {
    message.heard = heard;
    post(message, transfer);
  };
  const clock = performance.now.bind(performance);
  const loop = new MessageChannel();
  const again = loop.port2.postMessage.bind(loop.port2, 0);
  const { memory } = initSync({ module: data.simulator });
  const micropython = data.micropython ? { wasm: new WebAssembly.Module(data.micropython), files } : undefined;
  /** @type {Job | undefined} */
  let job;
  loop.port1.onmessage = () => void job?.slice();
  const hear = async (/** @type {ToWorker} */ message) => {
    heard += 1;
    if (message.type === "load") {
      job?.close();
      job = new Job(kit, message, send, again);
      await job.begin();
    } else if (!job?.hear(message)) send({ type: "busy", id: message.id });
  };
  // What follows a load waits for it.
  let turn = Promise.resolve();
  port.onmessage = (/** @type {MessageEvent<ToWorker>} */ { data }) => void (turn = turn.then(() => hear(data)));
  const kit = { load, parser, micropython, memory, ProgramRunner, rooms: new Rooms(ProgramRunner), clock, allowText: harden() };
  send({ type: "ready" });
};
