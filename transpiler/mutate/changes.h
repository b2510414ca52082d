// Small changes of a program, one at a time, as a slip of the pen makes them: what its scenarios ought to notice.
//
// In: a program as it is executed (ir-optimized) and its sources. Out: changes in the order of the source, each of one
// statement, the same for the same program everywhere; and the program with one of them. A contact that is always 0 or
// always 1, a number that is one more or less, another operator, an assignment or a call that is left out. Of changes
// that are the same by construction (each contact of a series that is always 0) the first one stands for all. Not its
// job: what the control does around the program, which has no statement; running anything (mutate.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/changed_inst.h"
#include "transpiler/source/source.h"

namespace plcxx::mutate {

enum class ChangeKind : uint8_t { kAlways0, kAlways1, kMore, kLess, kOperator, kLeftOut };

/// "always-0", for documents.
std::string_view Name(ChangeKind kind);

struct Change {
  ChangeKind kind{};
  ir::StatementId statement;
  ir::InstId inst;       // that is changed; of a value the instruction that uses it
  uint32_t use = 0;      // of a value: which of that instruction's uses, in the order of ir::ForEachUse
  ir::RegionId region;   // where it stands
  ir::OpKind becomes{};  // kOperator
  source::Range range;   // what the source says there; the statement where nothing is known
  std::string text;      // "I0A2 is always 0"
};

/// An operation and what is put in its place.
struct OperatorChange {
  ir::OpKind from{}, to{};
  std::string_view text;
};
const std::vector<OperatorChange>& OperatorChanges();

std::vector<Change> FindChanges(const ir::Program& program, const source::SourceManager& sources);

/// `program` is the one in which the change was found.
void Apply(const Change& change, ir::Program& program);

/// The same for a simulator of the program in which the change was found.
sim::ChangedInst AsExecuted(const Change& change, const ir::Program& program);

}  // namespace plcxx::mutate
