// Why a signal is what it is after one part of a program: the conditions that make it so, down to inputs.
//
// What is given is a justification: whatever everything else was before the part, as long as the leaves are what they
// are, the signal is what it is after it. It is small, not the smallest: where one of several operands is enough, the
// one is taken that ends at fewer leaves. In: a frame and the signal's cells. Out: conditions, the first one is the
// signal; who wrote what is kept from earlier parts is said, and not followed (scenarios/why.h does that).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "transpiler/explanation/cell_names.h"
#include "transpiler/explanation/frame.h"
#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::explanation {

enum class ConditionKind : uint8_t {
  kWritten,  // in this part, by `statement`; follows from `because`
  kInput,    // the machine, the control or the scenario wrote it, or nothing ever did
  kKept,     // the program wrote it in an earlier part, see `last_write`
  kState,    // what a timer, counter, edge ... has kept: `name` is its name, `text` says what
  kForced,
  kAnswer  // of a host function, which is `name`
};

struct Condition {
  ConditionKind kind{};
  std::string name;       // "U4A8 (COOLANT: coolant pump)"
  std::string label;      // "U4A8"
  std::string text;       // the value as it is read: "1", "18", "0 in bits 1 2"; of kState what it has kept
  std::string predicate;  // what a sentence says of the name: "is 1", "has run 20 of 3000 ms, 2980 ms left"
  std::vector<execute::CellId> cells;
  ir::StatementId statement;  // of kWritten; none: the control's own schedule
  std::optional<sim::LastWrite> last_write;
  std::vector<uint32_t> because;  // indices of conditions; each once
  uint64_t time_ms = 0;           // of the part
  bool is_internal = false;       // in memory that only the schedule knows
};

/// A cell before the part and the bits of it on which the signal rests.
struct LeafCell {
  execute::CellId cell;
  uint64_t bits = 0;
};

struct Explanation {
  std::vector<Condition> conditions;
  std::vector<LeafCell> leaves;      // of kInput, kKept, kState, kForced
  std::vector<std::string> answers;  // host functions whose answers count, each once
  std::string refusal;               // why there is no explanation; then the rest is empty
  bool is_written = false;           // the program wrote the signal in this part
};

/// Whether a condition is only that the schedule came by: which slice is due, whether it is time.
bool IsBookkeeping(const std::vector<Condition>& conditions, uint32_t number);

/// A program, for many questions.
struct Subject {
  explicit Subject(const ir::Program& the_program);
  const ir::Program& program;
  execute::Cells cells;
  CellNames names;
  std::vector<bool> is_named;  // by cell: a routine of the source may read or write it
};

/// `cells`: of the signal, from the least significant bit.
Explanation Explain(const Subject& subject, const Frame& frame, std::span<const execute::CellId> cells,
                    const std::string& name);

}  // namespace plcxx::explanation
