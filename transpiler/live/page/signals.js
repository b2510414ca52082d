// The list of signals, and the card of the one that is chosen.

import { byId, element } from "./dom.js";
import { act, isForced, onChange, select, state } from "./store.js";
import { baseOf, bases, format } from "./format.js";
import { mark, markAll } from "./link.js";

let group = "input";
const rows = new Map();  // by number of the signal
let cardParts = null;

const valueText = (number) => {
  const signal = state.outline.signals[number];
  return format(state.values[number], signal.type, baseOf(signal.type, signal.signed));
};

export function toggleSignal(number) {
  const signal = state.outline.signals[number];
  if (signal && signal.type === "bit" && signal.named) act({ do: "toggle", name: signal.name });
}

const drivenText = (signal) => (signal.driven ? "The plant drives it: " + signal.driven : "");

/** The comment without the name that it begins with. */
const wordsOf = (signal) => (signal.words.startsWith(signal.name + "; ") ? signal.words.slice(signal.name.length + 2) : signal.words);

function showRow(number) {
  const row = rows.get(number);
  if (!row) return;
  const signal = state.outline.signals[number];
  const isOn = signal.type === "bit" && state.values[number] === 1;
  row.value.textContent = valueText(number);
  row.value.classList.toggle("on", isOn);
  if (signal.type === "bit") row.value.setAttribute("aria-checked", String(isOn));
  row.item.classList.toggle("forced", isForced(signal));
}

function makeRow(signal, number) {
  const isBit = signal.type === "bit" && signal.named;
  const value = element(isBit ? "button" : "span", isBit
    ? { type: "button", class: "value bit", role: "switch", "data-command": "toggle", "aria-label": "Toggle " + signal.name, title: drivenText(signal), onclick: () => {
        select(number);
        toggleSignal(number);
      } }
    : { class: "value" });
  const item = element("li", signal.driven ? { class: "driven" } : {},
    element("button", { type: "button", class: "name", onclick: () => select(number) },
      element("b", { dir: "auto" }, signal.name),
      element("small", { dir: "auto" }, wordsOf(signal) || signal.address)),
    value);
  if (isBit) mark(value, "toggle");
  rows.set(number, { item, value });
  showRow(number);
  return item;
}

function list() {
  rows.clear();
  const words = byId("filter").value.trim().toLowerCase();
  const items = [];
  state.outline.signals.forEach((signal, number) => {
    if (words ? !(signal.name + " " + signal.address + " " + signal.words).toLowerCase().includes(words) : signal.group !== group) return;
    items.push(makeRow(signal, number));
  });
  byId("signal-list").replaceChildren(...items);
  if (items.length === 0) byId("signal-list").append(element("li", { class: "empty" }, "Nothing of that kind."));
}

function showCard() {
  const body = byId("card-body");
  const number = state.selected;
  const signal = state.outline.signals[number];
  if (!signal) return;
  const values = element("dl", { class: "values" });
  const entry = element("input", { "aria-label": "Value", placeholder: signal.type === "bit" ? "0 or 1" : "value", size: 8 });
  const given = () => entry.value.trim() || format(state.values[number], signal.type, baseOf(signal.type, false));
  const button = (text, command, title = "") =>
    element("button", { type: "button", title, "data-command": command().do, onclick: () => act(command()) }, text);
  const actions = element("div", { class: "buttons" });
  if (signal.named) {
    if (signal.type === "bit") actions.append(element("button", { type: "button", "data-command": "toggle", onclick: () => toggleSignal(number), title: "t" }, "Toggle"));
    actions.append(
      button("Set", () => ({ do: "set", name: signal.name, value: given() })),
      button("Force", () => ({ do: "force", name: signal.name, value: given() }), "Held against every writer"),
      button("Release", () => ({ do: "release", name: signal.name })),
      button("Watch", () => ({ do: "watch", name: signal.name })),
      button("Stop on change", () => ({ do: "breakChange", name: signal.name })),
      button("Expect", () => ({ do: "expect", names: [signal.name] }), "The scenario expects what it is now"),
      element("button", { type: "button", id: "why", "data-command": "why", onclick: () => askWhy(signal.name) }, "Why?"));
  }
  const bits = element("div", { class: "bits", role: "group", "aria-label": "Bits" });
  if (signal.named && /^i(8|16|32)$/.test(signal.type)) {
    for (let bit = Number(signal.type.slice(1)) - 1; bit >= 0; --bit) {
      bits.append(element("button", { type: "button", title: "Toggle bit " + bit, "data-bit": bit, "data-command": "set", onclick: () =>
        act({ do: "set", name: signal.name, value: String((state.values[number] ^ (1 << bit)) >>> 0) }) }, String(bit)));
    }
  }
  const why = element("pre", { class: "why", hidden: true, tabIndex: 0, "aria-label": "Why it is so" });
  body.replaceChildren(
    element("p", { class: "chosen" }, element("b", { dir: "auto" }, signal.name),
      element("span", { class: "forced-mark" }, "forced"), element("small", { dir: "auto" },
        [signal.address, signal.type, signal.group].filter(Boolean).join(" · "))),
    element("p", { class: "soft", dir: "auto" }, wordsOf(signal)),
    signal.driven ? element("p", { class: "soft", dir: "auto" }, drivenText(signal)) : "", values,
    signal.named ? element("div", { class: "entry" }, entry) : "", bits, actions, why);
  cardParts = { number, values, bits, why };
  markAll(body);
  showCardValues();
}

function showCardValues() {
  if (!cardParts) return;
  const { number, values, bits } = cardParts;
  for (const button of bits.children) {
    const isOn = (state.values[number] >> Number(button.dataset.bit)) & 1;
    button.classList.toggle("on", Boolean(isOn));
    button.setAttribute("aria-pressed", String(Boolean(isOn)));
  }
  const signal = state.outline.signals[number];
  byId("card").classList.toggle("forced", isForced(signal));
  const shown = signal.type === "bit" || !/^i/.test(signal.type) ? [baseOf(signal.type, signal.signed)] : bases;
  values.replaceChildren(...shown.flatMap((base) => [
    element("dt", {}, base === "bit" ? "value" : base),
    element("dd", {}, format(state.values[number], signal.type, base)),
  ]));
}

async function askWhy(name) {
  const answer = await act({ do: "why", name });
  if (!answer || !cardParts) return;
  cardParts.why.hidden = false;
  cardParts.why.textContent = answer.text;
}

export function begin() {
  for (const tab of document.querySelectorAll("[data-group]")) {
    tab.addEventListener("click", () => {
      group = tab.dataset.group;
      for (const other of document.querySelectorAll("[data-group]")) other.setAttribute("aria-selected", String(other === tab));
      byId("filter").value = "";
      list();
    });
  }
  byId("filter").addEventListener("input", list);
  list();
  onChange((changed, signals) => {
    for (const number of signals) showRow(number);
    if (changed.has("selected")) {
      showCard();
      for (const [number, row] of rows) row.item.classList.toggle("selected", number === state.selected);
    } else if (cardParts && signals.has(cardParts.number)) {
      showCardValues();
    }
  });
}
