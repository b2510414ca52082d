#include "transpiler/dialects/classicladder/parser/checks.h"

#include <algorithm>
#include <set>

#include "transpiler/dialects/classicladder/parser/expressions.h"
#include "transpiler/support/check.h"

namespace plcxx::classicladder {
namespace {

class Checker {
 public:
  Checker(Program& program, const Settings& settings, diag::Engine& diagnostics)
      : program_(program), settings_(settings), diagnostics_(diagnostics) {}

  void Run() {
    for (auto& [number, section] : program_.sections) {
      if (section.language == Language::kLadder) CheckSection(section);
    }
    for (const auto& [number, section] : program_.sections) {
      if (section.subroutine >= 0) FindCircle(section);
    }
    CheckPages();
    CheckBits();
    const Address last_output{VariableKind::kWordOutput, program_.sizes.word_outputs - 1};
    if (!Resolve(last_output, program_.sizes)) {
      diagnostics_.Report({}, diag::ClassicladderVariableOutside, NameOf(last_output));
    }
  }

 private:
  void CheckSection(const Section& section);
  void CheckRung(const Section& section, const std::vector<uint32_t>& chain, Rung& rung);
  void CheckElement(const Section& section, const std::vector<uint32_t>& chain, Element& element);
  void CheckJump(const Section& section, const std::vector<uint32_t>& chain, const Element& jump);
  void CheckCall(const Element& call);
  void CheckNumber(const Element& element, std::string_view what, uint32_t count);
  void CheckMonostable(const Element& element);
  void CheckExpression(const Element& element);
  void CheckVariable(Variable& variable);
  void CheckWritten(const Variable& variable);
  void CheckPages();
  void CheckBits();
  bool IsBoolean(const Expression& expression, uint32_t node) const;
  bool ReadsBits() const;
  void FindCircle(const Section& section);

