// @ts-check
// The lines that a robot can be at the other end of.
import { RemoteLine } from "./remote-line.js";
import { VirtualLine } from "./virtual.js";

/**
 * A line that isn't open yet. Throws a `Failure`.
 * @param {import("./types").WorkerTarget} target
 * @param {import("../../workshop.js").SessionMirror} mirror the room of the virtual robot
 * @param {MessagePort} holder the worker that holds real lines
 * @param {import("./types").TransportEvents} events
 */
export function lineTo(target, mirror, holder, events) {
  if (target.kind === "virtual") return new VirtualLine(mirror, target.personality, events);
  return new RemoteLine(holder, target, events);
}
