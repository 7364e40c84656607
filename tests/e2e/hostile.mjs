// Programs that mean harm, by a seed: what they do, in which language, and where in the program they do it.

/** What does harm in JavaScript. `T` stands for an address that must never be asked, `N` for a number. */
const JAVASCRIPT = [
  "for (;;);",
  "while (true) try { null.x } catch {}",
  "do { } while (1 > 0)",
  "const all = []; for (;;) all.push(new Array(N).fill(1.5))",
  "const all = []; for (;;) all.push(new Uint8Array(N * 1000))",
  "let s = 'x'; for (;;) s += s",
  "'y'.repeat(1e7).split('').sort().join('')",
  "(function f() { return f() + f() })()",
  "throw 'z'.repeat(1e7)",
  "throw { get message() { for (;;); } }",
  "fetch('T')",
  "new XMLHttpRequest().open('GET', 'T')",
  "new WebSocket('T'.replace('http', 'ws'))",
  "new EventSource('T')",
  "navigator.sendBeacon('T')",
  "importScripts('T')",
  "eval('import(\"T\")')",
  "(0, eval)('fetch(\"T\")')",
  "Function('return fetch(\"T\")')()",
  "(() => {}).constructor('return import(\"T\")')()",
  "(async () => {}).constructor('await import(\"T\")')()",
  "import('T')",
  "new Worker('data:text/javascript,fetch(\"T\")')",
  "new SharedWorker('T')",
  "localStorage.setItem('hostile', 'N')",
  "indexedDB.open('hostile')",
  "caches.open('hostile')",
  "navigator.storage.getDirectory()",
  "navigator.serial.getPorts()",
  "navigator.usb.getDevices()",
  "navigator.hid.getDevices()",
  "parent.document.body.remove()",
  "top.location = 'T'",
  "for (let i = 0; i < N; i += 1) postMessage('x'.repeat(1000))",
  "for (;;) self.postMessage({ type: 'ran' })",
  "new BroadcastChannel('x').postMessage('y')",
  "new MessageChannel().port1.postMessage('x')",
  "self.close()",
  "Object.prototype.type = 'ready'; Object.prototype.more = true",
  "Object.defineProperty(Object.prototype, 'then', { get() { for (;;); } })",
  "Array.prototype.push = () => { for (;;); }",
  "Array.prototype[Symbol.iterator] = function* () { for (;;) yield 1 }",
  "Object.setPrototypeOf(robot, new Proxy({}, { get: () => robot }))",
  "Object.freeze(Object.prototype); Object.freeze(Array.prototype)",
  "JSON.parse = () => { for (;;); }; Float64Array.prototype.fill = null",
  "Promise.resolve().then(function again() { return Promise.resolve().then(again) })",
  "for (let i = 0; i < N; i += 1) print('p'.repeat(1e4))",
  "for (let i = 0; i < N; i += 1) robot.mark(i, i)",
  "robot.text(0, 0, 't'.repeat(1e7))",
  "robot.go(Infinity, NaN)",
  "robot.drive({ valueOf() { for (;;); } }, 0)",
  "/(a+)+$/.test('a'.repeat(60) + 'b')",
  "new WebAssembly.Memory({ initial: 65536 })",
  "structuredClone(new Array(N).fill('x'.repeat(1000)))",
  "Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0)",
  "BigInt(7) ** BigInt(N * 1000)",
];

/** The same in Python. */
const PYTHON = [
  "while True: pass",
  "while True:\n    try: raise ValueError\n    except: pass",
  "while True:\n    try:\n        while True: pass\n    finally: continue",
  "a = []\nwhile True: a.append(bytearray(N))",
  "s = 'x'\nwhile True: s += s",
  "x = 'y' * 10000000\nraise ValueError(x)",
  "def f(): return f() + f()\nf()",
  "import js\njs.fetch('T')",
  "__import__('js').fetch('T')",
  "import jsffi\njsffi.create_proxy(1)",
  "import socket\nsocket.socket()",
  "import os\nos.listdir('/')",
  "open('/etc/passwd').read()",
  "exec('while True: pass')",
  "eval('1+' * N + '1')",
  "2 ** (N * 1000)",
  "for i in range(N): print('p' * 10000)",
  "for i in range(N): robot.mark(i, i)",
  "robot.text(0, 0, 't' * 10000000)",
  "robot.drive(float('inf'), float('nan'))",
  "import sys\nsys.exit()",
  "import gc\ngc.disable()\na = [list(range(1000)) for i in range(N)]",
  "raise SystemExit",
  "raise KeyboardInterrupt",
  "robot.__class__.go = None",
  "class E(Exception):\n    def __str__(self):\n        while True: pass\nraise E()",
  "import time\ntime.sleep(1000)",
  "sorted(range(N), key=lambda x: [x] * N)",
];

const indent = (text, by) => text.replace(/^/gm, by);

/** Where in a program it is done. */
const PLACES = {
  javascript: [
    (what) => `function step(robot) {\n  ${what}\n}`,
    (what) => `const robot = {};\n${what};\nfunction step(robot) { robot.go(0.2) }`,
    (what) => `function* run(robot) {\n  yield robot.forward(0.1);\n  ${what};\n}`,
    (what) => `let n = 0;\nfunction step(robot) {\n  robot.go(0.2);\n  if ((n += 1) % 50 === 0) { try { ${what} } catch (e) { if (n > 500) throw e } }\n}`,
    (what) => `function plan(room) {\n  const robot = room;\n  ${what};\n  return [room.start];\n}`,
    (what) => `class Robot { get speed() { ${/robot/.test(what) ? "const robot = this; " : ""}${what}; return 1 } }\nfunction step(robot) { robot.go(new Robot().speed) }`,
  ],
  python: [
    (what) => `def step(robot):\n${indent(what, "    ")}\n`,
    (what) => `robot = None\n${what}\ndef step(robot):\n    robot.go(0.2)\n`,
    (what) => `def run(robot):\n    yield robot.forward(0.1)\n${indent(what, "    ")}\n`,
    (what) => `n = 0\ndef step(robot):\n    global n\n    n += 1\n    robot.go(0.2)\n    if n % 50 == 0:\n        try:\n${indent(what, "            ")}\n        except Exception:\n            if n > 500: raise\n`,
    (what) => `def plan(room):\n    robot = room\n${indent(what, "    ")}\n    return [room.start]\n`,
  ],
};

/** Programs without end: the same for the same seed. @param {number} seed @param {string} address One that must never be asked. */
export function* hostile(seed, address) {
  let state = seed >>> 0 || 1;
  const next = (count) => {
    // xorshift32
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) % count;
  };
  const any = (list) => list[next(list.length)];
  for (let index = 0; ; index += 1) {
    const language = next(3) ? "javascript" : "python";
    const what = any(language === "python" ? PYTHON : JAVASCRIPT).replaceAll("T", `${address}hostile-${index}`).replaceAll(/\bN\b/g, String(10 ** (3 + next(4))));
    yield { index, language, source: any(PLACES[language])(what) };
  }
}
