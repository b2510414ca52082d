// Overview, memory map, the dialect's lists, generated files.

#include <algorithm>
#include <map>

#include "transpiler/ir/zones.h"
#include "transpiler/report/html.h"
#include "transpiler/report/page_parts.h"
#include "transpiler/support/counted.h"

namespace plcxx::report {
namespace {

constexpr size_t kDearest = 20;
constexpr uint64_t kStrip = 64;  // cells of a space's strip

void AppendBudget(const View& view, std::string& out) {
  out +=
      "<h3>Budget</h3>\n<table><thead><tr><th>Partition</th><th class=\"n\">Estimated time</th><th "
      "class=\"n\">Code</th><th>Share</th></tr></thead><tbody>";
  uint64_t most = 1;
  for (const Partition& partition : view.input.partitions)
    most = std::max({most, partition.time_ns, partition.limit_ns});
  for (const Partition& partition : view.input.partitions) {
    out += "<tr>" + Cell(partition.name) + Cell(TimeText(partition.time_ns), "td class=\"n\"") +
           Cell(std::to_string(partition.code_bytes) + " bytes", "td class=\"n\"") + "<td><meter min=\"0\" max=\"" +
           std::to_string(most) + "\" value=\"" + std::to_string(partition.time_ns) + "\" aria-label=\"share\">" +
           TimeText(partition.time_ns) + "</meter>";
    if (partition.limit_ns > 0) out += " of " + TimeText(partition.limit_ns);
    out += "</td></tr>";
  }
  out += "</tbody></table>\n";
  if (view.input.slow_period_ms > 0) {
    out += "<p>The slow part runs in " + std::to_string(view.input.slices) +
           (view.input.slices == 1 ? " slice" : " slices") + ", a whole one every " +
           std::to_string(view.input.slow_period_ms) + " ms.</p>\n";
  }
}

void AppendDearest(const View& view, std::string& out) {
  std::vector<uint32_t> order;
  for (uint32_t i = 0; i < view.time_ns.size(); ++i) {
    if (view.time_ns[i] > 0) order.push_back(i);
  }
  const size_t shown = std::min(kDearest, order.size());
  std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
                    [&view](uint32_t a, uint32_t b) {
                      return view.time_ns[a] != view.time_ns[b] ? view.time_ns[a] > view.time_ns[b] : a < b;
                    });
  out += "<details><summary>The " + std::to_string(shown) +
         " most expensive statements</summary><table><thead><tr><th>Statement"
         "</th><th>Subject</th><th class=\"n\">Time</th><th class=\"n\">Code</th></tr></thead><tbody>";
  for (size_t i = 0; i < shown; ++i) {
    const ir::StatementId id(order[i]);
    out += "<tr><td>" + Link(view, id) + "</td>" + Cell(view.input.program->statements[id].subject) +
           Cell(TimeText(view.time_ns[id.index]), "td class=\"n\"") +
           Cell(std::to_string(view.code_bytes[id.index]) + " bytes", "td class=\"n\"") + "</tr>";
  }
  out += "</tbody></table></details>\n";
}

std::string_view LifetimeText(ir::Lifetime lifetime) {
  switch (lifetime) {
    case ir::Lifetime::kRoutine:
      return "one run of a part";
    case ir::Lifetime::kVolatile:
      return "until power-off";
    case ir::Lifetime::kRetentive:
      return "retentive";
  }
  return "";
}

std::string_view DirectionText(ir::Direction direction) {
  switch (direction) {
    case ir::Direction::kInput:
      return "input";
    case ir::Direction::kOutput:
      return "output";
    case ir::Direction::kInternal:
      return "internal";
  }
  return "";
}

/// "636.6–637.5"; of whole bytes "0–3".
std::string RangeText(const ir::Zone& zone) {
  const uint32_t last = zone.end - std::min(zone.end, 1U);
  const auto text = [&zone](uint32_t bit) {
    const std::string byte = std::to_string(bit / 8);
    return ir::IsOfBytes(zone) ? byte : byte + "." + std::to_string(bit % 8);
  };
  return text(zone.begin) + "–" + text(last);
}

/// Bits in use, and a strip that shows where they lie.
void AppendStrip(const View& view, uint32_t space, std::string& out) {
  const uint64_t bits = uint64_t{view.input.program->spaces[ir::SpaceId(space)].bytes} * 8;
  uint64_t used = 0;
  std::vector<uint64_t> cells(kStrip);
  for (const auto& [first, end] : view.uses.used[space]) {
    const uint64_t last = std::min(end, bits);
    if (first >= last) continue;
    used += last - first;
    for (uint64_t cell = first * kStrip / bits; cell <= (last - 1) * kStrip / bits; ++cell) cells[cell] = 1;
  }
  out += Cell(std::to_string((used + 7) / 8) + " bytes", "td class=\"n\"");
  out +=
      "<td><svg class=\"strip\" width=\"192\" height=\"10\" viewBox=\"0 0 192 10\" role=\"img\" aria-label=\"used\">"
      "<path class=\"room\" d=\"M0 0h192v10h-192z\"/>";
  std::string path;
  for (uint64_t i = 0; i < kStrip; ++i) {
    if (cells[i] != 0) path += "M" + std::to_string(3 * i) + " 0h3v10h-3z";
  }
  if (!path.empty()) out += "<path class=\"used\" d=\"" + path + "\"/>";
  out += "</svg></td>";
}

void AppendSpaces(const View& view, std::string& out) {
  out +=
      "<table><thead><tr><th>Space</th><th>Holds</th><th class=\"n\">Size</th><th>Keeps</th><th>Byte "
      "order</th><th>Directions</th><th class=\"n\">In use</th><th>Where</th></tr></thead><tbody>";
  const ir::Program& program = *view.input.program;
  for (uint32_t i = 0; i < program.spaces.size(); ++i) {
    const ir::Space& space = program.spaces[ir::SpaceId(i)];
    if (space.lifetime == ir::Lifetime::kRoutine) continue;
    out += space.lifetime == ir::Lifetime::kRetentive ? "<tr class=\"retentive\">" : "<tr>";
    out += Cell(space.name, "th scope=\"row\"") + Cell(space.title) +
           Cell(std::to_string(space.bytes) + " bytes", "td class=\"n\"") + Cell(LifetimeText(space.lifetime)) +
           Cell(space.order == ir::ByteOrder::kBig ? "high byte first" : "low byte first") + "<td>";
    for (const ir::Zone& zone : space.zones) {
      out += Escape(DirectionText(zone.direction)) + " " + RangeText(zone);
      out += "<br/>";
    }
    out += "</td>";
    AppendStrip(view, i, out);
    out += "</tr>";
  }
  out += "</tbody></table>\n";
}

std::string OffsetText(const Signal& signal) {
  std::string text = std::to_string(signal.first / 8);
  if (signal.last - signal.first < 8) text += "." + std::to_string(signal.first % 8);
  return text;
}

void AppendSpaceSignals(const View& view, std::string& out) {
  const ir::Program& program = *view.input.program;
  uint32_t open = kNoSignal;
  for (uint32_t i = 0; i < view.uses.signals.size(); ++i) {
    const Signal& signal = view.uses.signals[i];
    if (signal.state.valid() || signal.is_local()) continue;
    if (open != signal.space.index) {
      if (open != kNoSignal) out += "</ul></details>\n";
      open = signal.space.index;
      const ir::Space& space = program.spaces[signal.space];
      out += std::string("<details") + (space.lifetime == ir::Lifetime::kRetentive ? " class=\"retentive\"" : "") +
             "><summary>" + Escape(space.name) + ": what lies where" +
             (space.lifetime == ir::Lifetime::kRetentive ? " (retentive)" : "") + "</summary><ul class=\"names\">";
    }
    out += "<li><code>" + OffsetText(signal) + "</code> <a href=\"#" + view.signal_anchors[i] + "\">" +
           Escape(signal.name) + "</a> <span>" + Escape(signal.type) + "</span></li>";
  }
  if (open != kNoSignal) out += "</ul></details>\n";
}

void AppendInstances(const View& view, std::string& out) {
  std::map<std::string_view, std::vector<uint32_t>> kinds;
  const ir::Program& program = *view.input.program;
  for (uint32_t i = 0; i < program.states.size(); ++i) {
    kinds[ir::Info(program.states[ir::StateId(i)].kind).text].push_back(i);
  }
  if (kinds.empty()) return;
  out +=
      "<h3>Instances</h3>\n<table><thead><tr><th>Kind</th><th class=\"n\">Count</th><th>Names</th></tr></thead><tbody>";
  for (const auto& [kind, states] : kinds) {
    out += "<tr>" + Cell(kind) + Cell(std::to_string(states.size()), "td class=\"n\"") + "<td>";
    for (const uint32_t state : states) {
      const std::string name = Escape(program.states[ir::StateId(state)].name);
      const uint32_t signal = view.uses.of_state[state];
      out += signal == kNoSignal ? name + " " : "<a href=\"#" + view.signal_anchors[signal] + "\">" + name + "</a> ";
    }
    out += "</td></tr>";
  }
  out += "</tbody></table>\n";
}

/// The lines that are no statement's; where statements are left out, how many lines.
void AppendFile(const View& view, const GeneratedFile& file, std::string& out) {
  const std::string_view text = file.text;
  out += "<details><summary>" + Escape(file.name) + ", " + std::to_string(std::count(text.begin(), text.end(), '\n')) +
         " lines</summary><pre class=\"cpp\">";
  size_t next = 0;
  uint32_t number = 1, left_out = 0;
  ir::StatementId owner, first;
  const auto close = [&] {
    if (left_out == 0) return;
    out += "<span class=\"cut\">⋯ " + std::to_string(left_out) + (left_out == 1 ? " line" : " lines") +
           " of statements, from " + Link(view, first) + "</span>";
    left_out = 0;
  };
  for (size_t at = 0; at < text.size(); ++number) {
    const size_t end = std::min(text.find('\n', at), text.size());
    while (next < file.owners.size() && file.owners[next].line <= number) owner = file.owners[next++].statement;
    if (owner.valid()) {
      if (left_out++ == 0) first = owner;
    } else {
      close();
      out += "<span data-n=\"" + std::to_string(number) + "\">" + Escape(text.substr(at, end - at)) + "</span>";
    }
    at = end + 1;
  }
  close();
  out += "</pre></details>\n";
}

}  // namespace

