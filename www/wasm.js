// @ts-check
// Requirements of the program in the browser, and how its modules are fetched.

/** The missing features of this browser, as the end of a sentence; empty for none. */
export function missing() {
  if (typeof WebAssembly !== "object" || !WebAssembly.Module) return "WebAssembly, which some privacy modes switch off";
  if (typeof Worker !== "function") return "web workers";
  if (typeof OffscreenCanvas !== "function" || typeof Path2D !== "function") return "off-screen drawing";
  let modules = false;
  const probe = { get type() { modules = true; return /** @type {const} */ ("module"); } };
  try {
    new Worker("data:text/javascript,", probe).terminate();
  } catch {
    // It is enough that the browser read the type.
  }
  return modules ? "" : "module workers";
}

/** @param {URL} address @returns {Promise<WebAssembly.Module>} */
export async function compile(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the program could not be fetched (status ${response.status})`);
  // Some servers don't know the type of wasm files; streaming insists on it.
  if (response.headers.get("content-type")?.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
