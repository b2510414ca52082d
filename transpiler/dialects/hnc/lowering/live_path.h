// Jumps forward and what is known where they arrive: labels, and what `break` and `continue` leave.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "transpiler/dialects/hnc/lowering/context.h"

namespace plcxx::hnc {

class LivePath : Context {
 public:
  explicit LivePath(const Context& context) : Context(context) {}

  /// What `break` and `continue` lead to in a loop or a switch.
  struct Exits {
    uint32_t on_break = 0, on_continue = 0;
    bool is_loop = false;
    std::vector<Flow> at_ends;  // of the arms of a switch that need no jump
  };
  static constexpr uint32_t kEndOfFunction = 0;  // the label after its last statement

  void BeginFunction();
  uint32_t NewLabel() { return next_label_++; }
  void JumpTo(uint32_t label);
  void JumpWhen(ir::ValueId condition, uint32_t label);
  /// Whether a jump leads there: else there is none.
  bool PlaceLabel(uint32_t label);
  void Enter(Exits exits) { around_.push_back(std::move(exits)); }
  /// What is known where the arms of the switch ended.
  std::vector<Flow> Leave();
  void Break();
  void Continue();
  /// The end of an arm needs no jump to where the switch ends.
  void EndCase();

 private:
  uint32_t next_label_ = 1;
  std::map<uint32_t, Flow> targets_;  // by label that jumps forward lead to: what is known there
  std::vector<Exits> around_;
};

}  // namespace plcxx::hnc
