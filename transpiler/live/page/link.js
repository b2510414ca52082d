// A running machine instead of a simulated one: what its link says, and which controls it leaves without use. They stay
// where they are, and say why.

import { byId } from "./dom.js";
import { onChange, state } from "./store.js";

const readingOnly = "the machine permits reading only";
const writing = ["set", "toggle", "force", "release", "releaseAll"];

/** Why the command is of no use here; "": it is. */
export function reasonAgainst(command) {
  const { link } = state.outline;
  if (!link) return "";
  if (link.refused[command]) return link.refused[command];
  if (!state.link.connected) return "there is no connection to the machine";
  return writing.includes(command) && !state.link.mayWrite ? readingOnly : "";
}

const titles = new WeakMap();  // as they are where the control is of use

/** A control of this command: of no use where the command is refused. A button can still be reached, and tells why. */
export function mark(control, command) {
  if (!state.outline.link) return;
  if (!titles.has(control)) titles.set(control, control.title);
  const reason = reasonAgainst(command);
  control.title = reason || titles.get(control);
  if (control.tagName === "BUTTON") {
    if (reason) control.setAttribute("aria-disabled", "true");
    else control.removeAttribute("aria-disabled");
  } else {
    control.disabled = reason !== "";
  }
  if (reason) control.setAttribute("aria-description", reason);
  else control.removeAttribute("aria-description");
}

const ofPage = {
  "#run": "run", "#power": "powerOff", "#speed": "speed", "#slider": "goTo", "#back-statement": "backStatement", "[data-back]": "back",
  "[data-step]": "step", "#all-on": "switchAllOn", "#break-text": "breakCondition", "#break-form button": "breakCondition",
  "#restart": "restart", "#expect": "expect", "#expect-messages": "expectMessages", "#show-scenario": "scenario",
  "#save-name": "save", "#save-form button": "save", "#release-all": "releaseAll", "#watch-name": "watch",
  "#watch-form button": "watch",
};

/** Marks what was made with `data-command`, too. */
export function markAll(root = document) {
  if (!state.outline.link) return;
  for (const control of root.querySelectorAll("[data-command]")) mark(control, control.dataset.command);
}

function show() {
  const { connected, reason, canWrite, mayWrite, forcedBytes, lost, roundMs } = state.link;
  const access = mayWrite ? "may be written" : canWrite ? "reading only, as its key switch says" : "reading only";
  byId("link").textContent = connected
    ? `${state.outline.link.address}: ${access}; all values read in ${roundMs} ms` +
      (lost ? `; ${lost} samples lost` : "") + (forcedBytes > 0 && state.forced.size === 0 ? `; ${forcedBytes} bytes forced by others` : "")
    : state.outline.link.address;
  byId("lost").hidden = connected;
  byId("lost").textContent = connected ? "" : `No connection to the machine: ${reason}. What is shown is old. It is tried again each second.`;
  document.body.classList.toggle("stale", !connected);
}

export function begin() {
  if (!state.outline.link) return;
  document.body.classList.add("linked");
  byId("link").hidden = false;
  document.querySelector(".views .hint").textContent = "Power flow: computed again from the values that were read. Click a name: what it is now.";
  const condition = byId("trigger-edge").querySelector("[value=condition]");
  condition.disabled = true;
  condition.title = "over a link the trigger is an edge of what is watched";
  let shown = "";
  onChange((changed) => {
    if (changed.has("link") || changed.has("forced")) show();
    const now = JSON.stringify([state.link.connected, state.link.mayWrite]);
    if (changed.has("link") && now !== shown) {
      shown = now;
      for (const [selector, command] of Object.entries(ofPage)) {
        for (const control of document.querySelectorAll(selector)) mark(control, command);
      }
      markAll();
    }
  });
}
