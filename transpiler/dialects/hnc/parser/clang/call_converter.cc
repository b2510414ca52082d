#include "transpiler/dialects/hnc/parser/clang/call_converter.h"

#include <utility>

#include "transpiler/dialects/hnc/machine/headers.h"
#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"
#include "transpiler/dialects/hnc/parser/clang/function_converter.h"
#include "transpiler/support/near_words.h"

namespace plcxx::hnc {
namespace {

std::string FirstHeader(const FunctionRow& row) { return std::string(row.headers.substr(0, row.headers.find(' '))); }

}  // namespace

/// The third argument of set_mst_func: the name of a function, or 0.
ExprId CallConverter::Handler(const clang::Expr* argument) {
  const clang::Expr* inner = argument->IgnoreParenCasts();
  if (const auto* address = llvm::dyn_cast<clang::UnaryOperator>(inner)) {
    if (address->getOpcode() == clang::UO_AddrOf) inner = address->getSubExpr()->IgnoreParenCasts();
  }
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(inner);
  const auto* function = name == nullptr ? nullptr : llvm::dyn_cast<clang::FunctionDecl>(name->getDecl());
  Expr result = builder_.Start(ExprKind::kFunction, argument);
  if (function != nullptr) {
    result.function = functions_.FunctionOf(function);
    list_.push_back({{}, function, true, RangeOf(argument), now_.recorder.index()});
    return unit_.expressions.Add(std::move(result));
  }
  if (argument->isNullPointerConstant(context_, clang::Expr::NPC_NeverValueDependent) != clang::Expr::NPCK_NotNull) {
    result.kind = ExprKind::kNull;
    result.constant = Constant{};
    return unit_.expressions.Add(std::move(result));
  }
  findings().Report(RangeOf(argument), diag::HncSetMstFunc, "the third argument is neither a function nor 0");
  return builder_.Poison(argument);
}

/// Arguments are evaluated from right to left (6.2). Clang, which is made to do so, copies a structure that is named as
/// one when all are, so that it sees what those before it write.
bool CallConverter::CopiesTooLate(const clang::CallExpr* expr) const {
  bool writes = false;
  for (unsigned i = 0; i < expr->getNumArgs(); ++i) {
    const clang::Expr* argument = expr->getArg(i);
    const auto* read = llvm::dyn_cast<clang::ImplicitCastExpr>(argument->IgnoreParens());
    const bool is_named = read != nullptr && read->getCastKind() == clang::CK_LValueToRValue;
    if (writes && is_named && argument->getType()->isRecordType()) return true;
    writes = writes || argument->HasSideEffects(context_);
  }
  return false;
}

ExprId CallConverter::CallOf(const clang::CallExpr* expr) {
  const auto* decay = llvm::dyn_cast<clang::ImplicitCastExpr>(expr->getCallee()->IgnoreParens());
  const auto* name =
      decay == nullptr ? nullptr : llvm::dyn_cast<clang::DeclRefExpr>(decay->getSubExpr()->IgnoreParens());
  const auto* function = name == nullptr ? nullptr : llvm::dyn_cast<clang::FunctionDecl>(name->getDecl());
  if (function == nullptr) {
    // A pointer to functions has been refused where it is declared.
    const clang::Expr* called = expr->getCallee()->IgnoreParenImpCasts();
    if (const auto* target = llvm::dyn_cast<clang::UnaryOperator>(called))
      called = target->getSubExpr()->IgnoreParenImpCasts();
    if (llvm::isa<clang::DeclRefExpr>(called) || llvm::isa<clang::MemberExpr>(called)) return builder_.Poison(expr);
    findings().Report(RangeOf(expr->getCallee()), diag::HncFunctionPointer,
                      "'" + Written(RangeOf(expr->getCallee())) + "' is called");
    return builder_.Poison(expr);
  }
  const bool registers = function->getName() == "set_mst_func" && function->getDefinition() == nullptr;
  Expr result = builder_.Start(ExprKind::kCall, expr);
  result.is_lvalue = false;
  result.function = functions_.FunctionOf(function);
  result.op = session_.places.OfToken(expr->getCallee()->getBeginLoc());
  bool poison = false;
  for (unsigned i = 0; i < expr->getNumArgs(); ++i) {
    constexpr unsigned kHandler = 2;
    const ExprId argument =
        registers && i == kHandler ? Handler(expr->getArg(i)) : expressions_.Convert(expr->getArg(i));
    poison = poison || IsPoison(argument);
    result.arguments.push_back(argument);
  }
  if (CopiesTooLate(expr))
    NoteThatClangDiffers("a structure is copied for a call after what stands before it is evaluated, and not before");
  const source::Range range = result.op;
  if (poison) result.kind = ExprKind::kPoison;
  const ExprId id = unit_.expressions.Add(std::move(result));
  // The type of the name is that at this place: a prototype after it does not convert arguments.
  list_.push_back({poison ? ExprId() : id, function, decay->getSubExpr()->getType()->isFunctionProtoType(), range,
                   now_.recorder.index()});
  return id;
}

void CallConverter::CheckCalls() {
  for (const Call& call : list_) {
    const clang::FunctionDecl* definition = call.function->getDefinition();
    if (definition != nullptr) {
      const FunctionId id = functions_.FunctionOf(definition);
      if (call.had_prototype && unit_.functions[id].has_prototype) continue;
      if (definition->getNumParams() > 0) RefuseBodyOf(call);
      CheckArguments(call, definition);
      continue;
    }
    const FunctionId id = functions_.FunctionOf(call.function);
    if (unit_.functions[id].system) {
      const auto* expected = Expected<clang::FunctionDecl>(call.function->getNameAsString());
      if (call.had_prototype || expected == nullptr) continue;
      if (expected->getNumParams() > 0) RefuseBodyOf(call);
      CheckArguments(call, expected);
      continue;
    }
    RefuseBodyOf(call);
    if (!ReportRefused(call)) ReportUndefined(call);
    if (call.expr.valid()) unit_.expressions[call.expr].kind = ExprKind::kPoison;
  }
}

void CallConverter::RefuseBodyOf(const Call& call) {
  if (call.body < session_.output.bodies.size()) session_.output.bodies[call.body].is_reusable = false;
}

bool CallConverter::ReportRefused(const Call& call) {
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
std::string CallConverter::NearFunction(const std::string& name) const {
  std::vector<std::string_view> words;
  for (const Function& function : unit_.functions) {
    if (function.body.valid()) words.push_back(function.name);
  }
  for (const FunctionRow& row : SystemFunctions()) words.push_back(row.name);
  return std::string(support::NearestWord(name, words));
}

void CallConverter::ReportUndefined(const Call& call) {
  const std::string name = call.function->getNameAsString();
  if (call.function->isVariadic() && call.function->getType()->isFunctionProtoType()) {
    findings().Report(call.range, diag::HncVariableArgument, "'" + name + "'");
    return;
  }
  if (now_.bodies.contains(name)) return;  // its definition has been refused
  if (!now_.undefined.insert(name).second) return;
  if (const FunctionRow* row = FindSystemFunction(name)) {
    findings().Report(call.range, diag::HncUndefinedFunctionHeader, name, FirstHeader(*row));
  } else if (name == "max" || name == "min") {  // macros
    findings().Report(call.range, diag::HncUndefinedFunctionHeader, name, "stdlib.h");
  } else {
    const std::string near = NearFunction(name);
    if (near.empty()) {
      findings().Report(call.range, diag::HncUndefinedFunction, name);
    } else {
      findings().Report(call.range, diag::HncUndefinedFunctionNear, name, near);
    }
  }
}

void CallConverter::CheckArguments(const Call& call, const clang::FunctionDecl* definition) {
  if (!call.expr.valid()) return;
  support::RareList<ExprId> arguments = unit_.expressions[call.expr].arguments;
  const size_t count = definition->getNumParams();
  if (arguments.size() != count) {
    findings().Report(call.range, diag::HncArgumentCount, call.function->getNameAsString(), static_cast<int64_t>(count),
                      static_cast<int64_t>(arguments.size()));
    return;
  }
  for (unsigned i = 0; i < count; ++i) CheckArgument(call, i, definition->getParamDecl(i)->getType(), arguments[i]);
  unit_.expressions[call.expr].arguments = std::move(arguments);
}

/// Without a prototype arguments come promoted, and nothing converts them: they must have the promoted parameter's
/// width and kind. What a parameter keeps of its argument (a char the low byte) is a conversion of the tree.
void CallConverter::CheckArgument(const Call& call, unsigned number, clang::QualType parameter, ExprId& argument) {
  clang::QualType promoted = parameter;
  if (parameter->isIntegralOrEnumerationType() && context_.getTypeSize(parameter) < 16) promoted = context_.IntTy;
  if (parameter->isSpecificBuiltinType(clang::BuiltinType::Float)) promoted = context_.DoubleTy;
  const TypeId wanted = types_.TypeOf(promoted);
  // What the program writes: Clang converts for an old-style definition that it has seen, the original does not.
  ExprId written = argument;
  while (unit_.expressions[written].kind == ExprKind::kConvert && unit_.expressions[written].is_implicit) {
    written = unit_.expressions[written].a;
  }
  TypeId found = unit_.expressions[written].type;
  if (unit_.types[found].kind == TypeKind::kInteger && unit_.types[found].bits == 8) found = types_.Integer(16, true);
  if (unit_.types[found].kind == TypeKind::kReal) found = types_.TypeOf(context_.DoubleTy);
  const Type& want = unit_.types[wanted];
  const Type& have = unit_.types[found];
  const bool both_integers = want.kind == TypeKind::kInteger && have.kind == TypeKind::kInteger;
  const bool null = want.kind == TypeKind::kPointer && unit_.expressions[argument].constant &&
                    unit_.expressions[argument].constant->integer == 0;
  const bool fits = wanted == found || (both_integers && want.bits == have.bits) || null;
  if (IsPoison(argument)) return;
  if (!fits) {
    findings().Report(unit_.expressions[argument].range, diag::HncArgumentType, static_cast<int64_t>(number) + 1,
                      call.function->getNameAsString(), have.text, want.text);
    return;
  }
  const TypeId kept = types_.TypeOf(parameter);
  if (kept == unit_.expressions[argument].type) return;
  Expr conversion;
  conversion.kind = null ? ExprKind::kNull : ExprKind::kConvert;
  conversion.is_implicit = true;
  conversion.type = kept;
  conversion.range = unit_.expressions[argument].range;
  if (!null) conversion.a = argument;
  argument = builder_.Add(std::move(conversion));
}

}  // namespace plcxx::hnc
