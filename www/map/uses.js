// @ts-check
// Uses of the map: as the room of Explore, as files for other programs; or dropping it.
import { button, byId, changed, fill, input, select, setEnabled, setHidden, setText } from "../dom.js";
import { download, fileName } from "../files.js";
import { clock, percent } from "../format.js";
import { complain, textOf, toast } from "../messages.js";

/**
 * @param {import("./tab.js").MapTab} it
 * @param {ReturnType<typeof import("./keep.js").startKeeping>} keeping
 */
export function startUses(it, keeping) {
  const { app, session } = it;
  button("map-room-use").addEventListener("click", () => {
    keeping.save();
    // The map is made before anything of Explore is touched.
    if (!app.act((p) => p.take_map(session.room()))) return;
    toast("The map is now the room in Explore");
    byId("tab-explore").click();
  });
  button("map-export").addEventListener("click", () => {
    /** @type {{ name: string, bytes: Uint8Array<ArrayBuffer>, kind: string }[]} */
    let files = [];
    if (!app.act(() => (files = session.ros_map(`${fileName(it.view.title)}-mapped`)))) return;
    for (const { name, bytes, kind } of files) download(name, bytes, kind);
    toast("Saved as a ROS map: image and YAML file");
  });
  button("map-bag").addEventListener("click", async () => {
    const stored = session.store();
    if (!stored) return;
    const { saveBag } = await import("../bags.js");
    await saveBag({ snapshot: app.playground.snapshot(), link: session.link(), stored, log: session.program_log() }, `${fileName(it.view.title)}.mapping`);
  });
  const forget = button("map-forget");
  const ask = (/** @type {string} */ sure) => {
    forget.dataset.sure = sure;
    setText(forget, sure ? "Forget it for good" : "Forget the map");
  };
  forget.addEventListener("click", () => {
    // There is no way back.
    if (!forget.dataset.sure) return ask("yes");
    ask("");
    if (it.act((s) => s.forget())) keeping.forget();
  });
  forget.addEventListener("blur", () => ask(""));
  button("map-clean").addEventListener("click", () => it.act((s) => s.clean()));
  fill(select("map-planner"), it.cleaners);
  select("map-planner").addEventListener("change", () => {
    it.set("clean", select("map-planner").value);
    changed(select("map-planner"), "value", undefined);
  });
  /** The run that another one is to follow, in words; "" if it hasn't begun. */
  const ran = () => (it.view.end_s > 0 ? `The run so far (${clock(it.view.end_s)} min${it.view.known === null ? `, ${percent(it.view.figures?.boundary ?? 0)} % mapped` : ""}) is kept.` : "");
  /** Says that clock and figures are those of another run. @param {string} before @param {string} why */
  const began = (before, why) => {
    setText(byId("map-began-text"), `${why} Clock and figures restart. ${before}`);
    setHidden(byId("map-began"), false);
  };
  const files = input("map-files");
  button("map-open").addEventListener("click", () => files.click());
  files.addEventListener("change", async () => {
    const chosen = [...(files.files ?? [])];
    // So that the same file can be chosen again.
    files.value = "";
    await open(chosen);
  });
  /** Gives the robot a map; if it can't be read, an error is shown and the current one stays. @param {File[]} chosen */
  const open = async (chosen) => {
    if (chosen.length === 0) return;
    try {
      const [{ readMap }, { readable }] = await Promise.all([import("../workers.js"), import("../shared/pictures.js")]);
      const map = await readMap(await readable(chosen));
      // The run can have continued meanwhile.
      keeping.save();
      const before = ran();
      if (it.act((s) => s.open(map))) {
        keeping.leave();
        began(before, `The robot has the map ${chosen.map(({ name }) => name).join(" and ")}, but doesn't know where it is.`);
      }
    } catch (error) {
      complain(error instanceof Error ? `The map could not be read (${error.message}). Check the connection, then try again.` : textOf(error));
    }
    // Tests wait for this.
    byId("panel-map").dataset.opened = String(Number(byId("panel-map").dataset.opened ?? 0) + 1);
  };
  button("map-lose").addEventListener("click", () => {
    keeping.save();
    const before = ran();
    if (!it.act((s) => s.open_own())) return;
    began(before, "The robot was kidnapped. It keeps its map, but doesn't know where it is.");
    it.act((s) => s.play());
  });
  const back = () => {
    keeping.save();
    keeping.leave();
    it.act((s) => s.close_map());
  };
  button("map-close").addEventListener("click", back);
  button("map-began-undo").addEventListener("click", () => {
    back();
    button("map-play").focus();
  });
  button("map-began-close").addEventListener("click", () => {
    setHidden(byId("map-began"), true);
    byId("map-floor").focus();
  });
  return {
    /** @param {import("../types").MapView} view */
    update({ can, planner, known, is_sure: isSure, is_cleaning: isCleaning }) {
      // Nor is it true any more of a robot that has relocalised.
      if (known === null || isSure) setHidden(byId("map-began"), true);
      setEnabled(button("map-clean"), can.clean);
      setText(button("map-clean"), isCleaning ? "Replan the rest" : "Clean with this map");
      if (changed(select("map-planner"), "value", planner)) select("map-planner").value = planner;
      setEnabled(button("map-room-use"), can.use_map);
      setEnabled(button("map-export"), can.use_map);
      setEnabled(button("map-bag"), can.use_map);
      setEnabled(button("map-forget"), can.forget);
      setEnabled(button("map-open"), can.open);
      setEnabled(button("map-lose"), can.open && can.use_map);
    },
  };
}
