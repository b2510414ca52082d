// Which instructions are one statement, and what generated code says above it.
//
// A statement is a sequence with all the instructions that use its S: "A ... = ... S ... JC"; likewise a load with the
// transfers after it. Values end with their statement, and so does what a reader has to keep in mind. Its text is lines
// of the source as they are, labels and comments included.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/prostep/lowering/context.h"

namespace plcxx::prostep {

class Registers;

class StatementWriter : Context {
 public:
  StatementWriter(const Context& context, Registers& registers) : Context(context), registers_(registers) {}

  /// The opening line of the module, and where its statements begin. `label_at`: by instruction of the module.
  void BeginModule(const std::vector<bool>& label_at);
  bool BeginsAt(uint32_t index) const { return begins_[index]; }
  /// The one that begins at the instruction `index` of the module.
  void Begin(uint32_t index);
  /// What is in front of END belongs to no instruction.
  void EndModule();

 private:
  bool BeginsFile() const;
  void Cut(const std::vector<bool>& label_at);
  std::string SubjectOf(InstructionId first, InstructionId end) const;
  uint32_t NumberOf(InstructionId first, InstructionId end);
  source::Range LinesOf(InstructionId first, InstructionId end) const;

  Registers& registers_;
  std::vector<bool> begins_;  // by instruction of the module
  std::vector<source::Range> waiting_comments_;
  std::unordered_map<uint32_t, uint32_t> equal_texts_;
  std::unordered_set<uint32_t> used_numbers_;
};

}  // namespace plcxx::prostep
