#include "transpiler/dialects/technol/syntax/raised_errors.h"

#include <algorithm>
#include <tuple>

namespace plcxx::technol {

std::vector<dialects::RaisedError> RaisedErrors(const Program& program) {
  std::vector<dialects::RaisedError> errors;
  for (const Instruction& instruction : program.instructions) {
    if (instruction.op != Op::kEset || instruction.faulty || instruction.operands.count == 0) continue;
    const int64_t sub = instruction.operands.count > 1 ? program.OperandOf(instruction, 1).value : 0;
    errors.push_back({.main = static_cast<uint32_t>(program.OperandOf(instruction, 0).value),
                      .sub = static_cast<uint32_t>(sub),
                      .range = instruction.range});
  }
  const auto key = [](const dialects::RaisedError& error) {
    return std::tuple(error.main, error.sub, error.range.begin);
  };
  std::ranges::stable_sort(errors, {}, key);
  return errors;
}

}  // namespace plcxx::technol
