// Labels, and the jumps of a module that wait for them (specification 2.3, 6.5).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/parser/line_reader.h"

namespace plcxx::prostep {

struct PendingJump {
  InstructionId instruction;
  std::string name;
  source::Range range;
};

class LabelReader : private LineReader {
 public:
  LabelReader(Parsing& parsing, BracketChecker& brackets) : LineReader(parsing), brackets_(brackets) {}

  /// The word before the colon; none when there is none or it is none (reported).
  const Token* TheLabel(const Statement& statement);
  void DefineLabel(const Token& token);
  /// Reports what is wrong with it as a label of a line or as the target of a jump.
  bool IsLabel(std::string_view name, source::Range range);
  void AddJump(PendingJump jump) { jumps_.push_back(std::move(jump)); }
  /// None: the instruction that is added next is no jump.
  const PendingJump* JumpOfNextInstruction() const;
  /// Jumps get their targets.
  void EndModule(const Module& module);

 private:
  BracketChecker& brackets_;
  std::map<std::string, LabelId, std::less<>> labels_;  // of the open module
  std::vector<PendingJump> jumps_;
};

}  // namespace plcxx::prostep
