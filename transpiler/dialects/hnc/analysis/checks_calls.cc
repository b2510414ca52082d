// Recursion and call depth (specification 6.4), calls of set_mst_func (7.3).

#include <algorithm>
#include <array>
#include <set>

#include "transpiler/dialects/hnc/analysis/checks.h"
#include "transpiler/dialects/hnc/analysis/registrations.h"

namespace plcxx::hnc {
namespace {

constexpr uint32_t kMostDepth = 64;
constexpr size_t kMostHandlers = 255;  // what is registered is kept as a byte, which is 0 for nothing

struct CallSite {
  FunctionId callee;
  source::Range range;
};

class CallGraph {
 public:
  explicit CallGraph(const CheckContext& context) : context_(context), unit_(context.unit) {
    sites_.resize(unit_.functions.size());
    states_.resize(unit_.functions.size());
    heights_.resize(unit_.functions.size());
    for (const FunctionId id : unit_.definitions) {
      for (const ExprId part : context.facts.effects().Of(id)) {
        const Expr& expr = unit_.expressions[part];
        if (expr.kind == ExprKind::kCall && expr.function.valid()) {
          sites_[id.index].push_back({expr.function, expr.range});
        }
      }
      std::ranges::stable_sort(sites_[id.index], {}, [](const CallSite& site) { return site.range.begin; });
    }
    // System functions that call others call what the program has in their place.
    for (uint32_t i = 0; i < unit_.functions.size(); ++i) {
      if (!unit_.functions[FunctionId(i)].system) continue;
      for (const FunctionId callee : context.facts.CalleesOf(FunctionId(i))) {
        sites_[i].push_back({callee, unit_.functions[callee].range});
      }
    }
  }

  void Run() {
    for (const FunctionId root : {unit_.init, unit_.plc1, unit_.plc2}) Visit(root);
    for (const Registration& registration : context_.facts.registrations()) Visit(registration.function);
    for (const FunctionId id : unit_.definitions) Visit(id);
    if (cyclic_) return;
    for (const FunctionId id : unit_.definitions) {
      if (heights_[id.index] <= kMostDepth || context_.facts.PartsOf(id) == 0) continue;
      ReportDepth(id);
      return;
    }
  }

 private:
  enum class State : uint8_t { kNew, kOpen, kDone };
  struct Frame {
    FunctionId function;
    size_t next = 0;
  };

  void Visit(FunctionId root) {
    if (!root.valid() || states_[root.index] != State::kNew) return;
    std::vector<Frame> open = {{root}};
    states_[root.index] = State::kOpen;
    while (!open.empty()) {
      Frame& frame = open.back();
      const std::vector<CallSite>& sites = sites_[frame.function.index];
      if (frame.next == sites.size()) {
        states_[frame.function.index] = State::kDone;
        const uint32_t height = heights_[frame.function.index] + 1;
        open.pop_back();
        if (!open.empty()) {
          uint32_t& above = heights_[open.back().function.index];
          above = std::max(above, height);
        }
        continue;
      }
      const CallSite& site = sites[frame.next++];
      if (states_[site.callee.index] == State::kOpen) {
        ReportCycle(open, site);
      } else if (states_[site.callee.index] == State::kNew) {
        states_[site.callee.index] = State::kOpen;
        open.push_back({site.callee});
      } else {
        uint32_t& above = heights_[frame.function.index];
        above = std::max(above, heights_[site.callee.index] + 1);
      }
    }
  }

  void ReportCycle(const std::vector<Frame>& open, const CallSite& site) {
    cyclic_ = true;
    std::string chain;
    bool inside = false;
    for (const Frame& frame : open) {
      inside = inside || frame.function == site.callee;
      if (inside) chain += unit_.functions[frame.function].name + " -> ";
    }
    context_.diagnostics.Report(site.range, diag::HncRecursive, chain + unit_.functions[site.callee].name);
  }

  void ReportDepth(FunctionId id) {
    std::string chain = unit_.functions[id].name;
    for (uint32_t depth = 0;; ++depth) {
      const CallSite* deepest = nullptr;
      for (const CallSite& site : sites_[id.index]) {
        if (deepest == nullptr || heights_[site.callee.index] > heights_[deepest->callee.index]) deepest = &site;
      }
      if (deepest == nullptr) return;
      if (depth == kMostDepth) {
        context_.diagnostics.Report(deepest->range, diag::HncCallDepth, chain);
        return;
      }
      id = deepest->callee;
      if (depth < 2 || depth + 2 >= kMostDepth) {
        chain += " -> " + unit_.functions[id].name;
      } else if (depth == 2) {
        chain += " -> ...";
      }
    }
  }

