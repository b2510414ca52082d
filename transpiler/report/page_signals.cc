// Cross reference, and the lists that follow from it.

#include <algorithm>
#include <functional>

#include "transpiler/report/html.h"
#include "transpiler/report/page_parts.h"

namespace plcxx::report {
namespace {

constexpr uint32_t kGroupSignals = 64;  // signals that a browser lays out at once
constexpr size_t kMostShown = 24;       // links of one kind; the rest is folded

std::string SignalLink(const View& view, uint32_t signal) {
  return "<a href=\"#" + view.signal_anchors[signal] + "\">" + Escape(view.uses.signals[signal].name) + "</a>";
}

/// "slow: turret.plc:12 turret.plc:30", one line for each routine.
std::string Occurrences(const View& view, const Signal& signal, const std::function<bool(Use)>& wanted) {
  std::string out;
  size_t shown = 0;
  bool folded = false;
  ir::RoutineId routine;
  bool control = false;  // said once for each routine
  for (const Occurrence& occurrence : signal.occurrences) {
    if (!wanted(occurrence.use)) continue;
    if (occurrence.routine != routine || shown == 0) {
      routine = occurrence.routine;
      control = false;
      const std::string& name = view.input.program->routines[routine].name;
      const std::string& parts = view.uses.parts[routine.index];
      out += "<b>" + Escape(parts == name || parts.empty() ? name : name + " in " + parts) + "</b> ";
    }
    if (!occurrence.statement.valid()) {
      if (control) continue;
      control = true;
    }
    if (shown++ == kMostShown) {
      folded = true;
      out += "<details><summary>more</summary>";
    }
    out += Link(view, occurrence.statement) + " ";
  }
  if (folded) out += "</details>";
  return out;
}

const char* KindOf(const Signal& signal) {
  if (signal.state.valid()) return "instance";
  if (signal.lifetime == ir::Lifetime::kRoutine) return "local";
  switch (signal.direction) {
    case ir::Direction::kInput:
      return "input";
    case ir::Direction::kOutput:
      return "output";
    case ir::Direction::kInternal:
      return signal.lifetime == ir::Lifetime::kRetentive ? "retentive" : "internal";
  }
  return "";
}

void AppendSignal(const View& view, uint32_t index, std::string& out) {
  const Signal& signal = view.uses.signals[index];
  out += "<div role=\"row\" class=\"sig\" id=\"" + view.signal_anchors[index] + "\" tabindex=\"-1\">";
  out += "<div role=\"cell\"><strong>" + Escape(signal.name) + "</strong>";
  if (!signal.address.empty()) out += " <code>" + Escape(signal.address) + "</code>";
  out += std::string("<small>") + Escape(signal.type) + ", " + KindOf(signal) + "</small></div>";
  out += "<div role=\"cell\">" + Escape(signal.words) + "</div><div role=\"cell\">";
  out += Occurrences(view, signal, [](Use use) { return use == Use::kWrite || use == Use::kStep; });
  out += "</div><div role=\"cell\">" + Occurrences(view, signal, [](Use use) { return use == Use::kRead; });
  if (!signal.overlaps.empty()) {
    out += "<small>shares bits with ";
    for (const uint32_t other : signal.overlaps) out += SignalLink(view, other) + " ";
    out += signal.overlaps.size() == kMostOverlaps ? "…</small>" : "</small>";
  }
  out += "</div></div>\n";
}

struct List {
  const char* title;
  const char* none;
  std::vector<uint32_t> signals;
};

void AppendList(const View& view, const List& list, std::string& out) {
  out += std::string("<h3>") + list.title + " <span class=\"count\">" + std::to_string(list.signals.size()) +
         "</span></h3>\n";
  if (list.signals.empty()) {
    out += std::string("<p>") + list.none + "</p>\n";
    return;
  }
  out += "<ul class=\"names\">";
  for (const uint32_t index : list.signals) {
    const Signal& signal = view.uses.signals[index];
    out += "<li>" + SignalLink(view, index);
    if (!signal.address.empty()) out += " <code>" + Escape(signal.address) + "</code>";
    if (!signal.words.empty()) out += " <span>" + Escape(signal.words) + "</span>";
    out += "</li>";
  }
  out += "</ul>\n";
}

/// Written by more than one statement: with each of them, and where they run.
void AppendWrittenTwice(const View& view, std::string& out) {
  std::string items;
  size_t count = 0;
  for (uint32_t i = 0; i < view.uses.signals.size(); ++i) {
    const Signal& signal = view.uses.signals[i];
    if (signal.is_local()) continue;
    const std::vector<ir::StatementId> writers = Writers(signal);
    if (writers.size() < 2) continue;
    std::vector<std::string> parts;
    for (const Occurrence& occurrence : signal.occurrences) {
      const std::string& part = view.uses.parts[occurrence.routine.index];
      if (occurrence.use != Use::kRead && std::ranges::find(parts, part) == parts.end()) parts.push_back(part);
    }
    ++count;
    items += "<li>" + SignalLink(view, i) + (parts.size() > 1 ? " <em>in several parts</em>" : "") + ": ";
    for (size_t k = 0; k < writers.size() && k < kMostShown; ++k) items += Link(view, writers[k]) + " ";
    items += writers.size() > kMostShown ? "…</li>" : "</li>";
  }
  out += "<h3>Written by several statements <span class=\"count\">" + std::to_string(count) + "</span></h3>\n";
  out += count == 0 ? "<p>Every location has one writer at most.</p>\n" : "<ul class=\"names\">" + items + "</ul>\n";
}

}  // namespace

void AppendSignals(const View& view, std::string& out) {
  out +=
      "<section id=\"signals\" aria-labelledby=\"h-signals\">\n<h2 id=\"h-signals\">Signals: who writes, who "
      "reads</h2>\n<div class=\"sigs\" role=\"table\" aria-labelledby=\"h-signals\"><div role=\"row\" class=\"sig "
      "head\"><div role=\"columnheader\">Signal</div><div role=\"columnheader\">Meaning</div><div "
      "role=\"columnheader\">Written by</div><div role=\"columnheader\">Read by</div></div>\n";
  for (uint32_t i = 0; i < view.uses.signals.size(); ++i) {
    if (i % kGroupSignals == 0) {
      const size_t count = std::min<size_t>(kGroupSignals, view.uses.signals.size() - i);
      if (i > 0) out += "</div>\n";
      out += "<div class=\"group\" role=\"rowgroup\" style=\"--n:" + std::to_string(count * 3) + "\">\n";
    }
    AppendSignal(view, i, out);
  }
  out += view.uses.signals.empty() ? "</div></section>\n" : "</div></div></section>\n";
}

void AppendLists(const View& view, std::string& out) {
  List unused{"Named, but not used", "Every name of the program is used.", {}};
  List unread{"Written, but read by no statement", "All that is written is read, or is an output.", {}};
  List unwritten{"Read, but written by no statement", "All that is read is written, or is an input.", {}};
  for (uint32_t i = 0; i < view.uses.signals.size(); ++i) {
    const Signal& signal = view.uses.signals[i];
    if (signal.documented_only && !signal.read && !signal.written) unused.signals.push_back(i);
    if (signal.documented_only || signal.is_local()) continue;
    if (signal.written && !signal.read && signal.direction != ir::Direction::kOutput) unread.signals.push_back(i);
    if (signal.read && !signal.written && signal.direction != ir::Direction::kInput) unwritten.signals.push_back(i);
  }
  out += "<section id=\"lists\" aria-labelledby=\"h-lists\">\n<h2 id=\"h-lists\">Findings</h2>\n";
  AppendList(view, unused, out);
  AppendWrittenTwice(view, out);
  AppendList(view, unread, out);
  AppendList(view, unwritten, out);
  out += "</section>\n";
}

}  // namespace plcxx::report
