#include "transpiler/report/rows.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "transpiler/report/routine_title.h"
#include "transpiler/support/hex.h"

namespace plcxx::report {
namespace {

bool IsBlank(std::string_view text) { return text.find_first_not_of(" \t\r\f\v") == std::string_view::npos; }

/// The lines of one file, each with the statement that it belongs to.
struct OwnedLines {
  struct OwnedLine {
    ir::StatementId owner;
    std::vector<ir::StatementId> begin;  // statements that begin in this line
    bool comment = false;
  };
  std::vector<OwnedLine> lines;  // [0] is not used
};

class RowMaker {
 public:
  explicit RowMaker(const ProgramInput& input) : input_(input), program_(*input.program), sources_(*input.sources) {
    rows_.of_statement.assign(program_.statements.size(), kNoRow);
    rows_.routines.assign(program_.statements.size(), {});
  }

  Rows Run(std::vector<RoutineLadder> ladders) {
    Anchors();
    Files();
    for (const source::FileId file : files_) SourceRows(file, OwnersOf(file));
    Strays();
    Code();
    for (RoutineLadder& ladder : ladders) Ladder(std::move(ladder));
    return std::move(rows_);
  }

 private:
  void Anchors();
  void Files();
  OwnedLines OwnersOf(source::FileId file);
  void SourceRows(source::FileId file, const OwnedLines& owned);
  void Strays();
  void Code();
  void Ladder(RoutineLadder ladder);
  uint32_t Continuation(ir::StatementId statement, uint32_t before) const;

