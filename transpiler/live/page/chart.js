// The timing chart: bits as levels, numbers as steps; two cursors, zoom, the stretch that a trigger has kept.

import { byId } from "./dom.js";
import { baseOf, format, timeText } from "./format.js";
import { act, onChange, say, state } from "./store.js";
import { readVcd } from "./vcd.js";

const canvas = byId("chart");
const kLeft = 110, kTop = 6, kAxis = 18, kRow = 30, kEmpty = 30;
const view = { ms: 2000, end: null, cursors: [] };  // end null: follows the machine
let asked = false;
let trace = null;  // of a file, instead of the machine

const samples = () => trace?.samples ?? state.kept ?? state.samples;
const tracks = () => trace?.watched ?? state.watched;
const lastMs = () => samples().at(-1)?.[1] ?? 0;
const endMs = () => view.end ?? lastMs();
const width = () => Math.max(50, canvas.clientWidth - kLeft - 8);
const xOf = (ms) => kLeft + width() * (1 - (endMs() - ms) / view.ms);
const msAt = (x) => Math.round(endMs() - view.ms * (1 - (x - kLeft) / width()));

/** The number of the last sample at or before a time; -1: there is none. */
function sampleAt(ms) {
  const all = samples();
  let low = 0, high = all.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (all[middle][1] <= ms) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

function colours() {
  const style = getComputedStyle(canvas);
  return Object.fromEntries(["--ink", "--soft", "--line", "--live", "--accent", "--warn"].map((name) => [name.slice(2), style.getPropertyValue(name).trim()]));
}

function draw() {
  asked = false;
  const scale = devicePixelRatio || 1;
  const height = tracks().length === 0 ? kEmpty : Math.max(90, tracks().length * kRow + kTop + kAxis);
  canvas.style.height = height + "px";
  canvas.width = Math.round(canvas.clientWidth * scale);
  canvas.height = Math.round(height * scale);
  const pen = canvas.getContext("2d");
  pen.scale(scale, scale);
  const colour = colours();
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  if (tracks().length === 0) {
    pen.fillStyle = colour.soft;
    pen.fillText("Watch locations to see them here.", 12, height / 2);
    return;
  }
  axis(pen, colour, height);
  const first = Math.max(0, sampleAt(endMs() - view.ms));
  const last = sampleAt(endMs());
  tracks().forEach((one, i) => track(pen, colour, one, i, first, last));
  markers(pen, colour, height);
}

function axis(pen, colour, height) {
  const steps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 30000, 60000];
  const step = steps.find((one) => view.ms / one <= width() / 70) ?? 60000;
  pen.strokeStyle = colour.line;
  pen.fillStyle = colour.soft;
  pen.lineWidth = 1;
  pen.textAlign = "center";
  for (let ms = Math.max(0, Math.ceil((endMs() - view.ms) / step) * step); ms <= endMs(); ms += step) {
    const x = Math.round(xOf(ms)) + 0.5;
    pen.beginPath();
    pen.moveTo(x, kTop);
    pen.lineTo(x, height - kAxis);
    pen.stroke();
    pen.fillText(timeText(ms), Math.min(Math.max(x, kLeft + 16), canvas.clientWidth - 24), height - kAxis / 2);
  }
}

function track(pen, colour, one, i, first, last) {
  const low = kTop + i * kRow + kRow - 6, high = kTop + i * kRow + 5;
  const isBit = one.type === "bit";
  const base = baseOf(one.type, one.signed);
  const all = samples();
  const number = (sample) => (isBit ? sample[2][i] : Number(format(sample[2][i], one.type, base)));
  let least = 0, most = 1;
  if (!isBit) {
    least = Infinity;
    most = -Infinity;
    for (let k = first; k <= last; ++k) {
      least = Math.min(least, number(all[k]));
      most = Math.max(most, number(all[k]));
    }
    if (!(most > least)) most = least + 1;
  }
  pen.textAlign = "right";
  pen.fillStyle = state.forced.has(one.name) ? colour.warn : colour.ink;
  pen.fillText(one.name, kLeft - 8, (low + high) / 2 - (isBit ? 0 : 6), kLeft - 14);
  if (!isBit && last >= 0) {
    pen.fillStyle = colour.soft;
    pen.fillText(format(all[last][2][i], one.type, base), kLeft - 8, (low + high) / 2 + 7, kLeft - 14);
  }
  pen.strokeStyle = colour.line;
  pen.beginPath();
  pen.moveTo(kLeft, low + 3.5);
  pen.lineTo(kLeft + width(), low + 3.5);
  pen.stroke();
  pen.save();
  pen.beginPath();
  pen.rect(kLeft, 0, width(), kTop + tracks().length * kRow);
  pen.clip();
  pen.strokeStyle = isBit ? colour.live : colour.accent;
  pen.lineWidth = 1.6;
  pen.beginPath();
  let y = null;
  for (let k = first; k <= last; ++k) {
    const x = xOf(all[k][1]);
    const next = low - ((number(all[k]) - least) / (most - least)) * (low - high);
    if (y === null) pen.moveTo(x, next);
    else if (next !== y) {
      pen.lineTo(x, y);
      pen.lineTo(x, next);
    }
    y = next;
  }
  if (y !== null) pen.lineTo(xOf(all[last][1]) + 1, y);
  pen.stroke();
  pen.restore();
}

