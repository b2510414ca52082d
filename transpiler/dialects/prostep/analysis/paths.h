// The paths through a module, and what the text says of each instruction's place in its sequence (specification 5.3,
// 6.5).
//
// In: a tree without errors. Out: successors by number in the module; number size() is the module's end. Not its job:
// what is on the paths (warnings_paths.cc).
#pragma once

#include <cstdint>
#include <vector>

#include "transpiler/dialects/prostep/syntax/syntax.h"

namespace plcxx::prostep {

/// Before the instruction, on the bracket level on which it acts (a closing bracket: on the one outside).
struct TextState {
  bool first = true;       // it loads
  bool in_string = false;  // after an operand-less O
  uint8_t depth = 0;       // of brackets
};

class ModulePaths {
 public:
  ModulePaths(const Program& program, ModuleId module);

  uint32_t size() const { return static_cast<uint32_t>(text_.size()); }
  const Instruction& At(uint32_t number) const { return program_.instructions[InstructionId(first_ + number)]; }
  const TextState& Text(uint32_t number) const { return text_[number]; }

  /// Where the jump of the instruction goes; size() when it leaves the module, or is no jump.
  uint32_t Target(uint32_t number) const { return target_[number]; }
  bool Jumps(uint32_t number) const;
  /// Goes the program on after the instruction?
  bool GoesOn(uint32_t number) const;

  bool IsReached(uint32_t number) const { return reached_[number]; }
  /// Calls visit(next) for each instruction that can be executed after this one; size() is the module's end.
  void VisitNext(uint32_t number, const auto& visit) const {
    if (number == size()) return;
    if (Jumps(number)) visit(Target(number));
    if (GoesOn(number)) visit(number + 1);
  }
  /// Does what is executed at `from` come to each instruction as far as `to`?
  bool IsStraight(uint32_t from, uint32_t to) const { return stop_[from] >= to; }
  /// Does some jump of the module go back?
  bool jumps_back() const { return jumps_back_; }

  struct Calls {
    ModuleId callee;
    std::vector<uint32_t> numbers;  // ascending
  };
  /// The instructions that are reached and execute another module, for each of these; in the order of the first ones.
  const std::vector<Calls>& calls() const { return calls_; }

 private:
  std::vector<bool> From(std::vector<uint32_t> open) const;
  void ReadText();

  const Program& program_;
  uint32_t first_;
  std::vector<TextState> text_;
  std::vector<uint32_t> target_;
  std::vector<bool> reached_;
  std::vector<uint32_t> stop_;  // by number: the first one from there on after which the program does not go on
  bool jumps_back_ = false;
  std::vector<Calls> calls_;
};

}  // namespace plcxx::prostep
