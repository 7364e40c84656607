// @ts-check
// The shelf of programs: examples and those that are kept here; new, renamed, duplicated, deleted, in and out as files.
import { button, input, make, select } from "../dom.js";
import { download, fileName } from "../files.js";
import { complain, textOf, toast } from "../messages.js";
import { startMenu } from "./menu.js";
import { endingOf, find, freeName, freshId, isOwn, list, put, readProgram, remove, trust } from "./own-programs.js";

/**
 * @typedef {import("./own-programs.js").Program} Program
 * @typedef {{ id: string, title: string, about: string, kind: string }} Example
 */

const FOLDER = new URL("../../programs/examples/", import.meta.url);

/** @param {string} name */
async function fetched(name) {
  const response = await fetch(new URL(name, FOLDER));
  if (!response.ok) throw new Error(`the examples could not be fetched (status ${response.status})`);
  return response;
}

export class Shelf {
  /** @type {Example[]} */
  #examples = [];
  #tell;
  /** @type {Program | undefined} */
  #current;
  /** @type {Program | undefined} */
  #deleted;

  /** @param {{ open(program: Program): void, share(): void }} tell */
  constructor(tell) {
    this.#tell = tell;
  }

  async begin() {
    this.#examples = await (await fetched("index.json")).json();
    select("program-list").addEventListener("change", () => void this.choose(select("program-list").value).catch((error) => complain(textOf(error))));
    this.#startMenu();
    return this;
  }

  get current() {
    return this.#current;
  }

  /** Opens a program by its id; says whether there is one. @param {string} id */
  async choose(id) {
    const program = isOwn(id) ? find(id) : await this.#example(id);
    if (program) this.show(program);
    return program !== undefined;
  }

  /** @param {string} id Of an example: its id, a dot, its language. */
  async #example(id) {
    const [name, wanted] = id.split(".");
    const example = this.#examples.find((one) => one.id === name);
    /** @type {"python" | "javascript"} */
    const language = wanted === "javascript" ? "javascript" : "python";
    if (!example) return undefined;
    const source = await (await fetched(example.id + endingOf(language))).text();
    return trust({ id: `${example.id}.${language}`, name: example.title, language, source });
  }

  /** The first one that a new user sees. */
  get first() {
    return `${this.#examples[0]?.id}.python`;
  }

  /** @param {Program} program */
  show(program) {
    this.#current = program;
    this.#tell.open(program);
    this.#fill();
  }

  /** The text was edited: an example becomes a program of one's own. @param {string} source */
  edit(source) {
    const known = this.#current;
    if (!known) return;
    this.#current = isOwn(known.id) ? { ...known, source } : { ...known, id: freshId(), name: freeName(known.name), source };
    put(this.#current);
    if (this.#current.id !== known.id) this.#fill();
  }

  /** Keeps a program that came from elsewhere, and shows it. @param {Program} program */
  add(program) {
    const same = list().find((one) => one.language === program.language && find(one.id)?.source === program.source);
    const kept = same ? find(same.id) : undefined;
    if (!kept) put(program);
    this.show(kept ? { ...kept, isForeign: kept.isForeign ?? false } : program);
  }

  #fill() {
    const menu = select("program-list");
    const group = (/** @type {string} */ label, /** @type {[string, string][]} */ options) =>
      options.length ? [make("optgroup", { label }, ...options.map(([value, text]) => make("option", { value }, text)))] : [];
    const examples = (/** @type {"python" | "javascript"} */ language) =>
      this.#examples.map(({ id, title }) => /** @type {[string, string]} */ ([`${id}.${language}`, title]));
    const own = list().map(({ id, name, language }) => /** @type {[string, string]} */ ([id, name + endingOf(language)])).reverse();
    menu.replaceChildren(...group("Your programs", own), ...group("Examples in Python", examples("python")), ...group("Examples in JavaScript", examples("javascript")));
    const id = this.#current?.id ?? "";
    if (![...menu.options].some(({ value }) => value === id) && this.#current) menu.prepend(make("option", { value: id }, this.#current.name));
    menu.value = id;
    const isKept = isOwn(id);
    for (const name of ["program-rename", "program-delete"]) button(name).disabled = !isKept;
    button("program-restore").hidden = !this.#deleted;
    button("program-restore").textContent = `Bring back ${this.#deleted?.name ?? ""}`;
  }

  #startMenu() {
    const picker = input("program-file");
    startMenu({
      "program-rename": () => this.#rename(),
      "program-duplicate": () => {
        if (!this.#current) return;
        const copy = { ...this.#current, id: freshId(), name: freeName(`${this.#current.name} copy`) };
        put(copy);
        this.show(copy);
      },
      "program-new-python": () => this.#new("python"),
      "program-new-javascript": () => this.#new("javascript"),
      "program-delete": () => this.#delete(),
      "program-restore": () => {
        const program = this.#deleted;
        this.#deleted = undefined;
        if (program) put(program), this.show(program);
      },
      "program-export": () => this.#current && download(fileName(this.#current.name) + endingOf(this.#current.language), this.#current.source, "text/plain"),
      "program-import": () => picker.click(),
      "program-share": () => this.#tell.share(),
    });
    picker.addEventListener("change", () => {
      void this.take([...(picker.files ?? [])]);
      picker.value = "";
    });
    button("program-new").addEventListener("click", () => this.#new());
  }

  /** Takes files with programs; says whether it worked. @param {File[]} files */
  async take(files) {
    try {
      for (const file of files) this.add(await readProgram(file));
      return true;
    } catch (error) {
      complain(textOf(error));
      return false;
    }
  }

  #new(language = this.#current?.language ?? "python") {
    const source =
      language === "python"
        ? "# Called every 15 ms: read the sensors, then drive.\ndef step(robot):\n    if robot.bump:\n        robot.go(0, 90)\n    else:\n        robot.go(0.2, 0)\n"
        : "// Called every 15 ms: read the sensors, then drive.\nfunction step(robot) {\n  if (robot.bump) robot.go(0, 90);\n  else robot.go(0.2, 0);\n}\n";
    const program = { id: freshId(), name: freeName("My program"), language, source };
    put(program);
    this.show(program);
    toast(`New program in ${language === "python" ? "Python" : "JavaScript"}`);
  }

  #rename() {
    const program = this.#current;
    if (!program || !isOwn(program.id)) return;
    const menu = select("program-list");
    const box = make("input", { type: "text", value: program.name, maxLength: 60, "aria-label": `New name of ${program.name}` });
    let isOpen = true;
    const end = (/** @type {boolean} */ isTaken) => {
      if (!isOpen) return;
      isOpen = false;
      const name = box.value.trim();
      if (isTaken && name && this.#current?.id === program.id) {
        this.#current = { ...this.#current, name: freeName(name, program.id) };
        put(this.#current);
      }
      box.replaceWith(menu);
      this.#fill();
      menu.focus();
    };
    box.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== "Escape") return;
      event.preventDefault();
      event.stopPropagation();
      end(event.key === "Enter");
    });
    box.addEventListener("blur", () => end(true));
    menu.replaceWith(box);
    box.focus();
    box.select();
  }

  #delete() {
    const program = this.#current;
    if (!program || !isOwn(program.id)) return;
    this.#deleted = program;
    remove(program.id);
    toast(`${program.name} deleted; the menu brings it back`);
    const next = list().at(-1)?.id;
    return this.choose(next ?? this.first);
  }
}
