// Functions that are called in the page, to compare what comes out in different browsers.

/** Waits until the run is finished and its plan's bound is proven; the texts of all numbers but the times that planning took. */
export async function shown() {
  const texts = () => [...document.querySelectorAll("#metrics tr")].map((row) => [...row.cells].map((cell) => cell.textContent.trim()));
  const isBound = () => texts().every(([name, plan]) => name !== "Above the minimum" || plan !== "–");
  while (document.body.dataset.state !== "finished" || !isBound()) await new Promise((later) => setTimeout(later, 20));
  await new Promise((drawn) => requestAnimationFrame(() => requestAnimationFrame(drawn)));
  return texts().filter(([name]) => !/^(Planned in|Kept early)$/.test(name));
}

/** Ten minutes of a behaviour with slip and noise: what the session tells of it, and a hash of its curve of coverage. */
export async function reproduced() {
  const { default: init, Playground } = await import(new URL("page.js", location.href).href);
  await init();
  const playground = new Playground(document.createElement("canvas"));
  playground.restore("room=flat&behaviour=bounce&robot=roomba600&seed=42&slip=typical&noise=typical&speed=0");
  playground.play();
  let now = 0;
  while (playground.view().time_s < 600) playground.frame((now += 20));
  playground.pause();
  playground.seek(600);
  while (playground.view().state === "seeking") playground.frame((now += 20));
  // How fast this computer was is no part of it, nor how far it came beyond.
  const view = JSON.stringify({ ...playground.view(), speed_factor: 0, run_end_s: 0 });
  const curve = playground.coverage_curve();
  const points = curve.filter((value, i) => i % 2 === 0 && value <= 600).length;
  const words = new Uint32Array(curve.slice(0, 2 * points).buffer);
  return { view, points, hash: words.reduce((sum, word) => (Math.imul(sum, 31) + word) | 0, 0) };
}

/** A minute of an example in Python, in the sandbox: the digest of its simulation. */
export async function programmed() {
  const [{ default: init, Playground }, { work }] = await Promise.all(["page.js", "www/program/work.js"].map((name) => import(new URL(name, location.href).href)));
  await init();
  const playground = new Playground(document.createElement("canvas"));
  playground.restore("room=flat&behaviour=bounce&robot=roomba600&seed=42&slip=typical&noise=typical");
  const job = new TextEncoder().encode(JSON.stringify({ place: playground.snapshot(), inputs: [], version: 0 }));
  const source = await (await fetch(new URL("programs/examples/turn_when_you_bump.py", location.href))).text();
  return (await work({ program: { language: "python", source }, job, seconds: 60 })).digest;
}
