// @ts-check
// The frame that programs of users live in. Its origin is opaque, so nothing of the page's is its own: no storage, no
// ports, no document. Its policy forbids every request. Inside, a program runs in a worker that speaks to the page by one
// port; the frame only starts and ends workers. Browsers on computers give it a process of its own: memory that a program uses
// up breaks the frame, not the page, and another frame takes its place.

/** What the frame may do: run the scripts that it is handed, nothing else. Workers made in it inherit this. */
const policy = (/** @type {string} */ nonce) =>
  ["default-src 'none'", `script-src 'nonce-${nonce}' blob: 'unsafe-eval' 'wasm-unsafe-eval'`, "worker-src blob:", "form-action 'none'", "base-uri 'none'"].join("; ");

/** Runs in the frame, as text: it sees nothing of this module. */
function inside() {
  /** @type {Map<number, Worker>} */
  const workers = new Map();
  addEventListener("message", ({ source, data, ports }) => {
    if (source !== parent) return;
    if (data.asks) return parent.postMessage({ answers: data.asks }, "*");
    workers.get(data.id)?.terminate();
    workers.delete(data.id);
    if (!data.script) return;
    const address = URL.createObjectURL(new Blob([data.script], { type: "text/javascript" }));
    const worker = new Worker(address);
    worker.onerror = (event) => parent.postMessage({ id: data.id, broken: event.message || "it could not be started" }, "*");
    worker.postMessage(data.parts, [/** @type {MessagePort} */ (ports[0])]);
    workers.set(data.id, worker);
  });
  parent.postMessage({ ready: true }, "*");
}

/** A new frame, when it is ready. @returns {Promise<HTMLIFrameElement>} */
export function openFrame() {
  const nonce = crypto.randomUUID();
  const frame = document.createElement("iframe");
  frame.setAttribute("sandbox", "allow-scripts");
  frame.setAttribute("aria-hidden", "true");
  frame.title = "Sandbox of programs";
  frame.hidden = true;
  frame.srcdoc = `<!doctype html><meta http-equiv="Content-Security-Policy" content="${policy(nonce)}"><script nonce="${nonce}">(${inside})()</script>`;
  return new Promise((resolve) => {
    const ready = (/** @type {MessageEvent} */ { source, data }) => {
      if (source !== frame.contentWindow || data?.ready !== true) return;
      removeEventListener("message", ready);
      resolve(frame);
    };
    addEventListener("message", ready);
    document.body.append(frame);
  });
}

let lastAsked = 0;

/** Whether the frame is still there. @param {HTMLIFrameElement} frame @param {number} patience How long it has to answer, ms. @returns {Promise<boolean>} */
export function answers(frame, patience) {
  const asks = (lastAsked += 1);
  return new Promise((resolve) => {
    const end = (/** @type {boolean} */ does) => {
      clearTimeout(timer);
      removeEventListener("message", hear);
      resolve(does);
    };
    const hear = (/** @type {MessageEvent} */ { source, data }) => source === frame.contentWindow && data?.answers === asks && end(true);
    const timer = setTimeout(() => end(false), patience);
    addEventListener("message", hear);
    frame.contentWindow?.postMessage({ asks }, "*");
  });
}