void AppendOverview(const View& view, std::string& out) {
  const ir::Program& program = *view.input.program;
  out += "<section id=\"overview\" aria-labelledby=\"h-overview\">\n<h2 id=\"h-overview\">Overview</h2>\n<p>" +
         support::Counted(program.statements.size(), "statement") + ", " +
         support::Counted(view.uses.signals.size(), "signal") + ", " + std::to_string(program.states.size()) +
         (program.states.size() == 1 ? " timer, counter or edge" : " timers, counters and edges") + ". Dialect " +
         Escape(program.dialect) + ".</p>\n";
  AppendBudget(view, out);
  AppendDearest(view, out);
  out += "</section>\n";
}

void AppendMemory(const View& view, std::string& out) {
  out += "<section id=\"memory\" aria-labelledby=\"h-memory\">\n<h2 id=\"h-memory\">Memory map</h2>\n";
  AppendSpaces(view, out);
  AppendSpaceSignals(view, out);
  AppendInstances(view, out);
  out += "</section>\n";
}

void AppendTables(const View& view, std::string& out) {
  if (view.input.tables.empty()) return;
  out += "<section id=\"tables\" aria-labelledby=\"h-tables\">\n<h2 id=\"h-tables\">Lists of the control</h2>\n";
  for (const Table& table : view.input.tables) {
    out += "<h3>" + Escape(table.title) + "</h3>\n";
    if (table.rows.empty()) {
      out += "<p>none</p>\n";
      continue;
    }
    out += "<table><thead><tr>";
    for (const std::string& column : table.columns) out += Cell(column, "th");
    out += "</tr></thead><tbody>";
    for (const auto& row : table.rows) {
      out += "<tr>";
      for (const std::string& cell : row) out += Cell(cell);
      out += "</tr>";
    }
    out += "</tbody></table>\n";
  }
  out += "</section>\n";
}

void AppendFiles(const View& view, std::string& out) {
  out +=
      "<section id=\"files\" aria-labelledby=\"h-files\">\n<h2 id=\"h-files\">Generated files</h2>\n"
      "<p>What stands around the statements; those are above.</p>\n";
  for (const GeneratedFile& file : view.input.generated) AppendFile(view, file, out);
  out += "</section>\n";
}

}  // namespace plcxx::report
