// The bar: power, run, steps, the way back.

import { byId, element } from "./dom.js";
import { act, onChange, state } from "./store.js";
import { timeText } from "./format.js";

const names = { statement: "statement", period: "period", fast: "fast part", slice: "slice", slow: "slow pass" };
const keys = { statement: "s", period: ".", fast: "f", slow: "w" };

export const runOrPause = () => act({ do: state.mode.running ? "pause" : "run" });
export const step = (what) => act({ do: "step", what });
export const back = (periods) => act({ do: "back", periods });

let dragging = false;

function show(changed) {
  if (changed.has("mode")) {
    const { running, on, why, opened, speed } = state.mode;
    byId("run").firstChild.classList.toggle("halt", running);
    byId("run").lastChild.textContent = running ? "Pause" : "Run";
    byId("run").disabled = !on;
    byId("power").setAttribute("aria-pressed", String(on));
    byId("power").lastChild.textContent = on ? "on" : "off";
    byId("state").textContent = !on ? "off" : running ? "running" : why || "paused";
    byId("state").className = "badge " + (!on ? "off" : running ? "running" : why ? "stopped" : "");
    byId("opened").hidden = !opened;
    byId("opened").textContent = opened;
    if (document.activeElement !== byId("speed")) byId("speed").value = String(speed);
  }
  if (changed.has("at")) {
    const { period, first, end, ms, statement } = state.at;
    byId("clock").textContent = timeText(ms);
    byId("period").textContent = "period " + period + (statement >= 0 ? " (within)" : "");
    const slider = byId("slider");
    slider.min = first;
    slider.max = end;
    if (!dragging) slider.value = period;
  }
}

export function begin() {
  const steps = byId("steps");
  for (const what of state.outline.steps) {
    steps.append(element("button", {
      type: "button", "data-step": what, onclick: () => step(what),
      title: "On by one " + names[what] + (keys[what] ? " (" + keys[what] + ")" : ""),
    }, names[what] + " ▶"));
  }
  byId("run").addEventListener("click", runOrPause);
  byId("power").addEventListener("click", () => act({ do: state.mode.on ? "powerOff" : "powerOn" }));
  byId("speed").addEventListener("change", (event) => act({ do: "speed", times: Number(event.target.value) }));
  byId("back-statement").addEventListener("click", () => act({ do: "backStatement" }));
  for (const button of document.querySelectorAll("[data-back]")) {
    button.addEventListener("click", () => back(Number(button.dataset.back)));
  }
  const slider = byId("slider");
  slider.addEventListener("input", () => (dragging = true));
  slider.addEventListener("change", () => {
    dragging = false;
    act({ do: "goTo", period: Number(slider.value) });
  });
  onChange(show);
}
