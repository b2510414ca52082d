// The page: asks for the program, begins its parts, listens.

import { get, listen } from "./api.js";
import * as chart from "./chart.js";
import { byId, isTyping } from "./dom.js";
import * as link from "./link.js";
import * as panel from "./panel.js";
import * as program from "./program.js";
import * as signals from "./signals.js";
import { act, apply, forgetAll, say, state } from "./store.js";
import * as transport from "./transport.js";
import * as watches from "./watches.js";

const keys = {
  " ": () => transport.runOrPause(),
  ".": () => transport.step("period"),
  ",": () => transport.back(1),
  s: () => transport.step("statement"),
  S: () => act({ do: "backStatement" }),
  w: () => transport.step("slow"),
  f: () => transport.step("fast"),
  t: () => signals.toggleSignal(state.selected),
  g: () => program.showStatement(state.at.statement),
  "/": () => byId("filter").focus(),
  "?": () => byId("keys").showModal(),
};

function listenToKeys() {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isTyping() || byId("keys").open || !(event.key in keys)) return;
    if (event.key === " " && document.activeElement?.tagName === "BUTTON") return;  // the button's own
    event.preventDefault();
    keys[event.key]();
  });
  byId("help").addEventListener("click", () => byId("keys").showModal());
}

let shownIdentity = "";
const identityOf = (outline) => JSON.stringify([outline.name, outline.rows.length, outline.signals.length, outline.link?.address]);

async function start() {
  state.outline = await get("/api/program");
  shownIdentity = identityOf(state.outline);
  document.title = state.outline.name + " - plcxx live";
  byId("name").textContent = state.outline.name;
  byId("control").textContent = state.outline.control;
  for (const part of [link, transport, signals, program, panel, watches, chart]) part.begin();
  listenToKeys();
  listen(apply, begun, (isGone) => (byId("gone").hidden = !isGone));
}

/** The stream has begun, perhaps of another server than before: then the page is another one. */
async function begun() {
  forgetAll();
  try {
    if (identityOf(await get("/api/program")) !== shownIdentity) location.reload();
  } catch (error) {
    say(error.message);
  }
}

start().catch((error) => say(error.message));
