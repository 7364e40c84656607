// Resources that a process of the end-to-end tests has open. A hook of node:test that runs "after all" would come too
// early: after the tests of the process's first file.

/** @type {(() => Promise<unknown>)[]} Called when all files are done. */
export const ends = [];
