// @ts-check
// What can be done with the map: it becomes the room of Explore, or files for other programs; or it is forgotten.
import { button, byId, changed, fill, input, select, setEnabled, setHidden, setText } from "../dom.js";
import { download, fileName } from "../files.js";
import { clock, percent } from "../format.js";
import { complain, textOf, toast } from "../messages.js";

/**
 * @param {import("./tab.js").Surveying} it
 * @param {ReturnType<typeof import("./keep.js").startKeeping>} keeping
 */
export function startUses(it, keeping) {
  const { app, survey } = it;
  button("survey-room-use").addEventListener("click", () => {
    keeping.save();
    // The map is made before anything of Explore is touched.
    if (!app.act((p) => p.take_map(survey.room()))) return;
    toast("The map is the room now");
    byId("tab-explore").click();
  });
  button("survey-export").addEventListener("click", () => {
    /** @type {{ name: string, bytes: Uint8Array<ArrayBuffer>, kind: string }[]} */
    let files = [];
    if (!app.act(() => (files = survey.ros_map(`${fileName(it.view.title)}-mapped`)))) return;
    for (const { name, bytes, kind } of files) download(name, bytes, kind);
    toast("Saved as a ROS map: image and YAML file");
  });
  button("survey-forget").addEventListener("click", () => {
    if (!it.act((s) => s.forget())) return;
    keeping.forget();
  });
  button("survey-clean").addEventListener("click", () => it.act((s) => s.clean()));
  fill(select("survey-planner"), it.cleaners);
  select("survey-planner").addEventListener("change", () => {
    it.set("clean", select("survey-planner").value);
    changed(select("survey-planner"), "value", undefined);
  });
  /** The run that another one is to follow, in words; "" if it hasn't begun. */
  const ran = () => (it.view.end_s > 0 ? `The run until now (${clock(it.view.end_s)} min${it.view.known === null ? `, ${percent(it.view.figures?.boundary ?? 0, 0)} % mapped` : ""}) is kept.` : "");
  /** Says that clock and figures are those of another run. @param {string} before @param {string} why */
  const began = (before, why) => {
    setText(byId("survey-began-text"), `${why} Clock and figures begin anew. ${before}`);
    setHidden(byId("survey-began"), false);
  };
  const files = input("survey-files");
  button("survey-open").addEventListener("click", () => files.click());
  files.addEventListener("change", async () => {
    const chosen = [...(files.files ?? [])];
    // So that the same file can be chosen again.
    files.value = "";
    await open(chosen);
  });
  /** Gives the robot a map; what can't be read is told, and the current one stays. @param {File[]} chosen */
  const open = async (chosen) => {
    if (chosen.length === 0) return;
    try {
      const { readMap } = await import("../workers.js");
      const map = await readMap(await Promise.all(chosen.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) }))));
      // The run may have gone on meanwhile.
      keeping.save();
      const before = ran();
      if (it.act((s) => s.open(map))) {
        keeping.leave();
        began(before, `The robot knows ${chosen.map(({ name }) => name).join(" and ")}, and not where it is.`);
      }
    } catch (error) {
      complain(error instanceof Error ? `The map could not be read (${error.message}). Check the connection, then try again.` : textOf(error));
    }
    // Tests wait for this.
    byId("place-map").dataset.opened = String(Number(byId("place-map").dataset.opened ?? 0) + 1);
  };
  button("survey-lose").addEventListener("click", () => {
    keeping.save();
    const before = ran();
    if (!it.act((s) => s.open_own())) return;
    began(before, "The robot was put down anywhere, and keeps its map.");
    it.act((s) => s.play());
  });
  const back = () => {
    keeping.save();
    keeping.leave();
    it.act((s) => s.close_map());
  };
  button("survey-close").addEventListener("click", back);
  button("survey-began-undo").addEventListener("click", () => {
    back();
    button("survey-play").focus();
  });
  button("survey-began-close").addEventListener("click", () => {
    setHidden(byId("survey-began"), true);
    byId("survey-floor").focus();
  });
  return {
    /** @param {import("./types").SurveyView} view */
    update({ can, planner, known, is_cleaning: isCleaning }) {
      if (known === null) setHidden(byId("survey-began"), true);
      setEnabled(button("survey-clean"), can.clean);
      setText(button("survey-clean"), isCleaning ? "Plan anew what is left" : "Clean with this map");
      if (changed(select("survey-planner"), "value", planner)) select("survey-planner").value = planner;
      setEnabled(button("survey-room-use"), can.use_map);
      setEnabled(button("survey-export"), can.use_map);
      setEnabled(button("survey-forget"), can.forget);
      setEnabled(button("survey-open"), can.open);
      setEnabled(button("survey-lose"), can.open && can.use_map);
    },
  };
}
