// @ts-check
// Random numbers from the run's seed: the same sequence as programs/python/robovac_program/chance.py.

const M1 = 4294967087;
const M2 = 4294944443;

/** The remainder that isn't negative. @param {number} value @param {number} by */
const modulo = (value, by) => {
  const rest = value % by;
  return rest < 0 ? rest + by : rest;
};

/** L'Ecuyer's MRG32k3a: numbers between 0 and 1, neither of them. @param {number} seed a whole number from 0 to 2^53 - 1 */
export function chance(seed) {
  const low = seed % 4294967296;
  const high = Math.floor(seed / 4294967296);
  let [a0, a1, a2, b0, b1, b2] = [low % M1, high, 12345, low % M2, high, 67890];
  const next = () => {
    const a = modulo(1403580 * a1 - 810728 * a0, M1);
    [a0, a1, a2] = [a1, a2, a];
    const b = modulo(527612 * b2 - 1370589 * b0, M2);
    [b0, b1, b2] = [b1, b2, b];
    return (a > b ? a - b : a - b + M1) * 2.328306549295728e-10;
  };
  // Sequences of neighbouring seeds start alike.
  for (let index = 0; index < 24; index++) next();
  return next;
}
