// What the drivers of USB adapters write to emulated chips, and where WebUSB is offered; without a browser.
import assert from "node:assert/strict";
import { test } from "node:test";
import { supportIn } from "../../www/connection/support.js";
import { rateRegisters } from "../../www/connection/usb/ch340.js";
import { chipOf } from "../../www/connection/usb/chips.js";
import { DeviceControl } from "../../www/connection/usb/control.js";
import { divisor } from "../../www/connection/usb/ftdi.js";
import { CHIPS, Ch340, Cp210x, Ftdi, Pl2303, make } from "./serial/usb-chips.mjs";

const has = (chip, transfer) => assert.ok(chip.log.some((one) => JSON.stringify(one) === JSON.stringify(transfer)), `${JSON.stringify(transfer)} isn't in ${JSON.stringify(chip.log)}`);

/** Has a driver make an emulated chip ready, without a browser. */
async function start(chip, baud) {
  const { interfaces, ...info } = chip.info;
  const ask = async ({ requestType, recipient, request, value, index }, direction, data) => {
    const type = direction | ({ standard: 0, class: 1, vendor: 2 }[requestType] << 5) | { device: 0, interface: 1 }[recipient];
    return chip.control(type, request, value, index, data);
  };
  const device = {
    ...{ ...info, configuration: { interfaces }, clearHalt: async () => {} },
    controlTransferOut: (setup, data) => ask(setup, 0, data),
    controlTransferIn: async (setup, length) => {
      const { status, data } = await ask(setup, 0x80);
      return { status, data: data && new DataView(Uint8Array.from(data.slice(0, length)).buffer) };
    },
  };
  await chipOf(device).start(new DeviceControl(device, { in: 1, out: 2 }), baud);
}

test("divisors for the rates of a robot", () => {
  const fits = (actual, rates) => assert.deepEqual(rates.map(([baud]) => [baud, actual(baud)]), rates);
  // FTDI, AN232B-05: 3 MHz / 26; 156.25; 52.125 for 57600; 78.125; 312.5; 208.375, whose code is 4 in bits 16 to 14.
  fits(divisor, [[115_200, 0x001a], [19_200, 0x809c], [57_600, 0xc034], [38_400, 0xc04e], [9600, 0x4138], [14_400, 0x100d0]]);
  // Linux, ch341.c, ch341_get_divisor(): 256 - 52 with prescaler 3; 256 - 39 with 2.
  const rates = [[115_200, 0xcc03], [19_200, 0xd902], [57_600, 0x9803], [38_400, 0x6403], [9600, 0xb202], [300, 0xd900]];
  fits((baud) => rateRegisters(baud, false), rates);
  fits((baud) => rateRegisters(baud, true), rates);
});

const line = (...rate) => [0x21, 0x20, 0, 0, [...rate, 0, 0, 8]];
/**
 * What is written to the chips: [type, request, value, index, data]. Figures are those of the chips' documentation and of
 * Linux's drivers, see www/connection/usb/.
 */
const RATES = {
  FTDI: { 115_200: [0x40, 3, 0x001a, 0], 57_600: [0x40, 3, 0xc034, 0], 19_200: [0x40, 3, 0x809c, 0] },
  CP210x: { 115_200: [0x41, 0x1e, 0, 0, [0x00, 0xc2, 0x01, 0]], 57_600: [0x41, 0x1e, 0, 0, [0x00, 0xe1, 0, 0]], 19_200: [0x41, 0x1e, 0, 0, [0x00, 0x4b, 0, 0]] },
  CH340: { 115_200: [0x40, 0x9a, 0x1312, 0xcc83], 57_600: [0x40, 0x9a, 0x1312, 0x9883], 19_200: [0x40, 0x9a, 0x1312, 0xd982] },
  PL2303: { 115_200: line(0x00, 0xc2, 0x01, 0), 57_600: line(0x00, 0xe1, 0, 0), 19_200: line(0x00, 0x4b, 0, 0) },
};
const VERSIONS = {
  "FT232B without a serial number": [() => make(Ftdi, { bcdDevice: 0x200, serialNumber: null }), [0x40, 3, 0x001a, 0]],
  "FT231X, whose index has the port in its low byte": [() => make(Ftdi, { idProduct: 0x6015, bcdDevice: 0x1000 }), [0x40, 3, 0x001a, 0]],
  "early CP2102, which has divisors: 3.6864 MHz / 32": [() => make(Cp210x, {}, { isEarly: true }), [0x41, 0x01, 32, 0]],
  "early CH340, which has no line control, and bit 7 the other way": [() => make(Ch340, {}, { version: 0x27, isLimited: true }), [0x40, 0x9a, 0x1312, 0xcc03]],
  "the first PL2303": [() => make(Pl2303, { maxPacketSize0: 8, bcdDevice: 0x202 }), [0x40, 1, 2, 0x24]],
  "PL2303TA, numbered like a GT": [() => make(Pl2303, { bcdUSB: 0x200 }), [0x40, 1, 2, 0x44]],
  "PL2303GT, which has requests of its own": [() => make(Pl2303, { bcdUSB: 0x200, idProduct: 0x23c3, bcdDevice: 0x305 }, { isHxn: true }), [0x40, 0x80, 0x0a, 0x7d]],
};

