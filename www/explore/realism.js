// @ts-check
// What makes a run differ from an ideal one: wheel slip, noise of the sensors, rounded speeds, a battery that isn't full.
import { byId, fill, input, make, select, setText } from "../dom.js";

/** @param {import("../main.js").App} app @param {import("./form.js").Form} form @returns {(view: import("../types").PageView) => void} */
export function startRealism({ catalogue }, form) {
  form.bind("slip", (p, id) => p.set_slip(id));
  form.bind("noise", (p, level) => p.set_noise("all", level));
  form.bindBox("quantised", (p, on) => p.set_quantised(on));
  form.bind("start-charge", (p, percent) => p.set_start_charge(percent));
  const noises = catalogue.sensors.map(([sensor, title]) => noiseMenu(title, (level) => form.change((p) => p.set_noise(sensor, level))));
  byId("noises").replaceChildren(...noises.map(({ field }) => field));

  return ({ slip, noise, quantised, start_charge_percent: charge }) => {
    const level = noise.every((one) => one === noise[0]) ? (noise[0] ?? "off") : "mixed";
    form.show(select("slip"), slip);
    form.show(select("noise"), level);
    noises.forEach(({ menu }, index) => form.show(menu, noise[index] ?? "off"));
    form.show(input("quantised"), String(quantised));
    form.show(input("start-charge"), String(charge));
    const on = [slip !== "none" && "slip", level !== "off" && "noise", quantised && "rounded speeds", charge < 100 && `${charge} % charge`].filter(Boolean);
    setText(byId("realism-note"), on.join(", ") || "ideal");
  };
}

/** The field for the noise of one kind of sensor. @param {string} title @param {(level: string) => void} onchange */
function noiseMenu(title, onchange) {
  const menu = make("select", { onchange: () => onchange(menu.value) });
  fill(menu, ["off", "typical", "harsh"].map((level) => [level, level]));
  return { menu, field: make("label", { className: "field inline" }, make("span", { className: "label" }, title), menu) };
}
