// @ts-check
// JavaScript programs that would import something are refused.

/** Nothing can be fetched here, and a program that tries a thousand times a second would only keep the browser busy. @param {string} source @param {typeof import("@lezer/javascript").parser} parser */
export function refuseImports(source, parser) {
  parser.parse(source).iterate({
    enter({ name, from }) {
      if (name !== "DynamicImport" && name !== "ImportDeclaration" && name !== "ImportMeta") return;
      const before = source.slice(0, from);
      throw { message: "Programs can't import anything. Put all you need into this one.", line: before.split("\n").length, column: from - before.lastIndexOf("\n") - 1 };
    },
  });
}