  const ProgramInput& input_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  Rows rows_;
  std::vector<source::FileId> files_;
  std::unordered_map<uint32_t, std::vector<ir::StatementId>> statements_of_;  // by FileId, by place
};

void RowMaker::Anchors() {
  std::unordered_map<std::string, uint32_t> count;
  for (const ir::Statement& statement : program_.statements) {
    std::string anchor = "s-" + support::HexDigits(statement.id, 8);
    const uint32_t before = count[anchor]++;
    if (before > 0) anchor += "-" + std::to_string(before + 1);
    rows_.anchors.push_back(std::move(anchor));
  }
}

/// The program's own, then those that hold statements beside them; tables of names, which have none, last.
void RowMaker::Files() {
  files_ = input_.files;
  for (uint32_t i = 0; i < program_.statements.size(); ++i) {
    const ir::Statement& statement = program_.statements[ir::StatementId(i)];
    const source::FileId file = sources_.FileAt(statement.range.begin);
    if (!file.valid()) continue;
    std::vector<ir::StatementId>& known = statements_of_[file.index];
    if (known.empty() && std::ranges::find(files_, file) == files_.end()) files_.push_back(file);
    known.push_back(ir::StatementId(i));
  }
  std::ranges::stable_partition(files_, [this](source::FileId file) { return statements_of_.contains(file.index); });
  for (auto& [file, statements] : statements_of_) {
    // What holds others comes before them.
    std::ranges::stable_sort(statements, {}, [this](ir::StatementId id) {
      const source::Range range = program_.statements[id].range;
      return std::pair(range.begin, ~range.end);
    });
  }
}

OwnedLines RowMaker::OwnersOf(source::FileId file) {
  OwnedLines owned;
  owned.lines.resize(sources_.LineCount(file) + 1);
  const auto line_of = [&](source::Offset offset) {
    return std::min<size_t>(sources_.Locate(offset).line, owned.lines.size() - 1);
  };
  for (const ir::StatementId id : statements_of_[file.index]) {
    const ir::Statement& statement = program_.statements[id];
    const size_t first = line_of(statement.range.begin);
    const size_t last = line_of(std::max(statement.range.begin, statement.range.end - 1));
    for (const source::Range& comment : statement.comments) {
      const size_t line = line_of(comment.begin);
      if (sources_.FileAt(comment.begin) != file || line == 0 || line >= first) continue;
      if (!owned.lines[line].begin.empty()) continue;
      owned.lines[line].owner = id;
      owned.lines[line].comment = true;
    }
    if (owned.lines[first].begin.empty()) owned.lines[first].owner = id;
    owned.lines[first].begin.push_back(id);
    for (size_t line = first + 1; line <= last; ++line) {
      owned.lines[line].owner = id;
      owned.lines[line].comment = false;
    }
  }
  return owned;
}

void RowMaker::SourceRows(source::FileId file, const OwnedLines& owned) {
  bool open = false;
  ir::StatementId owner;
  for (uint32_t number = 1; number < owned.lines.size(); ++number) {
    const OwnedLines::OwnedLine& line = owned.lines[number];
    const std::string_view text = sources_.Line(file, number);
    if (IsBlank(text) && line.begin.empty() && line.owner != owner) continue;
    const bool head = !line.begin.empty() && open && !rows_.rows.back().statements.empty();
    if (!open || line.owner != owner || head) {
      rows_.rows.emplace_back();
      rows_.rows.back().file = file;
      if (line.owner.valid() && rows_.of_statement[line.owner.index] != kNoRow) {
        rows_.rows.back().continues = line.owner;
      }
      open = true;
      owner = line.owner;
    }
    Row& row = rows_.rows.back();
    row.source.push_back({number, text, line.comment});
    for (const ir::StatementId id : line.begin) {
      row.statements.push_back(id);
      row.continues = {};
      rows_.of_statement[id.index] = static_cast<uint32_t>(rows_.rows.size() - 1);
    }
  }
  for (Row& row : rows_.rows) {
    while (!row.source.empty() && IsBlank(row.source.back().text)) row.source.pop_back();
  }
  std::erase_if(rows_.rows, [](const Row& row) { return row.source.empty() && row.statements.empty(); });
}

/// Statements without a place in a source, the control's own.
void RowMaker::Strays() {
  // Rows may have been taken out: where each statement begins is found anew.
  std::ranges::fill(rows_.of_statement, kNoRow);
  for (uint32_t i = 0; i < rows_.rows.size(); ++i) {
    for (const ir::StatementId id : rows_.rows[i].statements) rows_.of_statement[id.index] = i;
  }
  for (uint32_t i = 0; i < program_.statements.size(); ++i) {
    if (rows_.of_statement[i] != kNoRow) continue;
    Row row;
    row.title = program_.statements[ir::StatementId(i)].subject;
    if (row.title.empty()) row.title = "statement of the control";
    row.statements = {ir::StatementId(i)};
    rows_.of_statement[i] = static_cast<uint32_t>(rows_.rows.size());
    rows_.rows.push_back(std::move(row));
  }
}

/// Where the later part of a statement stands that began before the row `before`: its own next row, else that one.
uint32_t RowMaker::Continuation(ir::StatementId statement, uint32_t before) const {
  const uint32_t first = rows_.of_statement[statement.index];
  if (before == kNoRow || before < first) return first;
  for (uint32_t i = before; i < rows_.rows.size() && i < before + 3; ++i) {
    if (rows_.rows[i].continues == statement) return i;
  }
  return before;
}

void RowMaker::Code() {
  std::vector<bool> seen(program_.statements.size());
  for (uint32_t f = 0; f < input_.generated.size(); ++f) {
    const GeneratedFile& file = input_.generated[f];
    const std::string_view text = file.text;
    size_t next = 0;  // owner
    uint32_t row = kNoRow;
    uint32_t number = 1;
    for (size_t at = 0; at < text.size(); ++number) {
      const size_t end = std::min(text.find('\n', at), text.size());
      while (next < file.owners.size() && file.owners[next].line <= number) {
        const ir::StatementId owner = file.owners[next++].statement;
        if (!owner.valid()) {
          row = kNoRow;
          continue;
        }
        row = seen[owner.index] ? Continuation(owner, row) : rows_.of_statement[owner.index];
        seen[owner.index] = true;
      }
      const std::string_view line = text.substr(at, end - at);
      if (row != kNoRow && !IsBlank(line)) rows_.rows[row].code.push_back({f, number, line});
      at = end + 1;
    }
  }
}

void RowMaker::Ladder(RoutineLadder ladder) {
  const ir::Routine& routine = program_.routines[ladder.routine];
  uint32_t row = kNoRow;
  uint32_t own_row = kNoRow;
  std::vector<bool> seen(program_.statements.size());
  for (LadderItem& item : ladder.items) {
    if (item.statement.valid()) {
      ir::RoutineId& executes = rows_.routines[item.statement.index];
      if (!executes.valid()) executes = ladder.routine;
    }
    if (item.kind == ItemKind::kStatement) {
      if (!item.statement.valid()) {
        row = kNoRow;
      } else {
        row = seen[item.statement.index] ? Continuation(item.statement, row) : rows_.of_statement[item.statement.index];
        seen[item.statement.index] = true;
      }
      continue;
    }
    if (row == kNoRow) {
      if (own_row == kNoRow) {
        own_row = static_cast<uint32_t>(rows_.rows.size());
        rows_.rows.emplace_back();
        rows_.rows.back().title = RoutineTitle(routine);
      }
      rows_.rows[own_row].ladder.push_back(std::move(item));
    } else {
      rows_.rows[row].ladder.push_back(std::move(item));
    }
  }
}

}  // namespace

std::string_view FileName(std::string_view path) { return path.substr(path.find_last_of("/\\") + 1); }

Rows MakeRows(const ProgramInput& input, std::vector<RoutineLadder> ladders) {
  return RowMaker(input).Run(std::move(ladders));
}

}  // namespace plcxx::report
