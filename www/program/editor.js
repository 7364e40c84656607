// @ts-check
// The editor of programs: CodeMirror with the page's colours, errors in their lines, the running line and breakpoints.
import * as cm from "../../codemirror.js";
import { leaveByTab } from "./tab-key.js";
import { breakpoints, breakpointsOf, setBreakpoints, toggleBreakpoint } from "./breakpoints.js";
import { help } from "./complete.js";

/** @typedef {"python" | "javascript"} Language */

/** Colours are those of the page, light and dark: www/style.css and program.css. */
const theme = cm.EditorView.theme({
  "&": { height: "100%", fontSize: "0.8125rem", color: "var(--text)", backgroundColor: "transparent" },
  "&.cm-focused": { outline: "none" },
  ".cm-scroller": { fontFamily: "var(--mono)", lineHeight: "1.5" },
  ".cm-content": { caretColor: "var(--text)", padding: "0.4rem 0" },
  ".cm-cursor": { borderLeftColor: "var(--text)" },
  ".cm-gutters": { backgroundColor: "transparent", color: "var(--text-2)", border: "0" },
  ".cm-activeLine, .cm-activeLineGutter": { backgroundColor: "color-mix(in srgb, var(--text) 5%, transparent)" },
  "&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground": { backgroundColor: "color-mix(in srgb, var(--accent) 24%, transparent)" },
  ".cm-running": { backgroundColor: "var(--running)" },
  ".cm-tooltip": { color: "var(--text)", backgroundColor: "var(--panel)", border: "1px solid var(--line)", borderRadius: "8px", boxShadow: "var(--shadow)" },
  ".cm-tooltip-autocomplete ul li[aria-selected]": { color: "var(--accent)", backgroundColor: "var(--accent-soft)" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul": { fontFamily: "var(--mono)", maxHeight: "14em" },
  ".cm-panels": { color: "var(--text)", backgroundColor: "var(--panel-2)" },
});

const { tags } = cm;
const colours = cm.HighlightStyle.define([
  { tag: [tags.keyword, tags.operatorKeyword, tags.controlKeyword, tags.definitionKeyword], color: "var(--code-keyword)" },
  { tag: [tags.string, tags.special(tags.string)], color: "var(--code-string)" },
  { tag: [tags.number, tags.bool, tags.null], color: "var(--code-number)" },
  { tag: tags.comment, color: "var(--code-comment)", fontStyle: "italic" },
  { tag: [tags.function(tags.definition(tags.variableName)), tags.function(tags.variableName)], color: "var(--code-function)" },
]);

/** @type {import("@codemirror/state").StateEffectType<number>} */
const run = cm.StateEffect.define();
const runningLine = cm.Decoration.line({ class: "cm-running" });
/** The line that runs, lit. */
const running = cm.StateField.define({
  create: () => cm.Decoration.none,
  update(lit, { docChanged, effects, state }) {
    for (const effect of effects) {
      if (!effect.is(run)) continue;
      const line = effect.value;
      return line >= 1 && line <= state.doc.lines ? cm.Decoration.set([runningLine.range(state.doc.line(line).from)]) : cm.Decoration.none;
    }
    return docChanged ? cm.Decoration.none : lit;
  },
  provide: (field) => cm.EditorView.decorations.from(field),
});

/** A double click takes a whole number, with its fraction. */
const wholeNumbers = cm.EditorView.domEventHandlers({
  dblclick(event, view) {
    const at = view.posAtCoords({ x: event.clientX, y: event.clientY });
    const node = at === null ? undefined : cm.syntaxTree(view.state).resolveInner(at);
    if (node?.name !== "Number") return;
    view.dispatch({ selection: { anchor: node.from, head: node.to } });
  },
});

const syntax = (/** @type {Language} */ language) => [
  language === "python" ? cm.python() : cm.javascript(),
  cm.indentUnit.of(language === "python" ? "    " : "  "),
  help(language),
];

/** Changes that were not typed. */
const isLoading = cm.Annotation.define();

export class Editor {
  #view;
  #language = new cm.Compartment();
  #line = 0;
  /** @type {Language} */
  language = "python";

  /** @param {HTMLElement} parent @param {{ changed(): void, run(): void, stop(): void, marked(): void }} tell */
  constructor(parent, tell) {
    const keys = cm.keymap.of([
      { key: "Mod-Enter", run: () => (tell.run(), true) },
      { key: "Mod-.", run: () => (tell.stop(), true) },
      { key: "F9", run: (view) => toggleBreakpoint(view) },
      // Escape, then Tab leaves the editor, for those who have no mouse.
      { key: "Escape", run: (view) => (view.contentDOM.blur(), document.getElementById("program-run")?.focus(), true) },
      ...cm.closeBracketsKeymap,
      ...cm.completionKeymap,
      ...cm.searchKeymap,
      ...cm.historyKeymap,
      cm.indentWithTab,
      ...cm.defaultKeymap,
    ]);
    // What closes before Escape leaves: completion and search.
    const closing = cm.Prec.high(cm.keymap.of([...cm.completionKeymap, ...cm.searchKeymap].filter(({ key }) => key === "Escape")));
    this.#extensions = [
      breakpoints(tell.marked),
      cm.history(),
      cm.drawSelection(),
      cm.EditorView.lineWrapping,
      cm.indentOnInput(),
      cm.bracketMatching(),
      cm.closeBrackets(),
      cm.autocompletion({ icons: false }),
      cm.highlightActiveLine(),
      cm.highlightActiveLineGutter(),
      cm.highlightSelectionMatches(),
      cm.syntaxHighlighting(colours),
      cm.tooltips({ parent: document.body }),
      leaveByTab,
      running,
      wholeNumbers,
      closing,
      keys,
      theme,
      cm.EditorView.contentAttributes.of({ "aria-label": "Program", "aria-description": "Tab moves on until you type; then it indents, and Escape leaves the editor.", autocapitalize: "off", spellcheck: "false" }),
      cm.EditorView.updateListener.of(({ docChanged, transactions }) => {
        if (docChanged && !transactions.some((one) => one.annotation(isLoading))) tell.changed();
      }),
    ];
    this.#view = new cm.EditorView({ parent, state: this.#state("", "python") });
  }

  /** @type {import("@codemirror/state").Extension[]} */
  #extensions;

  /** @param {string} doc @param {Language} language */
  #state(doc, language) {
    return cm.EditorState.create({ doc, extensions: [this.#extensions, this.#language.of(syntax(language))] });
  }

  get text() {
    return this.#view.state.doc.toString();
  }

  /** Shows another program, with an undo history of its own. @param {string} text @param {Language} language */
  open(text, language) {
    this.language = language;
    this.#line = 0;
    this.#view.setState(this.#state(text, language));
  }

  /** Replaces the text, so that it can be undone. @param {string} text */
  replace(text) {
    this.#view.dispatch({ changes: { from: 0, to: this.#view.state.doc.length, insert: text } });
  }

  /** Underlines what is wrong; `undefined` for nothing. @param {{ message: string, line: number, column?: number } | undefined} error */
  complain(error) {
    const { state } = this.#view;
    const diagnostics = [];
    if (error && error.line >= 1 && error.line <= state.doc.lines) {
      const line = state.doc.line(error.line);
      const indent = line.text.length - line.text.trimStart().length;
      const from = Math.min(line.to, line.from + Math.max(indent, (error.column ?? 0) - 1));
      diagnostics.push({ from, to: Math.max(line.to, from), severity: /** @type {const} */ ("error"), message: error.message });
    }
    this.#view.dispatch(cm.setDiagnostics(state, diagnostics));
  }

  /** Lights the line that runs; 0 for none. @param {number} line */
  light(line) {
    if (line === this.#line) return;
    this.#line = line;
    this.#view.dispatch({ effects: run.of(line) });
  }

  /** Shows a line. @param {number} number */
  show(number) {
    const { doc } = this.#view.state;
    if (number < 1 || number > doc.lines) return;
    this.#view.dispatch({ selection: { anchor: doc.line(number).from }, effects: cm.EditorView.scrollIntoView(doc.line(number).from, { y: "center" }) });
  }

  /** Lines to stop at, with their conditions. @returns {{ line: number, condition: string }[]} */
  get breakpoints() {
    return breakpointsOf(this.#view.state);
  }

  /** @param {{ line: number, condition: string }[]} points */
  set breakpoints(points) {
    setBreakpoints(this.#view, points);
  }

  focus() {
    this.#view.focus();
  }
}
