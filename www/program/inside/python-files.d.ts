// scripts/bundles.mjs makes it of programs/python.
declare module "python-files" {
  const files: Record<string, string>;
  export default files;
}
