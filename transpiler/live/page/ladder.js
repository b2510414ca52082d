// A ladder with its power flow: what is connected by wires has one colour.

import { svg } from "./dom.js";
import { isForced, select, state } from "./store.js";
import { toggleSignal } from "./signals.js";

/** Which nets carry power; a net depends on those before it. */
export function flow(nets, power) {
  const on = [];
  for (const net of nets) {
    const lets = net.bit === undefined ? true : power.has(net.bit) !== Boolean(net.inverted);
    switch (net.kind) {
      case "rail": on.push(true); break;
      case "through": on.push(on[net.from[0]] && lets); break;
      case "output": on.push(lets); break;
      case "inverted": on.push(!on[net.from[0]]); break;
      case "any": on.push(net.from.some((from) => on[from])); break;
      default: on.push(false);
    }
  }
  return on;
}

export class Ladder {
  constructor(drawn, label) {
    this.drawn = drawn;
    this.on = [];
    this.element = svg("svg", { class: "ladder", role: "img", "aria-label": label, width: drawn.w, height: drawn.h, viewBox: `0 0 ${drawn.w} ${drawn.h}` });
    const path = (pen, d) => (d ? this.element.appendChild(svg("path", { class: pen, d })) : null);
    path("f", drawn.frames);
    path("r", drawn.rails);
    this.parts = drawn.nets.map((net) => [path("w", net.wires)].filter(Boolean));
    for (const symbol of drawn.symbols) {
      for (const [pen, d] of [["w", symbol.pen], ["w d", symbol.local], ["b", symbol.box], ["b d", symbol.localBox]]) {
        const part = path(pen, d);
        if (part) this.parts[symbol.net].push(part);
      }
    }
    this.texts = [];
    for (const [x, y, classes, text, signal] of drawn.texts) {
      const made = svg("text", { x, y, class: classes }, text);
      if (signal >= 0) {
        made.classList.add("signal");
        made.addEventListener("click", () => select(signal));
        made.addEventListener("dblclick", () => toggleSignal(signal));
        this.texts.push([made, signal]);
      }
      this.element.appendChild(made);
    }
    this.show();
    this.showForced();
  }

  show() {
    flow(this.drawn.nets, state.power).forEach((isOn, net) => {
      if (this.on[net] === isOn) return;
      this.on[net] = isOn;
      for (const part of this.parts[net]) part.classList.toggle("live", isOn);
    });
  }

  showForced() {
    for (const [text, signal] of this.texts) text.classList.toggle("forced", isForced(state.outline.signals[signal]));
  }
}
