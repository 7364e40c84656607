// Put before the scripts of the page and of its workers by watched.mjs: what goes wrong is told to the web server, as not every
// browser tells its driver.
{
  const report = (what) => void fetch(`/problem?${encodeURIComponent(what)}`, { keepalive: true });
  addEventListener("error", ({ error, message, target }) => report(`uncaught: ${message ?? `${target.src ?? target.href} is missing`} ${error?.stack ?? ""}`), true);
  addEventListener("unhandledrejection", ({ reason }) => report(`unhandled: ${reason} ${reason?.stack ?? ""}`));
  const { error } = console;
  console.error = (...words) => {
    report(`console: ${words.map((word) => word instanceof Error ? `${word} ${word.stack}` : word).join(" ")}`);
    error.apply(console, words);
  };
}
