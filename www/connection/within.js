// @ts-check
// Waiting that ends.

/** What `what` resolves to, or an error after `ms`. @template T @param {number} ms @param {Promise<T>} what @returns {Promise<T>} */
export function within(ms, what) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`no answer within ${ms / 1000} s`)), ms);
    what.then(resolve, reject).finally(() => clearTimeout(late));
  });
}