test("each chip is set to 8N1 at the rates of a robot, with RTS off and DTR on", async () => {
  for (const [kind, rates] of Object.entries(RATES)) {
    for (const [baud, transfer] of Object.entries(rates)) {
      const chip = new CHIPS[kind]();
      await start(chip, Number(baud));
      has(chip, transfer);
      assert.ok(Math.abs(chip.baud / baud - 1) < 0.005, `${kind}: ${chip.baud} for ${baud} baud`);
      assert.deepEqual([chip.isReady, chip.rts, chip.dtr], [true, false, true], kind);
    }
  }
});

test("other versions of the chips are made ready as they need it", async () => {
  for (const [version, [makeChip, transfer]] of Object.entries(VERSIONS)) {
    const chip = makeChip();
    await start(chip, 115_200);
    has(chip, transfer);
    assert.deepEqual([chip.isReady, chip.rts, chip.dtr], [true, false, true], version);
  }
});

test("two bytes of status at the head of each of FTDI's packets are no data", () => {
  const errors = [];
  const packet = (status, count) => [1, status, ...Array(count).fill(count)];
  const data = Uint8Array.from([...packet(0x60, 62), ...packet(0x62, 62), ...packet(0x68, 3)]);
  const bytes = chipOf(new Ftdi().info).unpack(data, 64, (error) => errors.push(error));
  assert.deepEqual([...bytes], [...Array(124).fill(62), 3, 3, 3]);
  assert.deepEqual(errors, ["overrun", "framing"]);
  // What repeats the errors of the packet before counts for nothing.
  assert.equal(chipOf(new Ftdi().info).unpack(Uint8Array.of(1, 0x68), 64, () => assert.fail()).length, 0);
});

test("WebUSB is offered where Web Serial is missing, and on Android, and nowhere else", () => {
  const desktop = { isSecure: true, serial: "here", usb: "here", isAndroid: false, isApple: false, socket: true };
  const offers = (browser) => {
    const { serial, usb, why } = supportIn({ ...desktop, ...browser });
    return [serial, usb, why === ""];
  };
  assert.deepEqual(offers({}), [true, false, true], "Chrome on a computer");
  assert.deepEqual(offers({ usb: "absent" }), [true, false, true], "Firefox 151 on a computer");
  assert.deepEqual(offers({ serial: "absent", isAndroid: true }), [false, true, true], "Chrome on Android");
  assert.deepEqual(offers({ isAndroid: true }), [true, true, true], "Chrome 148 on Android");
  assert.deepEqual(offers({ serial: "forbidden", isAndroid: true }), [false, true, true]);
  assert.deepEqual(offers({ serial: "absent" }), [false, true, true], "a browser without Web Serial");
  assert.deepEqual(offers({ serial: "forbidden" }), [false, false, false], "who forbids serial ports means all of them");
  assert.deepEqual(offers({ serial: "absent", usb: "forbidden", isAndroid: true }), [false, false, false]);
  assert.deepEqual(offers({ serial: "absent", usb: "absent", isApple: true }), [false, false, false]);
  assert.deepEqual(offers({ isSecure: false, isAndroid: true }), [false, false, false]);
});
