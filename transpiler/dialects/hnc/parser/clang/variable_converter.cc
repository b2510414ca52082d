#include "transpiler/dialects/hnc/parser/clang/variable_converter.h"

#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"

namespace plcxx::hnc {
namespace {

bool IsPeriod(std::string_view name) { return name == "plc1_time" || name == "plc2_time"; }
bool IsSystemVariable(std::string_view name) { return IsPeriod(name) || FindSystemName(name).has_value(); }

/// Declared at file level or as extern in a block: one object for the program.
bool IsFileVariable(const clang::VarDecl* variable) {
  return variable->isFileVarDecl() || variable->isLocalExternDecl();
}

/// The declaration that makes the object; null where there is none.
const clang::VarDecl* DefinitionOf(const clang::VarDecl* variable) {
  if (const clang::VarDecl* definition = variable->getDefinition()) return definition;
  const clang::VarDecl* tentative = nullptr;
  for (const clang::VarDecl* declaration : variable->redecls()) {
    const bool is_one = declaration->isThisDeclarationADefinition() != clang::VarDecl::DeclarationOnly;
    const bool first = tentative == nullptr || declaration->getLocation() < tentative->getLocation();
    if (is_one && first) tentative = declaration;
  }
  return tentative;
}

bool HasPointer(const clang::BinaryOperator* expr) {
  return expr->getLHS()->getType()->isPointerType() || expr->getRHS()->getType()->isPointerType();
}

/// What is no constant in an initialiser of static data, though Clang can compute it: values of variables and strings,
/// commas, truths about addresses; null: all of it is constant.
const clang::Expr* FirstNotConstant(const clang::Expr* expr) {
  if (llvm::isa<clang::UnaryExprOrTypeTraitExpr>(expr)) return nullptr;
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr); cast != nullptr) {
    if (cast->getCastKind() == clang::CK_LValueToRValue) return expr;
  }
  if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(expr); unary != nullptr) {
    if (unary->getOpcode() == clang::UO_LNot && unary->getSubExpr()->getType()->isPointerType()) return expr;
  }
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(expr); binary != nullptr) {
    if (binary->isCommaOp()) return expr;
    if (HasPointer(binary) && !binary->getType()->isPointerType()) return expr;
  }
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr); choice != nullptr) {
    if (choice->getCond()->getType()->isPointerType()) return expr;
  }
  for (const clang::Stmt* child : expr->children()) {
    const auto* part = llvm::dyn_cast_or_null<clang::Expr>(child);
    if (const clang::Expr* found = part == nullptr ? nullptr : FirstNotConstant(part)) return found;
  }
  return nullptr;
}

}  // namespace

VariableId VariableConverter::VariableOf(const clang::VarDecl* variable) {
  const clang::VarDecl* key = variable->getCanonicalDecl();
  const auto known = variables_.find(key);
  if (known != variables_.end()) {
    Note(variable, known->second);
    return known->second.id;
  }
  Variable result;
  result.name = variable->getNameAsString();
  const clang::VarDecl* described = variable;
  if (IsFileVariable(variable)) {
    if (const clang::VarDecl* definition = DefinitionOf(variable)) described = definition;
    DescribeFileVariable(described, result);
  } else if (llvm::isa<clang::ParmVarDecl>(variable)) {
    result.storage = Storage::kParameter;
  } else {
    result.storage = variable->isStaticLocal() ? Storage::kStaticLocal : Storage::kAutomatic;
  }
  if (!IsFileVariable(variable)) result.function = now_.function;
  const clang::VarDecl* newest = variable->getMostRecentDecl();
  result.type = types_.TypeOf(IsFileVariable(variable) ? newest->getType() : described->getType());
  result.is_const = context_.getBaseElementType(described->getType()).isConstQualified();
  result.is_register = variable->getStorageClass() == clang::SC_Register;
  result.range = NameOf(described);
  const VariableId id = unit_.variables.Add(std::move(result));
  Note(variable, variables_.emplace(key, Known{.id = id}).first->second);
  const uint32_t expressions = unit_.expressions.size();
  Initialise(described, id);
  // Expressions that are no part of the body, between those that are.
  if (IsFileVariable(variable) && unit_.expressions.size() != expressions) now_.recorder.Refuse();
  return id;
}

