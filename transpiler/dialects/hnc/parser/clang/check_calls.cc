// Calls, once all definitions are known (specification 6.4, 6.11): what exists, what is refused by name, and whether
// arguments fit where no prototype stood in front of the call.
#include <algorithm>

#include "transpiler/dialects/hnc/machine/headers.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/converter.h"
#include "transpiler/support/near_words.h"

namespace plcxx::hnc {
namespace {

std::string FirstHeader(const FunctionRow& row) { return std::string(row.headers.substr(0, row.headers.find(' '))); }

}  // namespace

void Converter::CheckCalls() {
  for (const Call& call : calls_) {
    const clang::FunctionDecl* definition = call.function->getDefinition();
    if (definition != nullptr) {
      const FunctionId id = FunctionOf(definition);
      if (!call.had_prototype || !unit_.functions[id].has_prototype) CheckArguments(call, definition);
      continue;
    }
    const FunctionId id = FunctionOf(call.function);
    if (unit_.functions[id].system) {
      const clang::FunctionDecl* expected = Expected(call.function);
      if (!call.had_prototype && expected != nullptr) CheckArguments(call, expected);
      continue;
    }
    if (!ReportRefused(call)) ReportUndefined(call);
    if (call.expr.valid()) unit_.expressions[call.expr].kind = ExprKind::kPoison;
  }
}

bool Converter::ReportRefused(const Call& call) {
  const std::string name = call.function->getNameAsString();
  const std::optional<RefusedKind> kind = RefusedFunction(name);
  if (!kind) return false;
  switch (*kind) {
    case RefusedKind::kMemory:
      findings().Report(call.range, diag::HncDynamicMemory, name);
      return true;
    case RefusedKind::kInputOutput:
      findings().Report(call.range, diag::HncInputOutput, name);
      return true;
    case RefusedKind::kHardware:
      findings().Report(call.range, diag::HncHardware, name);
      return true;
    case RefusedKind::kNonLocalJump:
      findings().Report(call.range, diag::HncNonLocalJump, name);
      return true;
    case RefusedKind::kTime:
      findings().Report(call.range, diag::HncTime, name);
      return true;
    case RefusedKind::kVariableArgument:
      findings().Report(call.range, diag::HncVariableArgument, "'" + name + "'");
      return true;
    case RefusedKind::kLibrary:
      findings().Report(call.range, diag::HncLibrary, name);
      return true;
  }
  return true;
}

/// A function of the program or the control whose name is most like this one; empty: none is.
std::string Converter::NearFunction(const std::string& name) const {
  std::vector<std::string_view> words;
  for (const Function& function : unit_.functions) {
    if (function.body.valid()) words.push_back(function.name);
  }
  for (const FunctionRow& row : SystemFunctions()) words.push_back(row.name);
  return std::string(support::NearestWord(name, words));
}

void Converter::ReportUndefined(const Call& call) {
  const std::string name = call.function->getNameAsString();
  if (call.function->isVariadic() && call.function->getType()->isFunctionProtoType()) {
    findings().Report(call.range, diag::HncVariableArgument, "'" + name + "'");
    return;
  }
  if (bodies_.contains(name)) return;  // its definition has been refused
  if (!undefined_.insert(name).second) return;
  if (const FunctionRow* row = FindSystemFunction(name)) {
    findings().Report(call.range, diag::HncUndefinedFunctionHeader, name, FirstHeader(*row));
  } else {
    const std::string near = NearFunction(name);
    if (near.empty()) {
      findings().Report(call.range, diag::HncUndefinedFunction, name);
    } else {
      findings().Report(call.range, diag::HncUndefinedFunctionNear, name, near);
    }
  }
}

/// Without a prototype arguments come promoted, and nothing converts them: they must have the promoted parameter's
/// width and kind. What a parameter keeps of its argument (a char the low byte) is a conversion of the tree.
void Converter::CheckArguments(const Call& call, const clang::FunctionDecl* definition) {
  if (!call.expr.valid()) return;
  const std::string shown = call.function->getNameAsString();
  std::vector<ExprId> arguments = unit_.expressions[call.expr].arguments;
  const size_t count = definition->getNumParams();
  if (arguments.size() != count) {
    findings().Report(call.range, diag::HncArgumentCount, shown, static_cast<int64_t>(count),
                      static_cast<int64_t>(arguments.size()));
    return;
  }
  for (unsigned i = 0; i < count; ++i) {
    const clang::QualType parameter = definition->getParamDecl(i)->getType();
    clang::QualType promoted = parameter;
    if (parameter->isIntegralOrEnumerationType() && context_.getTypeSize(parameter) < 16) promoted = context_.IntTy;
    if (parameter->isSpecificBuiltinType(clang::BuiltinType::Float)) promoted = context_.DoubleTy;
    const TypeId wanted = TypeOf(promoted);
    // What the program writes: Clang converts for an old-style definition that it has seen, the original does not.
    ExprId written = arguments[i];
    while (unit_.expressions[written].kind == ExprKind::kConvert && unit_.expressions[written].is_implicit) {
      written = unit_.expressions[written].a;
    }
    TypeId found = unit_.expressions[written].type;
    if (unit_.types[found].kind == TypeKind::kInteger && unit_.types[found].bits == 8) found = Integer(16, true);
    if (unit_.types[found].kind == TypeKind::kReal) found = TypeOf(context_.DoubleTy);
    const Type& want = unit_.types[wanted];
    const Type& have = unit_.types[found];
    const bool both_integers = want.kind == TypeKind::kInteger && have.kind == TypeKind::kInteger;
    const bool null = want.kind == TypeKind::kPointer && unit_.expressions[arguments[i]].constant &&
                      unit_.expressions[arguments[i]].constant->integer == 0;
    const bool fits = wanted == found || (both_integers && want.bits == have.bits) || null;
    if (unit_.expressions[arguments[i]].kind == ExprKind::kPoison) continue;
    if (!fits) {
      findings().Report(unit_.expressions[arguments[i]].range, diag::HncArgumentType, static_cast<int64_t>(i) + 1,
                        shown, have.text, want.text);
      continue;
    }
    const TypeId kept = TypeOf(parameter);
    if (kept == unit_.expressions[arguments[i]].type) continue;
    Expr conversion;
    conversion.kind = null ? ExprKind::kNull : ExprKind::kConvert;
    conversion.is_implicit = true;
    conversion.type = kept;
    conversion.range = unit_.expressions[arguments[i]].range;
    conversion.a = arguments[i];
    if (null) conversion.a = {};
    arguments[i] = Add(std::move(conversion));
  }
  unit_.expressions[call.expr].arguments = std::move(arguments);
}

void Converter::CheckEntries() {
  const bool syntax = std::ranges::any_of(findings().all(), [](const Finding& finding) {
    return finding.phase != Phase::kMeaning && finding.row.severity == diag::Severity::kError;
  });
  if (syntax || session_.stopped) return;  // it may stand in what was not understood
  const auto check = [&](FunctionId entry, const char* name) {
    if (!entry.valid()) findings().Report(unit_.last_token, diag::HncMissingEntry, name);
  };
  check(unit_.init, "init");
  check(unit_.plc1, "plc1");
  check(unit_.plc2, "plc2");
}

}  // namespace plcxx::hnc