  Program& program_;
  const Settings& settings_;
  diag::Engine& diagnostics_;
  std::set<uint32_t> checked_;           // rungs
  std::set<uint32_t> callers_, looked_;  // sections: on the way to the present one, and done with
};

void Checker::CheckSection(const Section& section) {
  const auto missing = [&](std::string_view what, uint32_t rung) {
    if (program_.rungs.contains(rung)) return false;
    diagnostics_.Report(section.range, diag::ClassicladderRungMissing,
                        "the " + std::string(what) + " of section '" + section.name + "'", static_cast<int64_t>(rung));
    return true;
  };
  if (missing("first rung", section.first_rung) || missing("last rung", section.last_rung)) return;
  const std::vector<uint32_t> chain = ChainOf(program_, section);
  if (chain.back() != section.last_rung) {
    const Rung& end = program_.rungs[chain.back()];
    if (end.next >= 0 && !program_.rungs.contains(static_cast<uint32_t>(end.next))) {
      diagnostics_.Report(end.range, diag::ClassicladderRungMissing,
                          "the next rung of rung " + std::to_string(end.number), static_cast<int64_t>(end.next));
    } else {
      diagnostics_.Report(section.range, diag::ClassicladderRungChain, section.name,
                          static_cast<int64_t>(section.last_rung));
    }
    return;
  }
  for (const uint32_t rung : chain) CheckRung(section, chain, program_.rungs[rung]);
}

void Checker::CheckRung(const Section& section, const std::vector<uint32_t>& chain, Rung& rung) {
  const bool is_new = checked_.insert(rung.number).second;
  for (auto& row : rung.rows) {
    for (Element& element : row) {
      if (element.kind == ElementKind::kJump) {
        CheckJump(section, chain, element);
      } else if (is_new) {
        CheckElement(section, chain, element);
      }
    }
  }
}

void Checker::CheckNumber(const Element& element, std::string_view what, uint32_t count) {
  if (element.number < count) return;
  diagnostics_.Report(element.range, diag::ClassicladderRange, what, std::to_string(element.number), "0",
                      std::to_string(count - 1));
}

void Checker::CheckMonostable(const Element& element) {
  const auto found = program_.monostables.find(element.number);
  if (found == program_.monostables.end()) return;
  const int64_t preset_ms = int64_t{found->second.preset} * found->second.base_ms;
  if (preset_ms >= 0 && preset_ms % settings_.period_ms == 0) return;
  diagnostics_.Report(element.range, diag::ClassicladderMonostableOnce, static_cast<int64_t>(element.number), preset_ms,
                      static_cast<int64_t>(settings_.period_ms));
}

void Checker::CheckElement(const Section& section, const std::vector<uint32_t>& chain, Element& element) {
  switch (element.kind) {
    case ElementKind::kFree:
    case ElementKind::kWire:
    case ElementKind::kPart:
      return;
    case ElementKind::kContact:
    case ElementKind::kContactNot:
    case ElementKind::kRising:
    case ElementKind::kFalling:
      return CheckVariable(element.variable);
    case ElementKind::kCoil:
    case ElementKind::kCoilNot:
    case ElementKind::kSet:
    case ElementKind::kReset:
      CheckVariable(element.variable);
      return CheckWritten(element.variable);
    case ElementKind::kTimer:
      return CheckNumber(element, "timer", program_.sizes.timers);
    case ElementKind::kMonostable:
      CheckNumber(element, "monostable", program_.sizes.monostables);
      return CheckMonostable(element);
    case ElementKind::kCounter:
      return CheckNumber(element, "counter", program_.sizes.counters);
    case ElementKind::kTimerIec:
      return CheckNumber(element, "IEC timer", program_.sizes.timers_iec);
    case ElementKind::kCompare:
    case ElementKind::kOperate:
      return CheckExpression(element);
    case ElementKind::kJump:
      return CheckJump(section, chain, element);
    case ElementKind::kCall:
      return CheckCall(element);
  }
  PLCXX_UNREACHABLE();
}

void Checker::CheckJump(const Section& section, const std::vector<uint32_t>& chain, const Element& jump) {
  CheckNumber(jump, "rung", program_.sizes.rungs);
  if (jump.number >= program_.sizes.rungs || std::ranges::find(chain, jump.number) != chain.end()) return;
  if (!program_.rungs.contains(jump.number)) {
    diagnostics_.Report(jump.range, diag::ClassicladderJumpNowhere, static_cast<int64_t>(jump.number));
  } else {
    diagnostics_.Report(jump.range, diag::ClassicladderJumpElsewhere, static_cast<int64_t>(jump.number), section.name);
  }
}

void Checker::CheckCall(const Element& call) {
  const Section* subroutine = SubroutineOf(program_, call.number);
  if (subroutine == nullptr) {
    diagnostics_.Report(call.range, diag::ClassicladderCallNowhere, static_cast<int64_t>(call.number));
  } else if (subroutine->language == Language::kSequential) {
    diagnostics_.Report(call.range, diag::ClassicladderCallOfPage, static_cast<int64_t>(call.number));
  }
}

void Checker::FindCircle(const Section& section) {
  if (looked_.contains(section.number)) return;
  if (!callers_.insert(section.number).second) {
    diagnostics_.Report(section.range, diag::ClassicladderRecursion, section.subroutine);
    return;
  }
  std::set<const Section*> called;
  for (const uint32_t rung : ChainOf(program_, section)) {
    for (const auto& row : program_.rungs[rung].rows) {
      for (const Element& element : row) {
        if (element.kind != ElementKind::kCall) continue;
        const Section* subroutine = SubroutineOf(program_, element.number);
        if (subroutine != nullptr && subroutine->language == Language::kLadder) called.insert(subroutine);
      }
    }
  }
  for (const Section* subroutine : called) FindCircle(*subroutine);
  callers_.erase(section.number);
  looked_.insert(section.number);
}

void Checker::CheckExpression(const Element& element) {
  CheckNumber(element, "expression", program_.sizes.expressions);
  const bool compares = element.kind == ElementKind::kCompare;
  auto& read = compares ? program_.comparisons : program_.operations;
  if (read.contains(element.number)) return;
  const auto found = program_.expressions.find(element.number);
  const ExpressionText text = found == program_.expressions.end() ? ExpressionText{} : found->second;
  if (text.faulty) return;
  Expression expression = compares ? ParseComparison(text, program_.sizes.version, diagnostics_)
                                   : ParseOperation(text, program_.sizes.version, diagnostics_);
  if (expression.empty) {
    diagnostics_.Report(element.range, diag::ClassicladderNoExpression, static_cast<int64_t>(element.number),
                        compares ? "the comparison is never true" : "the box does nothing");
  }
  for (ExprNode& node : expression.nodes) {
    if (node.kind == ExprKind::kVariable) CheckVariable(node.variable);
  }
  if (!compares && !expression.empty) {
    CheckVariable(expression.target);
    CheckWritten(expression.target);
  }
  read[element.number] = std::move(expression);
}

void Checker::CheckVariable(Variable& variable) {
  const auto check = [&](Address& address, bool replace) {
    const auto resolved = Resolve(address, program_.sizes);
    if (!resolved) {
      diagnostics_.Report(variable.range, diag::ClassicladderVariableOutside, NameOf(address));
    } else if (replace && *resolved != address) {
      diagnostics_.Report(variable.range, diag::ClassicladderBeyondItsKind, NameOf(address),
                          static_cast<int64_t>(CountOf(address.kind, program_.sizes)), NameOf(*resolved));
      address = *resolved;
    }
  };
  check(variable.address, !variable.index);
  if (variable.index) check(*variable.index, true);
}

void Checker::CheckWritten(const Variable& variable) {
  if (Info(variable.address.kind).access == Access::kWritten) return;
  diagnostics_.Report(variable.range, diag::ClassicladderWriteIgnored, NameOf(variable.address));
}

void Checker::CheckPages() {
  int64_t pages = 0;
  for (const auto& [number, section] : program_.sections) {
    if (section.language == Language::kSequential) ++pages;
  }
  if (pages == 0) return;
  for (const auto& [number, section] : program_.sections) {
    if (section.language == Language::kSequential && pages > 1) {
      diagnostics_.Report(section.range, diag::ClassicladderPagesShareTime, pages);
      break;
    }
  }
  for (const auto& [index, step] : program_.steps) {
    if (step.page < 0) continue;
    for (const VariableKind kind : {VariableKind::kStepActive, VariableKind::kStepTime}) {
      const Address address{kind, step.number};
      if (!Resolve(address, program_.sizes)) {
        diagnostics_.Report(step.range, diag::ClassicladderVariableOutside, NameOf(address));
      }
    }
  }
  // An array of steps of which most are not there: each writes the variables of number 0 in 2.9.
  for (const auto& [index, step] : program_.steps) {
    if (program_.sizes.version != LinuxCnc::kTwoNine || step.number != 0 || index == kSteps - 1) continue;
    diagnostics_.Report(step.range, diag::ClassicladderStepZero);
  }
  for (auto& [index, transition] : program_.transitions) {
    if (transition.page >= 0) CheckVariable(transition.condition);
  }
}

bool Checker::ReadsBits() const {
  const auto reads = [](const auto& expressions) {
    return std::ranges::any_of(expressions, [](const auto& each) {
      return std::ranges::any_of(each.second.nodes, [](const ExprNode& node) {
        const bool bit = node.kind == ExprKind::kVariable && IsBit(node.variable.address.kind);
        return bit || (node.variable.index && IsBit(node.variable.index->kind));
      });
    });
  };
  return reads(program_.comparisons) || reads(program_.operations);
}

/// Whether a node is 0 or 1 in each case, where bits are.
bool Checker::IsBoolean(const Expression& expression, uint32_t node) const {
  const ExprNode& at = expression.nodes[node];
  const auto operand = [&](uint32_t each) { return IsBoolean(expression, each); };
  switch (at.kind) {
    case ExprKind::kConstant:
      return at.value <= 1;
    case ExprKind::kVariable:
      return IsBit(at.variable.address.kind);
    case ExprKind::kNot:
      return true;
    case ExprKind::kAnd: {
      const auto one = [&](uint32_t each) {
        const ExprNode& other = expression.nodes[each];
        return other.kind == ExprKind::kConstant && other.value <= 1;
      };
      return std::ranges::any_of(at.operands, one) || std::ranges::all_of(at.operands, operand);
    }
    case ExprKind::kOr:
    case ExprKind::kMultiply:
    case ExprKind::kAbs:
    case ExprKind::kMinimum:
    case ExprKind::kMaximum:
      return std::ranges::all_of(at.operands, operand);
    case ExprKind::kPower:
    case ExprKind::kDivide:
    case ExprKind::kModulo:
    case ExprKind::kAdd:
    case ExprKind::kSubtract:
    case ExprKind::kAverage:
      return false;
  }
  PLCXX_UNREACHABLE();
}

/// A bit of the engine keeps a number of 8 bits. Only an expression can tell that from 1.
void Checker::CheckBits() {
  if (!ReadsBits()) return;
  for (const auto& [number, operation] : program_.operations) {
    if (operation.nodes.empty() || operation.empty || !IsBit(operation.target.address.kind)) continue;
    if (Info(operation.target.address.kind).access == Access::kRead || IsBoolean(operation, operation.right)) continue;
    diagnostics_.Report(operation.target.range, diag::ClassicladderNumberInBit, NameOf(operation.target.address));
  }
}

}  // namespace

void CheckProgram(Program& program, const Settings& settings, diag::Engine& diagnostics) {
  if (program.sections.empty()) return;
  Checker(program, settings, diagnostics).Run();
}

}  // namespace plcxx::classicladder