void VariableConverter::Note(const clang::VarDecl* variable, Known& known) {
  BodyRecorder& recorder = now_.recorder;
  if (!recorder.is_recording() || known.noted == recorder.serial()) return;
  known.noted = recorder.serial();
  if (llvm::isa<clang::ParmVarDecl>(variable)) return;
  if (!IsFileVariable(variable)) return recorder.Add(NeedKind::kLocal, known.id.index);
  recorder.Add(NeedKind::kFileVariable, known.id.index);
  const auto named = recorder.names.variables.find(variable->getIdentifier());
  const bool is_found = named != recorder.names.variables.end() && named->second == variable->getCanonicalDecl();
  const bool is_open = !variable->getLexicalDeclContext()->isTranslationUnit();
  if (!is_found || is_open || unit_.variables[known.id].storage == Storage::kUndefined) recorder.Refuse();
}

void VariableConverter::DescribeFileVariable(const clang::VarDecl* variable, Variable& result) {
  if (IsPeriod(result.name)) {
    result.storage = result.name == "plc1_time" ? Storage::kPlc1Time : Storage::kPlc2Time;
    return;
  }
  if (const auto system = FindSystemName(result.name)) {
    result.storage = Storage::kSystem;
    const AreaRow& area = RowOf(system->area);
    const auto* declared = Expected<clang::VarDecl>(result.name);
    const clang::ArrayType* array = declared == nullptr ? nullptr : context_.getAsArrayType(declared->getType());
    if (array == nullptr) return;
    clang::QualType element = array->getElementType();
    if (area.table) element = element->getPointeeType();
    SystemView view{.area = system->area, .table = area.table, .element = types_.TypeOf(element), .count = 0};
    constexpr uint32_t kTableBytes = 2;
    view.count = area.bytes / (area.table ? kTableBytes : unit_.types[view.element].size);
    result.view = view;
    return;
  }
  result.is_static = variable->getFormalLinkage() == clang::Linkage::Internal;
  result.storage = DefinitionOf(variable) != nullptr ? Storage::kGlobal : Storage::kUndefined;
}

void VariableConverter::CheckSystemVariable(const clang::VarDecl* variable) {
  const std::string name = variable->getNameAsString();
  if (!IsFileVariable(variable) || !IsSystemVariable(name)) return;
  if (!IsPeriod(name) && variable->isThisDeclarationADefinition() != clang::VarDecl::DeclarationOnly) {
    findings().Report(NameOf(variable), diag::HncRedefinitionSystem, name);
    return;
  }
  const auto* expected = Expected<clang::VarDecl>(name);
  if (expected == nullptr) return;
  bool fits = false;
  const clang::ArrayType* array = context_.getAsArrayType(variable->getType());
  const clang::ArrayType* wanted = context_.getAsArrayType(expected->getType());
  if (wanted == nullptr) {
    fits = context_.hasSameUnqualifiedType(variable->getType(), expected->getType());
  } else if (array != nullptr) {
    fits = context_.hasSameUnqualifiedType(array->getElementType(), wanted->getElementType());
    const VariableId id = VariableOf(variable);
    if (const auto* bounded = llvm::dyn_cast<clang::ConstantArrayType>(array); bounded != nullptr && fits) {
      fits = unit_.variables[id].view && bounded->getSize().getLimitedValue() == unit_.variables[id].view->count;
    }
  }
  if (!fits) {
    findings().Report(NameOf(variable), diag::HncConflictingSystem, name,
                      IsPeriod(name) ? "define it as unsigned " + name + ", or leave it out: plc.h declares it"
                                     : "leave it out: plc.h declares it");
  }
}

