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
  const total = Math.floor(seconds + 1e-6);
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

/** @param {number} metres */
export const metres = (metres) => (metres < 100 ? metres.toFixed(1) : count(metres));

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
