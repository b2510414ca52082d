// What is watched in numbers, what is forced, where it stops, what the operator reads, and the scenario.

import { byId, element } from "./dom.js";
import { baseOf, bases, format, timeText } from "./format.js";
import { mark } from "./link.js";
import { act, onChange, say, select, signalNamed, state } from "./store.js";
import { showStatement } from "./program.js";

const baseChosen = new Map();  // by name
const removeButton = (label, command) => {
  const button = element("button", { type: "button", class: "remove", "data-command": command.do, "aria-label": label, title: label, onclick: () => act(command) }, "×");
  mark(button, command.do);
  return button;
};

const lastValues = () => state.samples.at(-1)?.[2] ?? [];

function watchedValue(i) {
  const number = signalNamed(state.watched[i].name);
  return number >= 0 ? state.values[number] : lastValues()[i];
}

function showWatches() {
  byId("watch-count").textContent = state.watched.length + " of " + state.outline.mostWatched;
  byId("watches").hidden = state.watched.length === 0;
  byId("watches").tBodies[0].replaceChildren(...state.watched.map((one, i) => {
    const isWord = /^i/.test(one.type);
    const choose = element("select", { "aria-label": "Base of " + one.name, onchange: (event) => {
      baseChosen.set(one.name, event.target.value);
      showWatchValues();
    } }, ...bases.map((base) => element("option", { value: base }, base)));
    choose.value = baseChosen.get(one.name) ?? baseOf(one.type, one.signed);
    return element("tr", {}, element("th", { scope: "row" }, element("button", { type: "button", class: "link", onclick: () => select(signalNamed(one.name)) }, one.name)),
      element("td", { class: "value" }), element("td", {}, ...(isWord ? [choose] : [one.type])),
      element("td", {}, removeButton("Do not watch " + one.name, { do: "unwatch", number: i })));
  }));
  showWatchValues();
}

function showWatchValues() {
  const rows = byId("watches").tBodies[0].rows;
  state.watched.forEach((one, i) => {
    if (!rows[i]) return;
    const base = baseChosen.get(one.name) ?? baseOf(one.type, one.signed);
    const text = format(watchedValue(i), one.type, base);
    if (rows[i].cells[1].textContent !== text) rows[i].cells[1].textContent = text;
    rows[i].classList.toggle("forced", state.forced.has(one.name));
  });
}

function showForced() {
  byId("forced-card").hidden = state.forced.size === 0;
  byId("forced").replaceChildren(...[...state.forced].map(([name, value]) =>
    element("li", { class: "forced" }, element("button", { type: "button", class: "link", onclick: () => select(signalNamed(name)) }, name + " = " + value),
      removeButton("Release " + name, { do: "release", name }))));
}

function showBreaks() {
  byId("breaks").replaceChildren(...state.breakpoints.map((one) => {
    const text = one.kind === "statement" ? "line " + state.outline.statements[one.statement].line + "  " + one.text
      : one.kind === "change" ? one.text + " changes" : one.text;
    const label = one.kind === "statement"
      ? element("button", { type: "button", class: "link", onclick: () => showStatement(one.statement) }, text) : element("span", {}, text);
    return element("li", {}, label, removeButton("Do not stop: " + text, { do: "breakRemove", number: one.number }));
  }));
}

function showMessages() {
  byId("messages").replaceChildren(...(state.messages.length ? state.messages.map((text) => element("li", { dir: "auto" }, text))
    : [element("li", { class: "empty" }, "None.")]));
}

function showNotes() {
  byId("notes").replaceChildren(...state.notes.slice(-100).reverse().map((note) => {
    const text = element("span", { dir: "auto" }, note.text);
    const place = note.statement >= 0
      ? [element("button", { type: "button", class: "link", onclick: () => showStatement(note.statement) }, "line " + state.outline.statements[note.statement].line)] : [];
    return element("li", { class: note.kind }, element("time", {}, timeText(note.ms)), text, ...place);
  }));
}

async function showScenario() {
  const answer = await act({ do: "scenario" });
  byId("scenario").hidden = !answer;
  if (answer) byId("scenario").textContent = answer.yaml;
}

function onSubmit(id, action) {
  byId(id).addEventListener("submit", (event) => {
    event.preventDefault();
    action();
  });
}

export function begin() {
  onSubmit("watch-form", async () => {
    if (await act({ do: "watch", name: byId("watch-name").value.trim() })) byId("watch-name").value = "";
  });
  onSubmit("break-form", async () => {
    if (await act({ do: "breakCondition", text: byId("break-text").value.trim() })) byId("break-text").value = "";
  });
  onSubmit("save-form", async () => {
    const answer = await act({ do: "save", file: byId("save-name").value.trim() });
    if (answer) say("Saved: " + answer.file + ". It passes.");
  });
  byId("release-all").addEventListener("click", () => act({ do: "releaseAll" }));
  byId("restart").addEventListener("click", () => act({ do: "restart" }));
  byId("expect").addEventListener("click", () => act({ do: "expect", names: state.watched.map((one) => one.name) }));
  byId("expect-messages").addEventListener("click", () => act({ do: "expectMessages" }));
  byId("show-scenario").addEventListener("click", showScenario);
  onChange((changed) => {
    if (changed.has("watched")) showWatches();
    else if (["values", "more", "chart", "forced"].some((key) => changed.has(key))) showWatchValues();
    if (changed.has("forced")) showForced();
    if (changed.has("breakpoints")) showBreaks();
    if (changed.has("messages")) showMessages();
    if (changed.has("notes")) showNotes();
  });
}
