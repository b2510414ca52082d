// Search, keyboard and the card of a signal. Without it the page shows everything, too.
(() => {
  "use strict";
  const byId = (id) => document.getElementById(id);
  const index = JSON.parse(byId("index").textContent);
  const rows = Array.from(document.querySelectorAll("#program > .group > .row"));
  const signals = Array.from(document.querySelectorAll(".sigs > .group > .sig"));
  const field = byId("q");
  const hits = byId("hits");
  const card = byId("card");

  // --- search: a prepared index of texts, one word of the search after the other must be in it --------------------
  const lower = (texts) => texts.map((text) => text.toLowerCase());
  const rowTexts = lower(index.rows);
  const signalTexts = lower(index.signals);
  let found = []; // elements that match, signals first
  let at = -1; // in `found`

  function filter(elements, texts, words, matches) {
    for (let i = 0; i < elements.length; ++i) {
      const match = words.every((word) => texts[i].includes(word));
      if (match && words.length > 0) matches.push(elements[i]);
      if (elements[i].hidden === match) elements[i].hidden = !match;
    }
  }

  /** A group whose rows are hidden takes no room; of the others the browser is told how much they will take. */
  const groups = Array.from(document.querySelectorAll("#program > .group, .sigs > .group"), (element) => ({
    element,
    members: Array.from(element.children),
    lines: element.style.getPropertyValue("--n"),
  }));
  function fit() {
    for (const group of groups) {
      const shown = group.members.reduce((count, member) => count + (member.hidden ? 0 : 1), 0);
      const lines = shown === group.members.length ? group.lines : Math.ceil((group.lines * shown) / group.members.length);
      if (group.element.hidden !== (shown === 0)) group.element.hidden = shown === 0;
      if (shown > 0) group.element.style.setProperty("--n", lines);
    }
  }

  function search() {
    const words = field.value.toLowerCase().split(/\s+/).filter((word) => word !== "");
    const matchingSignals = [];
    const matchingRows = [];
    filter(signals, signalTexts, words, matchingSignals);
    filter(rows, rowTexts, words, matchingRows);
    fit();
    found = matchingRows.concat(matchingSignals);
    at = -1;
    hits.textContent =
      words.length === 0 ? "" : matchingRows.length + " rows, " + matchingSignals.length + " signals";
  }

  let timer = 0;
  field.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(search, 50);
  });

  // --- rows: one is chosen --------------------------------------------------------------------------------------
  let chosen = null;
  function choose(element) {
    if (chosen !== null) chosen.classList.remove("chosen");
    chosen = element;
    if (element === null) return;
    element.classList.add("chosen");
    element.scrollIntoView({ block: "center" });
  }

  function next() {
    clearTimeout(timer);
    if (found.length === 0) search();
    if (found.length === 0) return;
    at = (at + 1) % found.length;
    hits.textContent = at + 1 + " of " + found.length;
    choose(found[at]);
  }

  function clear() {
    field.value = "";
    search();
    field.blur();
    closeCard();
    if (chosen !== null) chosen.scrollIntoView({ block: "center" });
  }

  function step(by) {
    const shown = rows.filter((row) => !row.hidden && row.id !== "");
    if (shown.length === 0) return;
    const now = shown.indexOf(chosen);
    const to = now < 0 ? 0 : Math.min(Math.max(now + by, 0), shown.length - 1);
    choose(shown[to]);
    shown[to].focus({ preventScroll: true });
  }

  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") {
      clear();
    } else if (event.target === field) {
      if (event.key === "Enter") {
        event.preventDefault();
        next();
      }
    } else if (event.target.closest("input, textarea, button, summary") !== null) {
      return;
    } else if (event.key === "/") {
      event.preventDefault();
      field.focus();
      field.select();
    } else if (event.key === "j" || event.key === "k") {
      step(event.key === "j" ? 1 : -1);
    }
  });

  // --- signals: a click shows who writes and reads, and marks it everywhere ------------------------------------------
  const markStyle = document.head.appendChild(document.createElement("style"));
  const byName = new Map();
  signals.forEach((element, i) => {
    const name = element.querySelector("strong").textContent;
    const code = element.querySelector("code");
    if (!byName.has(name)) byName.set(name, i);
    if (code !== null && !byName.has(code.textContent)) byName.set(code.textContent, i);
  });

  function closeCard() {
    card.hidden = true;
    markStyle.textContent = "";
  }

  function showCard(i) {
    const copy = signals[i].cloneNode(true);
    copy.removeAttribute("id");
    copy.hidden = false;
    const link = document.createElement("a");
    link.href = "#" + signals[i].id;
    link.textContent = "in the table";
    copy.append(link);
    byId("card-body").replaceChildren(copy);
    card.hidden = false;
    markStyle.textContent = '.ladder text[data-s="' + i + '"] { fill: var(--different); font-weight: bold; }';
  }
  byId("card-close").addEventListener("click", closeCard);

  /** The word of the source's language under the pointer; names may hold letters of any script. */
  function wordAt(event) {
    const range = document.caretRangeFromPoint ? document.caretRangeFromPoint(event.clientX, event.clientY) : null;
    if (range === null || range.startContainer.nodeType !== Node.TEXT_NODE) return [];
    const text = range.startContainer.data;
    const letter = /[\p{L}\p{N}_]/u;
    let begin = range.startOffset;
    let end = begin;
    while (begin > 0 && letter.test(text[begin - 1])) --begin;
    while (end < text.length && letter.test(text[end])) ++end;
    const word = text.slice(begin, end);
    // Prefixes and suffixes that a dialect writes at a name: %I0, I10.2.
    const longer = /^[.][\p{L}\p{N}_]+/u.exec(text.slice(end));
    return [longer === null ? "" : word + longer[0], (text[begin - 1] || "") + word, word];
  }

  document.querySelector("main").addEventListener("click", (event) => {
    if (event.target.closest("a, summary, button, [data-old]") !== null) return;
    const text = event.target.closest("text[data-s]");
    if (text !== null) {
      showCard(Number(text.dataset.s));
      return;
    }
    if (event.target.closest("pre") !== null) {
      const name = wordAt(event).find((word) => word !== "" && byName.has(word));
      if (name !== undefined) showCard(byName.get(name));
    }
    const row = event.target.closest(".row");
    if (row !== null && row.id !== "" && row !== chosen) {
      if (chosen !== null) chosen.classList.remove("chosen");
      chosen = row;
      row.classList.add("chosen");
    }
  });

  // A link may lead to what the search has hidden.
  function unhide() {
    const target = location.hash === "" ? null : byId(decodeURIComponent(location.hash.slice(1)));
    if (target === null) return;
    const hidden = target.closest("[hidden]");
    if (hidden !== null && hidden !== card) clear();
    for (let around = target.closest("details"); around !== null; around = around.parentElement.closest("details")) {
      around.open = true;
    }
    if (chosen !== null) chosen.classList.remove("chosen");
    chosen = target.closest(".row");
    target.scrollIntoView({ block: "start" });
  }
  addEventListener("hashchange", unhide);
  if (location.hash !== "") unhide();

  // --- which columns are shown --------------------------------------------------------------------------------------
  for (const column of ["src", "cpp", "lad"]) {
    const box = byId("show-" + column);
    const apply = () => document.documentElement.classList.toggle("no-" + column, !box.checked);
    box.addEventListener("change", apply);
    apply(); // the browser may remember an earlier choice
  }
})();
