// The state as the page knows it: the outline of the program, and what changes. Views ask to be called.

import { send } from "./api.js";

export const state = {
  outline: null,
  at: { period: 0, first: 0, end: 0, ms: 0, statement: -1 },
  link: { connected: false, reason: "", canWrite: false, mayWrite: false, forcedBytes: 0, lost: 0, roundMs: 0 },
  mode: { running: false, on: true, speed: 1, why: "", opened: "" },
  values: [],
  power: new Set(),
  executed: new Set(),
  forced: new Map(),
  off: new Set(),
  breakpoints: [],
  messages: [],
  panel: [],
  notes: [],
  watched: [],
  samples: [],
  kept: null,
  trigger: null,
  selected: -1,
};

const views = [];
/** `view` is called with what has changed: a Set of keys, and the numbers of the signals. */
export const onChange = (view) => views.push(view);

const toggle = (set, number) => (set.has(number) ? set.delete(number) : set.add(number));

/** A new stream tells everything again. */
export function forgetAll() {
  state.power.clear();
  state.executed.clear();
}

export function apply(change) {
  const keys = new Set(Object.keys(change));
  const signals = new Set();
  for (const key of ["at", "mode", "breakpoints", "link", "messages", "notes", "panel", "trigger", "watched"]) {
    if (key in change) state[key] = change[key];
  }
  for (const [number, value] of change.values ?? []) {
    state.values[number] = value;
    signals.add(number);
  }
  for (const number of change.power ?? []) toggle(state.power, number);
  for (const number of change.executed ?? []) toggle(state.executed, number);
  if (change.forced) {
    state.forced = new Map(change.forced);
    state.outline.signals.forEach((_, number) => signals.add(number));
  }
  if (change.off) state.off = new Set(change.off);
  if (change.chart) {
    state.samples = change.chart;
    if (!change.kept) state.kept = null;
  }
  if (change.more) {
    state.samples.push(...change.more);
    if (state.samples.length > state.outline.mostBack) state.samples.splice(0, state.samples.length - state.outline.mostBack);
  }
  if (change.kept) state.kept = change.kept;
  notify(keys, signals);
}

export function notify(keys, signals = new Set()) {
  for (const view of views) view(keys, signals);
}

export function select(number) {
  state.selected = number;
  notify(new Set(["selected"]));
}

const toast = document.getElementById("toast");
let toastTimer = 0;
export function say(text) {
  toast.textContent = text;
  toast.hidden = false;
  clearTimeout(toastTimer);
  toastTimer = setTimeout(() => (toast.hidden = true), 6000);
}

/** Sends a command; what is refused is said. Gives the answer, or null. */
export async function act(command) {
  try {
    return await send(command);
  } catch (error) {
    say(error.message);
    return null;
  }
}

export const signalNamed = (name) =>
  state.outline.signals.findIndex((signal) => signal.name === name || signal.address === name);
export const isForced = (signal) => state.forced.has(signal.name) || (signal.address !== "" && state.forced.has(signal.address));
