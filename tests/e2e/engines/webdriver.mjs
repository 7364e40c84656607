// A WebDriver session over HTTP, for the commands that these tests need. https://www.w3.org/TR/webdriver2/
const COMMANDS = {
  Navigate: () => ["POST", "url"],
  Refresh: () => ["POST", "refresh"],
  SetTimeouts: () => ["POST", "timeouts"],
  SetWindowRect: () => ["POST", "window/rect"],
  ExecuteAsyncScript: () => ["POST", "execute/async"],
  FindElement: () => ["POST", "element"],
  ElementClick: ({ id }) => ["POST", `element/${id}/click`],
  ElementSendKeys: ({ id }) => ["POST", `element/${id}/value`],
  PerformActions: () => ["POST", "actions"],
  TakeScreenshot: () => ["GET", "screenshot"],
  DeleteSession: () => ["DELETE", ""],
};

async function call(url, method, body) {
  const response = await fetch(url, { method, body: method === "POST" ? JSON.stringify(body) : undefined, headers: { connection: "close" } });
  const { value } = await response.json();
  if (!response.ok) throw new Error(`${value.error}: ${value.message}`);
  return value;
}

/** Starts a session at the driver with this address; `send(name, parameters)` then resolves to what the command returns. */
export async function connect(driver, capabilities) {
  const { sessionId } = await call(`${driver}/session`, "POST", { capabilities: { alwaysMatch: capabilities } });
  return (name, parameters = {}) => {
    const [method, path] = COMMANDS[name](parameters);
    return call(`${driver}/session/${sessionId}${path && `/${path}`}`, method, parameters);
  };
}
