// @ts-check
// What a worker of the sandbox is made of: fetched once, by the page, because nothing can be fetched inside.

/** @typedef {import("./sandbox.js").Kit} Kit */

/** @type {Map<string, Promise<Uint8Array>>} */
const fetched = new Map();

/** @param {URL} address @returns {Promise<Uint8Array>} */
function bytes(address) {
  const { href } = address;
  let coming = fetched.get(href);
  if (!coming) {
    coming = fetch(address).then(async (response) => {
      if (!response.ok) throw new Error(`it could not be fetched (status ${response.status})`);
      return new Uint8Array(await response.arrayBuffer());
    });
    coming.catch(() => fetched.delete(href));
    fetched.set(href, coming);
  }
  return coming;
}

/** @param {import("./editor.js").Language} language @returns {Promise<Kit>} */
export async function kitFor(language) {
  const [script, simulator, micropython] = await Promise.all([
    bytes(new URL("../../sandbox.js", import.meta.url)),
    bytes(new URL("../../program_bg.wasm", import.meta.url)),
    language === "python" ? bytes(new URL("../../micropython.wasm", import.meta.url)) : undefined,
  ]);
  return { script: new TextDecoder().decode(script), parts: { simulator, micropython } };
}
