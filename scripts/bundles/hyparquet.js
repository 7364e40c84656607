// @ts-check
// What reads the results of a study, bundled to hyparquet.js: see scripts/bundles.mjs.
export { parquetMetadata, parquetReadObjects } from "hyparquet";