void VariableConverter::Initialise(const clang::VarDecl* variable, VariableId id) {
  const bool product = InProduct(variable);
  const Holder holder = llvm::isa<clang::ParmVarDecl>(variable) ? Holder::kParameter : Holder::kObject;
  const bool system = unit_.variables[id].storage == Storage::kSystem;
  if (!product && !system) {
    checker_.CheckDeclaredType(variable->getType(), holder, variable->getNameAsString(), NameOf(variable), variable);
  }
  const clang::Expr* init = variable->getInit();
  if (init == nullptr || system) return;
  if (variable->hasGlobalStorage() && !product) CheckConstant(init);
  std::vector<InitialValue> values;
  Flatten(init, variable->getType(), 0, values);
  unit_.variables[id].initialised = true;
  unit_.variables[id].initial = std::move(values);
}

void VariableConverter::CheckConstant(const clang::Expr* init) {
  if (!init->isConstantInitializer(context_, false)) return;  // reported
  const clang::Expr* found = FirstNotConstant(init);
  if (found == nullptr) return;
  findings().Report(RangeOf(found), diag::HncConstantRequired, "to initialise static data");
}

void VariableConverter::Flatten(const clang::Expr* init, clang::QualType type, uint32_t offset,
                                std::vector<InitialValue>& values) {
  if (llvm::isa<clang::ImplicitValueInitExpr>(init)) return;
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(init);
  if (list == nullptr) {
    const auto* string = llvm::dyn_cast<clang::StringLiteral>(init->IgnoreParens());
    if (string != nullptr && type->isArrayType() && llvm::isa<clang::ParenExpr>(init)) {
      findings().Report(RangeOf(init), diag::HncIncompatible, "an array is initialised with { } or a string");
    }
    InitialValue value{.offset = offset,
                       .is_bit_field = false,
                       .bit_offset = 0,
                       .bit_width = 0,
                       .type = types_.TypeOf(type),
                       .value = {}};
    value.value =
        string != nullptr && type->isArrayType() ? builder_.String(string, value.type) : expressions_.Convert(init);
    values.push_back(value);
    return;
  }
  if (!list->isSemanticForm() && list->getSemanticForm() != nullptr) list = list->getSemanticForm();
  if (const clang::ArrayType* array = context_.getAsArrayType(type)) {
    if (list->isStringLiteralInit()) return Flatten(list->getInit(0), type, offset, values);
    const uint32_t size = unit_.types[types_.TypeOf(array->getElementType())].size;
    for (unsigned i = 0; i < list->getNumInits(); ++i) {
      Flatten(list->getInit(i), array->getElementType(), offset + i * size, values);
    }
    return;
  }
  const auto* record = type->getAs<clang::RecordType>();
  if (record == nullptr) {
    if (list->getNumInits() > 0) Flatten(list->getInit(0), type, offset, values);
    return;
  }
  const RecordId id = types_.RecordOf(record->getDecl());
  const std::vector<Member> members = unit_.records[id].members;  // converting may add records
  const bool is_union = unit_.records[id].is_union;
  if (members.empty()) return;  // it has an error
  unsigned next = 0;
  for (const clang::FieldDecl* field : record->getDecl()->getDefinition()->fields()) {
    if (field->isUnnamedBitField()) continue;
    if (is_union && field != list->getInitializedFieldInUnion()) continue;
    if (next >= list->getNumInits()) break;
    const size_t before = values.size();
    const Member& member = members[field->getFieldIndex()];
    Flatten(list->getInit(next++), field->getType(), offset + member.offset, values);
    if (!member.is_bit_field || values.size() == before) continue;
    values.back().is_bit_field = true;
    values.back().bit_offset = member.bit_offset;
    values.back().bit_width = member.bit_width;
  }
}

}  // namespace plcxx::hnc