  const CheckContext& context_;
  const Unit& unit_;
  std::vector<std::vector<CallSite>> sites_;  // by FunctionId
  std::vector<State> states_;
  std::vector<uint32_t> heights_;  // calls below
  bool cyclic_ = false;
};

std::string_view PartName(uint8_t parts) {
  if ((parts & kPartFast) != 0) return "plc1() or a handler";
  return "plc2()";
}

void CheckRegistrations(const CheckContext& context) {
  const Unit& unit = context.unit;
  for (const FunctionId id : unit.definitions) {
    for (const ExprId part : context.facts.effects().Of(id)) {
      const Expr& expr = unit.expressions[part];
      if (expr.kind != ExprKind::kCall || !expr.function.valid() || expr.arguments.size() != 3) continue;
      if (unit.functions[expr.function].system != SystemFunction::kSetMstFunc) continue;
      const auto poison = std::ranges::any_of(
          expr.arguments, [&](ExprId a) { return !a.valid() || unit.expressions[a].kind == ExprKind::kPoison; });
      if (poison) continue;
      const uint8_t others = context.facts.PartsOf(id) & static_cast<uint8_t>(~kPartInit);
      if (others != 0) context.diagnostics.Report(expr.range, diag::HncSetMstFuncPlace, PartName(others));
      const Expr& channel = unit.expressions[expr.arguments[0]];
      const Expr& kind = unit.expressions[expr.arguments[1]];
      if (!channel.constant || channel.constant->integer < 0 || channel.constant->integer > 3) {
        context.diagnostics.Report(expr.range, diag::HncSetMstFunc, "the channel is no constant from 0 to 3");
        continue;
      }
      const bool letter = kind.constant && kind.constant->integer > 0 && kind.constant->integer < 128 &&
                          kHandlerKinds.find(static_cast<char>(kind.constant->integer)) != std::string_view::npos;
      if (!letter) {
        context.diagnostics.Report(expr.range, diag::HncSetMstFunc, "the kind is none of 'M', 'S', 'T', 'B', 'E'");
        continue;
      }
      const auto found = std::ranges::find(context.facts.registrations(), part, &Registration::call);
      if (found == context.facts.registrations().end()) {
        context.diagnostics.Report(expr.range, diag::HncSetMstFunc, "the handler is no name of a function and not 0");
        continue;
      }
      if (!found->function.valid()) continue;
      const Function& handler = unit.functions[found->function];
      const bool is_void = unit.types[handler.result].kind == TypeKind::kVoid;
      bool takes_int = handler.parameter_types.size() == 1;
      if (takes_int) {
        const Type& type = unit.types[handler.parameter_types[0]];
        takes_int = type.kind == TypeKind::kInteger && type.bits == 16 && type.is_signed;
      }
      if (!is_void || !takes_int || !handler.is_defined) {
        context.diagnostics.Report(expr.range, diag::HncSetMstFunc,
                                   "'" + handler.name + "' is not defined as void " + handler.name + "(int)");
      }
    }
  }
}

/// Handlers of one channel and kind that are chosen at run time.
void CheckNumberOfHandlers(const CheckContext& context) {
  if (context.diagnostics.HasErrors() || context.facts.registrations().size() <= kMostHandlers) return;
  const FixedHandlers fixed = FindFixedHandlers(context.unit, context.facts);
  std::array<std::array<std::set<FunctionId>, kHandlerKinds.size()>, 4> handlers;
  for (const Registration& registration : context.facts.registrations()) {
    if (!registration.function.valid() || fixed[registration.channel][registration.kind]) continue;
    std::set<FunctionId>& known = handlers[registration.channel][registration.kind];
    if (!known.insert(registration.function).second || known.size() != kMostHandlers + 1) continue;
    context.diagnostics.Report(context.unit.expressions[registration.call].range, diag::HncSetMstFunc,
                               std::string("more than ") + std::to_string(kMostHandlers) + " handlers for '" +
                                   kHandlerKinds[registration.kind] + "' of channel " +
                                   std::to_string(registration.channel) + "; register one that chooses what it calls");
  }
}

}  // namespace

void CheckCalls(const CheckContext& context) {
  CallGraph(context).Run();
  CheckRegistrations(context);
  CheckNumberOfHandlers(context);
}

}  // namespace plcxx::hnc
