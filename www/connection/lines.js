// @ts-check
// The lines that a robot can be at the other end of.
import { SerialLine } from "./serial.js";
import { SocketLine } from "./socket.js";
import { VirtualLine } from "./virtual.js";

/**
 * A line that isn't open yet. Throws a `Failure`.
 * @param {import("./types").WorkerTarget} target
 * @param {import("../../workshop.js").SessionMirror} mirror the room of the virtual robot
 * @param {import("./types").TransportEvents} events
 */
export function lineTo(target, mirror, events) {
  if (target.kind === "virtual") return new VirtualLine(mirror, target.personality, events);
  return target.kind === "serial" ? new SerialLine(target.address, events) : new SocketLine(target.url, events);
}
