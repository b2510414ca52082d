// The rows of the page: stretches of the source, each with the C++ that was generated from it and its ladder rungs.
//
// In: a program's input, its ladders. Out: rows in the order of the sources. Every line of every source is in a row but
// blank ones, every line of C++ that is a statement's, and every ladder item: nothing is left out, and nothing stands
// twice. What the control does around the statements is in rows of its own after them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/report/ladder.h"
#include "transpiler/report/program_input.h"

namespace plcxx::report {

struct SourceLine {
  uint32_t number = 0;
  std::string_view text;
  bool comment = false;  // nothing but a comment of a statement
};

struct CodeLine {
  uint32_t file = 0;  // index into ProgramInput::generated
  uint32_t number = 0;
  std::string_view text;
};

struct Row {
  source::FileId file;                      // none: the control's own
  std::string title;                        // of the control's own rows: the routine
  std::vector<ir::StatementId> statements;  // that begin here
  ir::StatementId continues;                // the statement whose later lines these are
  std::vector<SourceLine> source;
  std::vector<CodeLine> code;
  std::vector<LadderItem> ladder;
};

struct Rows {
  std::vector<Row> rows;
  std::vector<uint32_t> of_statement;   // by StatementId: where it begins
  std::vector<std::string> anchors;     // by StatementId: the same as long as its text is the same
  std::vector<ir::RoutineId> routines;  // by StatementId: the one that executes it; none: nothing does
};
inline constexpr uint32_t kNoRow = 0xFFFFFFFF;

Rows MakeRows(const ProgramInput& input, std::vector<RoutineLadder> ladders);

/// The name of a file without its directories: where it lay is nobody's business.
std::string_view FileName(std::string_view path);

}  // namespace plcxx::report
