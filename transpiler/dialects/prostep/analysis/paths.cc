#include "transpiler/dialects/prostep/analysis/paths.h"

#include <map>

namespace plcxx::prostep {

ModulePaths::ModulePaths(const Program& program, ModuleId id) : program_(program), first_(0) {
  const Module& module = program.modules[id];
  first_ = module.instructions.first;
  text_.resize(module.instructions.count);
  target_.assign(size(), size());
  for (uint32_t i = 0; i < size(); ++i) {
    const LabelId target = At(i).target;
    if (target.valid()) target_[i] = program.labels[target].at.index - first_;
  }
  ReadText();
  reached_ = From({0});
  stop_.assign(size() + 1, size());
  for (uint32_t i = size(); i-- > 0;) {
    stop_[i] = GoesOn(i) ? stop_[i + 1] : i;
    jumps_back_ = jumps_back_ || (Jumps(i) && target_[i] <= i);
  }
  std::map<uint32_t, size_t> known;
  for (uint32_t i = 0; i < size(); ++i) {
    const ModuleId callee = At(i).module;
    if (!callee.valid() || !reached_[i]) continue;
    const auto [found, is_new] = known.try_emplace(callee.index, calls_.size());
    if (is_new) calls_.push_back({callee, {}});
    calls_[found->second].numbers.push_back(i);
  }
}

bool ModulePaths::Jumps(uint32_t number) const {
  const Op op = At(number).op;
  return op == Op::kJump || op == Op::kJumpIf || op == Op::kEndModule || op == Op::kEndModuleIf;
}

bool ModulePaths::GoesOn(uint32_t number) const {
  const Op op = At(number).op;
  return op != Op::kJump && op != Op::kEndModule;
}

/// What can be executed from the numbers in `open` on, these included.
std::vector<bool> ModulePaths::From(std::vector<uint32_t> open) const {
  std::vector<bool> reached(size() + 1, false);
  while (!open.empty()) {
    const uint32_t number = open.back();
    open.pop_back();
    if (reached[number]) continue;
    reached[number] = true;
    if (number == size()) continue;
    if (Jumps(number)) open.push_back(target_[number]);
    if (GoesOn(number)) open.push_back(number + 1);
  }
  return reached;
}

void ModulePaths::ReadText() {
  std::vector<TextState> levels(1);
  for (uint32_t i = 0; i < size(); ++i) {
    const Op op = At(i).op;
    const Role role = Info(op).role;
    if (role == Role::kClose && levels.size() > 1) levels.pop_back();
    TextState& level = levels.back();
    level.depth = static_cast<uint8_t>(levels.size() - 1);
    text_[i] = level;
    const auto fold = [&level] {
      if (level.in_string) level.first = false;
      level.in_string = false;
    };
    switch (role) {
      case Role::kLogic:
        if (op == Op::kOr || op == Op::kOrNot) fold();
        level.first = false;
        break;
      case Role::kCompare:
        level.in_string = false;
        level.first = false;
        break;
      case Role::kString:
        level.in_string = true;
        level.first = true;
        break;
      case Role::kOpen:
        if (op == Op::kOpenOr) fold();
        levels.emplace_back();
        break;
      case Role::kClose:
        level.first = false;
        break;
      case Role::kNeutral:
        break;
      case Role::kJump:
        fold();
        break;
      case Role::kEnds:
        level = {};
        break;
    }
  }
}

}  // namespace plcxx::prostep
