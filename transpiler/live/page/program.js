// The program: rows of source and ladder. Only what is near the window is there.

import { get } from "./api.js";
import { byId, element } from "./dom.js";
import { baseOf, format } from "./format.js";
import { Ladder } from "./ladder.js";
import { markAll } from "./link.js";
import { act, onChange, select, signalNamed, state } from "./store.js";

const kRows = 24;  // of a group, which comes and goes as one

class Group {
  constructor(begin, end, height) {
    this.begin = begin;
    this.end = end;
    this.rows = null;
    this.isLoading = false;
    this.element = element("div", { class: "rows" });
    this.element.style.minHeight = height + "px";
  }

  async load() {
    if (this.rows || this.isLoading) return;
    this.isLoading = true;
    try {
      const rows = await get(`/api/rows?from=${this.begin}&to=${this.end}`);
      this.rows = rows.map((row) => new Row(row));
      this.element.replaceChildren(...this.rows.map((row) => row.element));
      this.element.style.minHeight = "";
    } catch {
      // The server is away; the next look tries again.
    }
    this.isLoading = false;
  }

  drop() {
    if (!this.rows) return;
    this.element.style.minHeight = this.element.offsetHeight + "px";
    this.element.replaceChildren();
    this.rows = null;
  }
}

class Row {
  constructor(row) {
    this.row = row;
    this.badges = [];
    const heading = row.heads ? [element("h3", {}, row.file || "Around the program: what the control does")] : [];
    const source = element("div", { class: "src" });
    const ofLine = new Map();
    for (const id of row.statements) ofLine.set(state.outline.statements[id].line, [...(ofLine.get(state.outline.statements[id].line) ?? []), id]);
    this.marks = new Map();
    if (row.source.length === 0 && row.title) source.append(element("i", {}, row.title));
    for (const [number, text, isComment] of row.source) {
      const ids = ofLine.get(number) ?? [];
      const gutter = ids.length
        ? element("button", { type: "button", class: "gutter", "data-command": "breakStatement", "aria-pressed": "false", title: "Stop here",
            "aria-label": "Stop at line " + number, onclick: () => this.toggleStop(ids[0]) }, String(number))
        : element("span", { class: "gutter" }, String(number));
      for (const id of ids) this.marks.set(id, gutter);
      source.append(element("div", { class: isComment ? "line comment" : "line" }, gutter, element("code", { dir: "auto" }, text)));
    }
    const tools = element("div", { class: "tools" });
    for (const id of row.statements) tools.append(this.tool(id));
    source.append(tools);
    this.ladder = row.ladder ? new Ladder(row.ladder, "Ladder of " + (row.statements.map((id) => state.outline.statements[id].subject).join(", ") || row.title)) : null;
    this.element = element("article", { class: "row", "data-row": row.row }, ...heading, source,
      element("div", { class: "lad" }, ...(this.ladder ? [this.ladder.element] : [])));
    markAll(this.element);
    this.show();
    this.showValues(null);
  }

  tool(id) {
    const { subject } = state.outline.statements[id];
    const signal = signalNamed(subject);
    const value = element("button", { type: "button", class: "subject", title: "What it is now", onclick: () => signal >= 0 && select(signal) });
    if (signal >= 0) this.badges.push([value, signal]);
    const toggle = element("button", { type: "button", class: "switch", role: "switch", "data-command": "switch", "aria-label": "Statement " + subject,
      title: "Switch the statement off or on", onclick: () => act({ do: "switch", statement: id, on: state.off.has(id) }) });
    this.switches = [...(this.switches ?? []), [toggle, id]];
    return element("span", { class: "tool" }, ...(signal >= 0 ? [value] : []), toggle);
  }

  toggleStop(id) {
    act({ do: "breakStatement", statement: id, on: !state.breakpoints.some((one) => one.statement === id) });
  }

  show() {
    const { statements } = this.row;
    const at = statements.includes(state.at.statement);
    this.element.classList.toggle("at", at);
    this.element.classList.toggle("idle", statements.length > 0 && !statements.some((id) => state.executed.has(id)));
    this.element.classList.toggle("off", statements.some((id) => state.off.has(id)));
    for (const [id, gutter] of this.marks) {
      const stops = state.breakpoints.some((one) => one.statement === id);
      gutter.classList.toggle("stop", stops);
      gutter.setAttribute("aria-pressed", String(stops));
      gutter.classList.toggle("next", id === state.at.statement);
    }
    for (const [button, id] of this.switches ?? []) {
      const isOn = !state.off.has(id);
      button.textContent = isOn ? "on" : "off";
      button.setAttribute("aria-checked", String(isOn));
    }
    this.ladder?.show();
  }

  showValues(signals) {
    for (const [badge, number] of this.badges) {
      if (signals && !signals.has(number)) continue;
      const signal = state.outline.signals[number];
      badge.textContent = signal.name + " = " + format(state.values[number], signal.type, baseOf(signal.type, signal.signed));
      badge.classList.toggle("on", state.values[number] === 1 && signal.type === "bit");
      badge.classList.toggle("forced", state.forced.has(signal.name));
    }
    if (!signals || signals.size > 0) this.ladder?.showForced();
  }
}

const groups = [];
const near = new Set();

export async function showStatement(id) {
  const row = state.outline.statements[id]?.row ?? -1;
  if (row < 0) return;
  const group = groups[Math.floor(row / kRows)];
  await group.load();
  near.add(group);
  group.rows?.find((one) => one.row.row === row)?.element.scrollIntoView({ block: "center" });
}

export function begin() {
  const rows = state.outline.rows;
  for (let i = 0; i < rows.length; i += kRows) {
    const heights = rows.slice(i, i + kRows);
    groups.push(new Group(i, i + heights.length, heights.reduce((sum, height) => sum + height, 0)));
  }
  byId("rows").replaceChildren(...groups.map((group) => group.element));
  const byElement = new Map(groups.map((group) => [group.element, group]));
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const group = byElement.get(entry.target);
      if (entry.isIntersecting) {
        near.add(group);
        group.load();
      } else if (near.delete(group)) {
        group.drop();
      }
    }
  }, { root: byId("program"), rootMargin: "1200px 0px" });
  for (const group of groups) observer.observe(group.element);
  for (const part of ["source", "ladder"]) {
    byId("show-" + part).addEventListener("change", (event) => byId("program").classList.toggle("no-" + part, !event.target.checked));
  }
  byId("all-on").addEventListener("click", () => act({ do: "switchAllOn" }));
  let shownStatement = -1;
  onChange((changed, signals) => {
    if (changed.has("off")) byId("all-on").hidden = state.off.size === 0;
    const isNews = ["power", "executed", "at", "off", "breakpoints"].some((key) => changed.has(key));
    for (const group of near) {
      for (const row of group.rows ?? []) {
        if (isNews) row.show();
        if (signals.size > 0) row.showValues(signals);
      }
    }
    if (changed.has("at") && state.at.statement >= 0 && state.at.statement !== shownStatement) showStatement(state.at.statement);
    if (changed.has("at")) shownStatement = state.at.statement;
  });
}
