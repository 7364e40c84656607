// @ts-check
// Numbers as people read them.

const whole = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });

/** @param {number} value */
export const count = (value) => whole.format(value);

/**
 * Minutes and seconds, with hours where there are any.
 * @param {number} seconds
 */
export function clock(seconds) {
  const total = Math.round(seconds);
  const [h, m, s] = [Math.floor(total / 3600), Math.floor(total / 60) % 60, total % 60];
  const two = (/** @type {number} */ n) => String(n).padStart(2, "0");
  return h > 0 ? `${h}:${two(m)}:${two(s)}` : `${m}:${two(s)}`;
}

/**
 * A share as a percentage; never 100.0 unless it is all.
 * @param {number} share 0 to 1
 */
export function percent(share, digits = 1) {
  const shown = Math.floor(share * 100 * 10 ** digits + 1e-6) / 10 ** digits;
  return shown.toFixed(digits);
}

/** An excess as a percentage; never 0.0 unless it is nothing. @param {number} share */
export const shareAbove = (share) => `${(perMilleAbove(share) / 10).toFixed(1)} %`;

/** The same in whole per mille: what looks alike is equal. @param {number} share */
export const perMilleAbove = (share) => Math.ceil(share * 1000 - 1e-6);

/** As metrics of lengths are shown. @param {number} metres */
export const metres = (metres) => metres.toLocaleString("en", { minimumFractionDigits: 1, maximumFractionDigits: 1 });

/**
 * A length of at most some metres, in the unit that suits it.
 * @param {number} metres
 */
export const smallLength = (metres) => (metres < 1 ? `${(metres * 100).toFixed(1)} cm` : `${metres.toFixed(2)} m`);

/**
 * How long something took to compute.
 * @param {number} seconds
 */
export function took(seconds) {
  if (seconds < 0.001) return "< 1 ms";
  return seconds < 1 ? `${(seconds * 1000).toFixed(0)} ms` : `${seconds.toFixed(1)} s`;
}

/**
 * How many times faster than the clock.
 * @param {number} factor
 */
export const pace = (factor) => (factor < 10 ? `${factor.toFixed(1)}×` : `${count(factor)}×`);

const ROUND = { down: (/** @type {number} */ scaled) => Math.floor(scaled + 1e-6), nearest: Math.round, up: (/** @type {number} */ scaled) => Math.ceil(scaled - 1e-6) };

/**
 * A metric's value as every table shows it, without its unit.
 * @param {import("./types").MetricInfo} metric
 * @param {number} value
 */
export function shown(metric, value) {
  const { decimals, rounding } = metric;
  const rounded = ROUND[rounding](value * 10 ** decimals) / 10 ** decimals;
  if (isClock(metric)) return clock(rounded);
  // No computation takes no time at all.
  if (metric.unit === "s" && rounded === 0) return `< ${10 ** -decimals}`;
  return rounded.toLocaleString("en", { minimumFractionDigits: decimals, maximumFractionDigits: decimals });
}

/** Whether values are times of a clock. @param {import("./types").MetricInfo} metric */
export const isClock = ({ unit, decimals }) => unit === "s" && decimals === 0;

/** What stands behind a value. @param {import("./types").MetricInfo} metric @param {number} most The largest shown with it. */
export const unitOf = (metric, most) => (isClock(metric) ? (most < 3600 ? "min:s" : "h:min:s") : metric.unit);
