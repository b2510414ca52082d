// Warnings about names: W1 unused, W5 written in two parts, W6 inputs written, W19 periods, W20 handlers, W21 hidden
// names (specification 10.3).

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <tuple>

#include "transpiler/dialects/hnc/analysis/checks.h"
#include "transpiler/dialects/hnc/analysis/stores.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/support/near_words.h"

namespace plcxx::hnc {
namespace {

/// How the program uses its variables.
struct Usage {
  std::vector<bool> read, written;  // by VariableId
};

Usage FindUsage(const CheckContext& context) {
  const Unit& unit = context.unit;
  Usage usage{std::vector<bool>(unit.variables.size()), std::vector<bool>(unit.variables.size())};
  std::vector<uint32_t> parent(unit.expressions.size(), ExprId::kNone), names;
  for (uint32_t i = 0; i < unit.expressions.size(); ++i) {
    const Expr& expr = unit.expressions[ExprId(i)];
    if (expr.kind == ExprKind::kVariable) names.push_back(i);
    for (const ExprId child : {expr.a, expr.b, expr.c}) {
      if (child.valid()) parent[child.index] = i;
    }
    for (const ExprId child : expr.arguments) {
      if (child.valid()) parent[child.index] = i;
    }
  }
  std::vector<bool> is_statement(unit.expressions.size());  // whose value nobody takes
  for (const Statement& statement : unit.statements) {
    if (statement.kind == StatementKind::kExpression && statement.expression.valid()) {
      is_statement[statement.expression.index] = true;
    }
    if (statement.step.valid()) is_statement[statement.step.index] = true;
    if (statement.first.valid()) is_statement[statement.first.index] = true;
  }
  for (const uint32_t i : names) {
    const uint32_t variable = unit.expressions[ExprId(i)].variable.index;
    uint32_t at = i, up = parent[i];
    // Through members and elements to what is done with them.
    while (up != ExprId::kNone) {
      const Expr& outer = unit.expressions[ExprId(up)];
      const bool through = (outer.kind == ExprKind::kMember || outer.kind == ExprKind::kIndex) && outer.a.index == at;
      if (!through) break;
      at = up;
      up = parent[up];
    }
    if (up == ExprId::kNone) {
      usage.read[variable] = true;
      continue;
    }
    const Expr& user = unit.expressions[ExprId(up)];
    if (IsStore(user) && user.a.index == at) {
      usage.written[variable] = true;
      if (user.kind != ExprKind::kAssign && !is_statement[up]) usage.read[variable] = true;
      if (user.kind == ExprKind::kAssign && !is_statement[up] && parent[up] != ExprId::kNone) {
        usage.read[variable] = true;
      }
      continue;
    }
    usage.read[variable] = true;
    if (user.kind == ExprKind::kAddress || user.kind == ExprKind::kDecay) usage.written[variable] = true;
  }
  return usage;
}

/// "case 1" for case1, "default" for defualt: what a label was to be in a switch; empty when it is like neither.
std::string CaseMeant(std::string_view label) {
  constexpr std::string_view kCase = "case", kWords[] = {"default"};
  if (label.size() > kCase.size() && label.starts_with(kCase))
    return std::string(kCase) + " " + std::string(label.substr(kCase.size()));
  return std::string(support::NearestName(label, kWords));
}

void WarnOfUnused(const CheckContext& context) {
  const Unit& unit = context.unit;
  if (unit.faulty) return;  // its use may be in what was not understood
  const Usage usage = FindUsage(context);
  // The dispatcher hands a handler its channel, wanted or not.
  std::set<FunctionId> handlers;
  for (const Registration& registration : context.facts.registrations()) handlers.insert(registration.function);
  for (uint32_t i = 0; i < unit.variables.size(); ++i) {
    const Variable& variable = unit.variables[VariableId(i)];
    const bool parameter = variable.storage == Storage::kParameter;
    const bool own = variable.storage == Storage::kGlobal || variable.storage == Storage::kStaticLocal ||
                     variable.storage == Storage::kAutomatic || parameter;
    if (!own || variable.name.empty()) continue;
    if (variable.function.valid() && !unit.functions[variable.function].is_defined) continue;
    const bool assigned = usage.written[i] || variable.initialised || parameter;
    if (!usage.read[i] && !usage.written[i]) {
      if (parameter && handlers.contains(variable.function)) continue;
      context.diagnostics.Report(variable.range, diag::HncUnused, parameter ? "parameter" : "variable", variable.name);
    } else if (!usage.read[i]) {
      context.diagnostics.Report(variable.range, diag::HncNeverUsed, variable.name);
    } else if (!assigned && variable.storage != Storage::kAutomatic) {
      context.diagnostics.Report(variable.range, diag::HncNeverAssigned, variable.name);
    }
  }
  for (const FunctionId id : unit.definitions) {
    const Function& function = unit.functions[id];
    if (context.facts.PartsOf(id) == 0 && unit.init.valid() && unit.plc1.valid() && unit.plc2.valid()) {
      context.diagnostics.Report(function.range, diag::HncUnused, "function", function.name);
    }
  }
  for (const Label& label : unit.labels) {
    if (label.used) continue;
    if (const std::string meant = CaseMeant(label.name); !meant.empty()) {
      context.diagnostics.Report(label.range, diag::HncUnusedLabelMeant, label.name, meant);
    } else {
      context.diagnostics.Report(label.range, diag::HncUnused, "label", label.name);
    }
  }
}

std::string TextOf(const CheckContext& context, ExprId id) {
  return std::string(context.sources.Text(context.unit.expressions[id].range));
}

/// W5 across the parts, W6.
void WarnOfStores(const CheckContext& context) {
  const Unit& unit = context.unit;
  std::map<std::pair<uint32_t, int64_t>, std::array<uint8_t, 8>> bytes;  // object, byte: parts by bit
  struct Store {
    ExprId expr;
    uint8_t parts;
    ChangedBits changed;
  };
  std::vector<Store> stores;
  for (const FunctionId id : unit.definitions) {
    const uint8_t parts = context.facts.PartsOf(id);
    for (const ExprId part : context.facts.effects().Of(id)) {
      const Expr& expr = unit.expressions[part];
      if (!IsStore(expr) || !unit.expressions[expr.a].type.valid()) continue;
      const ObjectSet objects = context.facts.ObjectsOf(expr.a);
      for (const Area area : {Area::kX, Area::kF, Area::kP}) {
        if (objects.objects.size() != 1 || !objects.Has(context.objects.OfArea(area))) continue;
        context.diagnostics.Report(expr.range, diag::HncInputWritten, TextOf(context, expr.a));
      }
      if ((parts & (kPartFast | kPartSlow)) == 0) continue;
      const std::optional<ChangedBits> changed = ChangedBy(unit, context.facts, expr);
      if (!changed) continue;
      const Object& object = context.objects[changed->object];
      const bool output =
          context.objects.IsArea(changed->object, Area::kY) || context.objects.IsArea(changed->object, Area::kG);
      bool shared = output;
      if (object.kind == ObjectKind::kVariable) {
        const Storage storage = unit.variables[VariableId(object.index)].storage;
        shared = storage == Storage::kGlobal || storage == Storage::kStaticLocal;
      }
      if (shared) stores.push_back({part, parts, *changed});
    }
  }
  std::ranges::stable_sort(stores, {}, [&](const Store& store) { return unit.expressions[store.expr].range.begin; });
  std::set<std::tuple<uint32_t, int64_t>> reported;
  for (const Store& store : stores) {
    std::array<uint8_t, 8>* byte = nullptr;
    for (uint32_t bit = 0; bit < 8 * store.changed.size; ++bit) {
      if (bit % 8 == 0) byte = nullptr;
      if ((store.changed.mask >> bit & 1) == 0) continue;
      if (byte == nullptr) byte = &bytes[{store.changed.object.index, store.changed.offset + bit / 8}];
      uint8_t& parts = (*byte)[bit % 8];
      const uint8_t before = parts;
      parts = static_cast<uint8_t>(before | (store.parts & (kPartFast | kPartSlow)));
      const bool now_both = parts == (kPartFast | kPartSlow) && before != parts;
      if (!now_both || !reported.insert({store.changed.object.index, store.changed.offset}).second) continue;
      const Expr& expr = unit.expressions[store.expr];
      context.diagnostics.Report(expr.range, diag::HncWrittenInTwoParts, TextOf(context, expr.a));
    }
  }
}

/// W5 in one part: the same bit of Y twice, both times whatever happens.
void WarnOfSecondStores(const CheckContext& context) {
  const Unit& unit = context.unit;
  for (const FunctionId id : {unit.plc1, unit.plc2}) {
    if (!id.valid()) continue;
    std::set<std::pair<int64_t, uint32_t>> seen;
    for (const StatementId statement_id : unit.statements[unit.functions[id].body].body) {
      const Statement& statement = unit.statements[statement_id];
      if (statement.kind != StatementKind::kExpression || !statement.expression.valid()) continue;
      const Expr& expr = unit.expressions[statement.expression];
      if (!IsStore(expr) || !unit.expressions[expr.a].type.valid()) continue;
      const std::optional<ChangedBits> changed = ChangedBy(unit, context.facts, expr);
      if (!changed || !context.objects.IsArea(changed->object, Area::kY)) continue;
      bool twice = false;
      for (uint32_t bit = 0; bit < 8 * changed->size; ++bit) {
        if ((changed->mask >> bit & 1) == 0) continue;
        twice = !seen.insert({changed->offset + bit / 8, bit % 8}).second || twice;
      }
      if (twice) context.diagnostics.Report(expr.range, diag::HncWrittenTwice, TextOf(context, expr.a));
    }
  }
}

void WarnOfPeriods(const CheckContext& context) {
  const Unit& unit = context.unit;
  if (unit.faulty) return;  // it may be set where something was not understood
  for (const bool fast : {true, false}) {
    const FunctionId entry = fast ? unit.plc1 : unit.plc2;
    if (!entry.valid()) continue;
    bool set = false;
    for (uint32_t i = 0; i < unit.variables.size(); ++i) {
      const Variable& variable = unit.variables[VariableId(i)];
      if (variable.storage != (fast ? Storage::kPlc1Time : Storage::kPlc2Time)) continue;
      set = set || variable.initialised;
      const ObjectId object = context.objects.OfVariable(VariableId(i));
      for (const FunctionId id : unit.definitions) {
        if (context.facts.PartsOf(id) != 0 && context.facts.WritesOf(id).Has(object)) set = true;
      }
    }
    if (!set) {
      context.diagnostics.Report(unit.functions[entry].range, diag::HncPeriodNeverSet,
                                 fast ? "plc1_time" : "plc2_time");
    }
  }
}

void WarnOfHandlers(const CheckContext& context) {
  const Unit& unit = context.unit;
  constexpr std::string_view kNames[] = {"mod_M_code", "mod_S_code", "mod_T_code", "mod_B_code"};
  std::set<std::pair<int64_t, bool>> completed;
  for (const FunctionId id : unit.definitions) {
    if ((context.facts.PartsOf(id) & (kPartFast | kPartSlow)) == 0) continue;
    for (const ExprId part : context.facts.effects().Of(id)) {
      const Expr& expr = unit.expressions[part];
      if (expr.kind != ExprKind::kAssign || !unit.expressions[expr.b].constant) continue;
      const int64_t value = unit.expressions[expr.b].constant->integer;
      if (value != -1 && value != 0xFFFF) continue;
      if (const std::optional<ModWord> word = WordOfG(unit, context.objects, context.facts, expr.a))
        completed.insert({word->word, word->computed});
    }
  }
  for (const Registration& registration : context.facts.registrations()) {
    if (registration.kind >= 4 || !registration.function.valid()) continue;
    const int64_t word = kFirstModWord + registration.kind;
    const bool done =
        completed.contains({word, true}) || completed.contains({word + kChannelWords * registration.channel, false});
    if (done) continue;
    context.diagnostics.Report(unit.expressions[registration.call].range, diag::HncHandlerNeverCompletes,
                               unit.functions[registration.function].name, kNames[registration.kind]);
  }
}

void WarnOfHiddenNames(const CheckContext& context) {
  for (const Variable& variable : context.unit.variables) {
    const bool local = variable.storage == Storage::kAutomatic || variable.storage == Storage::kParameter ||
                       variable.storage == Storage::kStaticLocal;
    if (!local) continue;
    const bool system = FindSystemName(variable.name) || variable.name == "plc1_time" || variable.name == "plc2_time" ||
                        FindSystemFunction(variable.name) != nullptr;
    if (system) context.diagnostics.Report(variable.range, diag::HncHidesSystemName, variable.name);
  }
}

}  // namespace

void CheckUsage(const CheckContext& context) {
  WarnOfUnused(context);
  WarnOfStores(context);
  WarnOfSecondStores(context);
  WarnOfPeriods(context);
  WarnOfHandlers(context);
  WarnOfHiddenNames(context);
}

}  // namespace plcxx::hnc