function markers(pen, colour, height) {
  const line = (ms, name, ink) => {
    const x = Math.round(xOf(ms)) + 0.5;
    if (x < kLeft || x > kLeft + width() + 1) return;
    pen.strokeStyle = pen.fillStyle = ink;
    pen.setLineDash([4, 3]);
    pen.beginPath();
    pen.moveTo(x, 0);
    pen.lineTo(x, height - kAxis);
    pen.stroke();
    pen.setLineDash([]);
    pen.textAlign = "left";
    pen.fillText(name, x + 3, kTop + 2);
  };
  if (!trace && state.trigger && state.trigger.state !== "armed") line(state.trigger.atMs, "trigger", colour.accent);
  view.cursors.forEach((ms, i) => line(ms, "AB"[i], colour.warn));
}

function showCursors() {
  const [a, b] = view.cursors;
  const at = (ms) => {
    const sample = samples()[sampleAt(ms)];
    return timeText(ms) + ": " + (sample ? tracks().map((one, i) => one.name + " " + format(sample[2][i], one.type, baseOf(one.type, one.signed))).join(", ") : "nothing");
  };
  byId("cursor-text").textContent = a === undefined ? "" : "A " + at(a) + (b === undefined ? "" : "   B " + at(b) + "   B − A " + (b - a) + " ms");
}

export function ask() {
  if (asked) return;
  asked = true;
  requestAnimationFrame(draw);
}

function zoom(factor) {
  view.ms = Math.min(600000, Math.max(20, view.ms * factor));
  ask();
}

function move(share) {
  view.end = Math.min(lastMs(), Math.max(view.ms, endMs() + view.ms * share));
  if (view.end >= lastMs()) view.end = null;
  ask();
}

function showTrigger() {
  const { trigger } = state;
  byId("trigger-state").textContent = trigger ? trigger.text + ": " + trigger.state + (trigger.state === "started" ? ", " + trigger.kept + " of " + trigger.samples : "") : "";
  if (trigger?.state === "complete" && state.kept?.length) {
    view.end = lastMs();
    view.ms = Math.max(20, lastMs() - state.kept[0][1]);
  }
}

function showTrace(read, name) {
  trace = read;
  view.end = null;
  view.cursors = [];
  if (trace) view.ms = Math.max(20, lastMs() - trace.samples[0][1]);
  byId("trace-name").textContent = name;
  byId("trace-off").hidden = !trace;
  showCursors();
  ask();
}

export function begin() {
  const number = (id) => Number(byId(id).value);
  byId("trigger-base").value = state.outline.unitMs;
  byId("trigger-form").addEventListener("submit", (event) => {
    event.preventDefault();
    view.end = null;
    act({ do: "trigger", edge: byId("trigger-edge").value, text: byId("trigger-text").value.trim(), baseMs: number("trigger-base"),
      delayMs: number("trigger-delay"), samples: number("trigger-samples"), before: number("trigger-before") });
  });
  byId("trigger-off").addEventListener("click", () => {
    state.kept = null;
    view.end = null;
    act({ do: "triggerOff" });
  });
  byId("zoom-in").addEventListener("click", () => zoom(0.5));
  byId("zoom-out").addEventListener("click", () => zoom(2));
  byId("zoom-end").addEventListener("click", () => {
    view.end = null;
    ask();
  });
  byId("cursors-off").addEventListener("click", () => {
    view.cursors = [];
    showCursors();
    ask();
  });
  byId("trace").addEventListener("change", async (event) => {
    const [file] = event.target.files;
    event.target.value = "";
    if (!file) return;
    try {
      showTrace(readVcd(await file.text(), state.outline.mostWatched), file.name);
    } catch (error) {
      say(file.name + ": " + error.message);
    }
  });
  byId("trace-off").addEventListener("click", () => showTrace(null, ""));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    if (event.shiftKey) move(Math.sign(event.deltaY || event.deltaX) * 0.1);
    else zoom(event.deltaY > 0 ? 1.25 : 0.8);
  }, { passive: false });
  canvas.addEventListener("click", (event) => {
    const ms = msAt(event.offsetX);
    if (event.offsetX < kLeft) return;
    view.cursors = view.cursors.length >= 2 ? [ms] : [...view.cursors, ms];
    showCursors();
    ask();
  });
  canvas.addEventListener("keydown", (event) => {
    const keys = { "+": () => zoom(0.5), "-": () => zoom(2), ArrowLeft: () => move(-0.1), ArrowRight: () => move(0.1) };
    if (!(event.key in keys)) return;
    event.preventDefault();
    keys[event.key]();
  });
  new ResizeObserver(ask).observe(canvas.parentElement);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ask);
  onChange((changed) => {
    if (changed.has("trigger") || changed.has("kept")) showTrigger();
    if (["watched", "chart", "more", "kept", "trigger", "forced"].some((key) => changed.has(key))) ask();
    if (view.cursors.length > 0 && changed.has("chart")) showCursors();
  });
  ask();
}
