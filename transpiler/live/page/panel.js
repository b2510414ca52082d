// The operator's panel: what panel.yaml lays out, as elements that a keyboard operates and a screen reader reads. What is
// written on it becomes text, never markup.

import { byId, element, svg } from "./dom.js";
import { format } from "./format.js";
import { act, notify, onChange, state } from "./store.js";

const colors = ["white", "green", "yellow", "red", "blue"];
const colorOf = (control) => (colors.includes(control.color) ? control.color : "white");
const controls = new Map();  // by number: what shows its state

/** Pressed as long as the pointer, Space or Enter is down. */
function pressable(button, number) {
  let isDown = false;
  const press = () => {
    if (isDown) return;
    isDown = true;
    act({ do: "panelPress", control: number });
  };
  const release = () => {
    if (!isDown) return;
    isDown = false;
    act({ do: "panelRelease", control: number });
  };
  button.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    button.setPointerCapture(event.pointerId);
    press();
  });
  for (const end of ["pointerup", "pointercancel", "lostpointercapture", "blur"]) button.addEventListener(end, release);
  button.addEventListener("keydown", (event) => {
    if ((event.key === " " || event.key === "Enter") && !event.repeat) press();
    if (event.key === " " || event.key === "Enter") event.preventDefault();
  });
  button.addEventListener("keyup", (event) => {
    if (event.key === " " || event.key === "Enter") release();
  });
  // A screen reader, or a script, clicks without pointer and key.
  button.addEventListener("click", (event) => {
    if (event.detail !== 0 || isDown) return;
    press();
    release();
  });
  button.addEventListener("contextmenu", (event) => event.preventDefault());
}

function makeButton(control) {
  const button = element("button", { type: "button", class: "pushbutton lens-" + colorOf(control), dir: "auto" }, control.text);
  pressable(button, control.number);
  controls.set(control.number, ([position, isLit]) => {
    button.classList.toggle("down", position === 1);
    button.classList.toggle("lit", isLit);
    button.setAttribute("aria-pressed", String(position === 1));
    const lamp = control.lamp ? (isLit ? ", its lamp is on" : ", its lamp is off") : "";
    button.setAttribute("aria-label", control.text + lamp);
  });
  return button;
}

/** Toggle, key switch and emergency stop: a switch with two positions. */
function makeSwitch(control) {
  const isStop = control.kind === "stop";
  const word = element("span", { class: "position", dir: "auto" });
  let at = 0;
  const button = element("button", {
    type: "button", class: "twoway " + control.kind, role: "switch", "aria-label": control.text,
    onclick: () => act({ do: "panelTurn", control: control.number, position: at === 1 ? 0 : 1 }),
  }, element("span", { class: "knob", "aria-hidden": "true" }));
  controls.set(control.number, ([position]) => {
    at = position;
    button.setAttribute("aria-checked", String(position === 1));
    word.textContent = isStop ? (position === 1 ? "pressed" : "") : control.labels[position];
    if (!isStop) button.setAttribute("aria-label", control.text + ": " + control.labels[position]);
  });
  return [element("span", { class: "legend", dir: "auto" }, control.text), button, word];
}

function makeKnob(control) {
  const last = control.labels.length - 1;
  const angleOf = (position) => (last > 7 ? -150 + (300 * position) / last : -(last * 45) / 2 + 45 * position);
  const face = svg("svg", { viewBox: "-50 -50 100 100", class: "dial", "aria-hidden": "true" });
  for (let i = 0; i <= last; ++i) face.append(svg("line", { class: "tick", x1: 0, y1: -47, x2: 0, y2: -40, transform: `rotate(${angleOf(i)})` }));
  face.append(svg("circle", { class: "cap", r: 34 }));
  const pointer = svg("path", { class: "pointer", d: "M-4 8V-31h8V8z" });
  face.append(pointer);
  const range = element("input", { type: "range", min: 0, max: last, step: 1, "aria-label": control.text });
  const word = element("output", { class: "position", dir: "auto" });
  let at = 0;
  const turn = (position) => {
    if (position < 0 || position > last || position === at) return;
    act({ do: "panelTurn", control: control.number, position });
  };
  range.addEventListener("input", () => turn(Number(range.value)));
  face.addEventListener("click", (event) => {
    const box = face.getBoundingClientRect();
    turn(at + (event.clientX < box.left + box.width / 2 ? -1 : 1));
  });
  controls.set(control.number, ([position]) => {
    at = position;
    const label = position < 0 ? "–" : control.labels[position];
    range.value = Math.max(0, position);
    range.setAttribute("aria-valuetext", label);
    word.textContent = label;
    pointer.setAttribute("transform", `rotate(${angleOf(Math.max(0, position))})`);
  });
  return [element("span", { class: "legend", dir: "auto" }, control.text), face, range, word];
}

