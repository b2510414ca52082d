// What an instruction reads and writes, to know which results cannot wait.
#pragma once

#include <vector>

#include "transpiler/dialects/host50/syntax/syntax.h"

namespace plcxx::host50 {

/// Neighbouring numbers of one area; of a timer or counter all its attributes.
struct AddressRange {
  Area area{};
  uint32_t first = 0, last = 0;
};
/// What an instruction writes.
struct WriteSet {
  bool everything = false;  // a subroutine is called
  std::vector<AddressRange> ranges;
};

WriteSet WritesOf(const Program& tree, const Instruction& instruction);
/// Of its own operands, not of the results that it takes.
bool ReadsOwn(const Program& tree, const Instruction& instruction, const WriteSet& writes);

}  // namespace plcxx::host50
