#include "transpiler/dialects/hnc/parser/clang/function_converter.h"

#include <clang/AST/TypeLoc.h>

#include <algorithm>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/body_keeper.h"
#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

namespace plcxx::hnc {
namespace {

bool IsEntry(std::string_view name) { return name == "init" || name == "plc1" || name == "plc2"; }

/// Some declaration that the program or a header writes: a call alone declares nothing that the product would supply.
bool IsWritten(const clang::FunctionDecl* function) {
  return std::ranges::any_of(function->redecls(), [](const clang::FunctionDecl* d) { return !d->isImplicit(); });
}

}  // namespace

FunctionId FunctionConverter::FunctionOf(const clang::FunctionDecl* function) {
  const clang::FunctionDecl* key = function->getCanonicalDecl();
  const auto known = functions_.find(key);
  if (known != functions_.end()) {
    Note(function, known->second);
    return known->second.id;
  }
  const clang::FunctionDecl* definition = function->getDefinition();
  const clang::FunctionDecl* described = definition != nullptr ? definition : function->getMostRecentDecl();
  Function result;
  result.name = function->getNameAsString();
  result.is_defined = definition != nullptr;
  result.is_static = function->getFormalLinkage() == clang::Linkage::Internal;
  if (definition == nullptr && IsWritten(function)) {
    if (const FunctionRow* row = FindSystemFunction(result.name)) {
      result.system = row->function;
      if (const auto* expected = Expected<clang::FunctionDecl>(function->getNameAsString())) {
        // abs keeps the type of its argument where an option says so: then it has two declarations.
        if (!described->hasAttrs()) described = expected;
      }
      const bool takes_long =
          described->getNumParams() == 1 && context_.getTypeSize(described->getParamDecl(0)->getType()) == 32;
      if (row->function == SystemFunction::kAbs && takes_long) result.system = SystemFunction::kLabs;
    }
  }
  result.result = types_.TypeOf(described->getReturnType());
  result.has_prototype = described->hasWrittenPrototype();
  for (const clang::ParmVarDecl* parameter : described->parameters()) {
    result.parameter_types.push_back(types_.TypeOf(parameter->getType()));
  }
  result.range = NameOf(described);
  if (InProduct(described)) result.range = {};
  const FunctionId id = unit_.functions.Add(std::move(result));
  Note(function, functions_.emplace(key, Known{.id = id}).first->second);
  return id;
}

/// A function that only a body declares is not at file level.
void FunctionConverter::Note(const clang::FunctionDecl* function, Known& known) {
  BodyRecorder& recorder = now_.recorder;
  if (!recorder.is_recording() || known.noted == recorder.serial()) return;
  known.noted = recorder.serial();
  recorder.Add(NeedKind::kFunction, known.id.index);
  const auto named = recorder.names.functions.find(function->getIdentifier());
  const bool is_found = named != recorder.names.functions.end() && named->second == function->getCanonicalDecl();
  const bool is_open = function->isImplicit() || !function->getLexicalDeclContext()->isTranslationUnit();
  if (!is_found || is_open) recorder.Refuse();
}

void FunctionConverter::CheckFunction(const clang::FunctionDecl* function) {
  const std::string name = function->getNameAsString();
  const bool body = function->doesThisDeclarationHaveABody();
  if (FindSystemName(name) || name == "plc1_time" || name == "plc2_time") {
    findings().Report(NameOf(function), diag::HncRedefinitionSystem, name);
  }
  if (name != "set_mst_func") {
    checker_.CheckDeclaredType(function->getReturnType(), Holder::kResult, name, NameOf(function));
    for (const clang::ParmVarDecl* parameter : function->parameters()) {
      if (body) break;  // as variables
      const std::string text = parameter->getName().empty() ? name : parameter->getNameAsString();
      checker_.CheckDeclaredType(parameter->getType(), Holder::kParameter, text, NameOf(parameter));
    }
  }
  if (body && function->isVariadic() && function->getType()->isFunctionProtoType()) {
    const source::Range dots = session_.places.OfToken(function->getEllipsisLoc());
    findings().Report(dots.begin == 0 ? NameOf(function) : dots, diag::HncVariableArgument, "'" + name + "'");
  }
  // A definition takes the place of the product's function, if it has the same type; headers compare it themselves.
  const auto* expected = Expected<clang::FunctionDecl>(function->getNameAsString());
  const FunctionRow* row = FindSystemFunction(name);
  if (expected == nullptr || row == nullptr) return;
  // Without its header a name of the library is a name like others (6.11).
  if (function->getDefinition() != nullptr && !IsDeclaredBy(*row, "plc.h")) return;
  if (body || function->getType()->isFunctionProtoType()) {
    const bool fits = context_.typesAreCompatible(function->getType(), expected->getType());
    const bool mst = name == "set_mst_func";
    const bool declared_before = function->getPreviousDecl() != nullptr && InProduct(function->getPreviousDecl());
    if (!fits && !declared_before && !(mst && !body)) {
      findings().Report(NameOf(function), diag::HncConflictingTypes, name);
    }
  }
}

void FunctionConverter::CheckEntry(const clang::FunctionDecl* function) {
  const std::string name = function->getNameAsString();
  if (name == "main") findings().Report(NameOf(function), diag::HncMain);
  if (!IsEntry(name)) return;
  const clang::QualType result = function->getReturnType();
  const bool fits = result->isVoidType() || result->isSpecificBuiltinType(clang::BuiltinType::Int);
  if (function->getNumParams() != 0 || !fits) findings().Report(NameOf(function), diag::HncEntryShape, name);
}

void FunctionConverter::Define(const clang::FunctionDecl* function) {
  CheckEntry(function);
  const FunctionId id = FunctionOf(function);
  unit_.definitions.push_back(id);
  now_.function = id;
  std::vector<VariableId> parameters;
  for (const clang::ParmVarDecl* parameter : function->parameters())
    parameters.push_back(variables_.VariableOf(parameter));
  unit_.functions[id].parameters = std::move(parameters);
  source::Offset head_end = NameOf(function).end;
  if (const clang::FunctionTypeLoc type = function->getFunctionTypeLoc()) {
    head_end = std::max(head_end, session_.places.OfToken(type.getRParenLoc()).end);
  }
  unit_.functions[id].head = {session_.places.Of(function->getBeginLoc()), head_end};
  unit_.functions[id].body = bodies_.BodyOf(function);
  const std::string name = function->getNameAsString();
  if (name == "init") unit_.init = id;
  if (name == "plc1") unit_.plc1 = id;
  if (name == "plc2") unit_.plc2 = id;
  now_.function = {};
}

}  // namespace plcxx::hnc