function makeLamp(control) {
  const lamp = element("span", { class: "bulb lens-" + colorOf(control), role: "img" });
  controls.set(control.number, ([, isLit]) => {
    lamp.classList.toggle("lit", isLit);
    lamp.setAttribute("aria-label", control.text + (isLit ? ": on" : ": off"));
  });
  return [element("span", { class: "legend", dir: "auto" }, control.text), lamp];
}

function makeDisplay(control) {
  const digits = element("output", { class: "digits", "aria-label": control.text });
  controls.set(control.number, ([, , value]) => {
    const text = format(value, control.type, control.type[0] === "f" ? "float" : control.base);
    digits.textContent = text + (control.unit ? " " + control.unit : "");
  });
  return [element("span", { class: "legend", dir: "auto" }, control.text), digits];
}

function makeMessages(control) {
  const list = element("ul", { class: "screen plain", "aria-live": "polite", "aria-label": control.text });
  const show = () => list.replaceChildren(...state.messages.map((text) => element("li", { dir: "auto" }, text)));
  onChange((changed) => changed.has("messages") && show());
  return [element("span", { class: "legend", dir: "auto" }, control.text), list];
}

const makers = { button: makeButton, toggle: makeSwitch, key: makeSwitch, stop: makeSwitch, knob: makeKnob, lamp: makeLamp, display: makeDisplay, messages: makeMessages };

function makeControl(control) {
  const parts = makers[control.kind](control);
  const place = element("div", { class: "control " + control.kind, "data-control": control.number }, ...(Array.isArray(parts) ? parts : [parts]));
  place.style.gridColumn = (control.column || "auto") + " / span " + control.width;
  if (control.row) place.style.gridRow = String(control.row);
  return place;
}

function makeGroup(group) {
  const grid = element("div", { class: "grid" }, ...group.controls.map(makeControl));
  grid.style.setProperty("--columns", group.columns);
  return element("fieldset", { class: "panel-group" }, element("legend", { dir: "auto" }, group.title), grid);
}

function showTab(name) {
  for (const tab of document.querySelectorAll("[data-view]")) {
    tab.setAttribute("aria-selected", String(tab.dataset.view === name));
    tab.tabIndex = tab.dataset.view === name ? 0 : -1;
  }
  byId("program").hidden = name !== "program";
  byId("panel").hidden = name !== "panel";
  document.body.classList.toggle("panel-view", name === "panel");
  notify(new Set(["chart"]));  // it is there again
}

export function begin() {
  const panel = state.outline.panel;
  if (!panel) return;
  byId("panel-title").textContent = panel.title || state.outline.name;
  byId("panel-groups").replaceChildren(...panel.groups.map(makeGroup));
  const tabs = [...document.querySelectorAll("[data-view]")];
  byId("view-tabs").hidden = false;
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => showTab(tab.dataset.view));
    tab.addEventListener("keydown", (event) => {
      if (event.key !== "ArrowRight" && event.key !== "ArrowLeft") return;
      const other = tabs[(i + 1) % tabs.length];
      other.focus();
      showTab(other.dataset.view);
    });
  });
  showTab(new URLSearchParams(location.hash.slice(1)).has("panel") ? "panel" : "program");
  onChange((changed) => {
    if (!changed.has("panel")) return;
    state.panel.forEach((shown, number) => controls.get(number)?.(shown));
  });
}
