// The sections of the page, one file each. Only page*.cc include this.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/report/cross_reference.h"
#include "transpiler/report/page.h"
#include "transpiler/report/rows.h"

namespace plcxx::report {

/// All that the sections show of one version of a program.
struct View {
  explicit View(const ProgramInput& input, std::string_view anchor_prefix = "");

  const ProgramInput& input;
  std::string prefix;  // of all ids: two versions may stand in one page
  CrossReference uses;
  Rows rows;
  std::vector<uint64_t> time_ns, code_bytes;  // by StatementId, without what is nested in it
  std::vector<std::string> signal_anchors;    // by signal

  std::string AnchorOf(ir::StatementId statement) const { return prefix + rows.anchors[statement.index]; }
  /// "turret.plc:12"; of the control's own, its name.
  std::string PlaceOf(ir::StatementId statement) const;
  std::string PartsOf(ir::StatementId statement) const;
};

/// What the review says about a statement, for its row.
struct Marks {
  std::vector<Verdict> verdict;     // by StatementId; kEqual: nothing to say
  std::vector<std::string> places;  // by StatementId: "U4A8, U4A9"
};

// Each appends its section.
void AppendOverview(const View& view, std::string& out);
void AppendRows(const View& view, const Marks& marks, std::string& out);
void AppendSignals(const View& view, std::string& out);
void AppendLists(const View& view, std::string& out);
void AppendMemory(const View& view, std::string& out);
void AppendTables(const View& view, std::string& out);
void AppendFiles(const View& view, std::string& out);
void AppendReview(const View& old_view, const View& view, const Review& review, std::string& out);
/// What the search looks at, as JSON.
std::string SearchIndex(const View& view);

/// The source, C++ and ladder cells of a row.
void AppendCells(const View& view, const Row& row, std::string& out);
/// A link to a statement, its place for text; plain text where the page does not show it.
std::string Link(const View& view, ir::StatementId statement);
std::string Cell(std::string_view text, std::string_view element = "td");
/// "1.25 µs", "340 ns".
std::string TimeText(uint64_t ns);

}  // namespace plcxx::report
