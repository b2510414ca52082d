#include "transpiler/dialects/hnc/parser/clang/declared_type_checker.h"

#include <clang/AST/Type.h>

#include "transpiler/dialects/hnc/machine/product_names.h"
#include "transpiler/dialects/hnc/parser/clang/expression_converter.h"

namespace plcxx::hnc {
namespace {

/// Does a pointer to a function stand anywhere in it?
bool HasFunctionPointer(clang::QualType type) {
  while (true) {
    if (const auto* pointer = type->getAs<clang::PointerType>()) {
      type = pointer->getPointeeType();
      if (type->isFunctionType()) return true;
    } else if (const clang::ArrayType* array = type->getAsArrayTypeUnsafe()) {
      type = array->getElementType();
    } else {
      return false;
    }
  }
}

const clang::Expr* WithoutCasts(const clang::Expr* expr) { return expr->IgnoreParenCasts(); }

}  // namespace

/// An initialised array of string literals that nothing can change.
bool DeclaredTypeChecker::IsTableOfStrings(const clang::VarDecl* variable) const {
  if (variable == nullptr || !variable->hasInit()) return false;
  const clang::ArrayType* array = context_.getAsArrayType(variable->getType());
  if (array == nullptr) return false;
  const auto* pointer = array->getElementType()->getAs<clang::PointerType>();
  if (pointer == nullptr || !pointer->getPointeeType()->isAnyCharacterType()) return false;
  const bool constant = array->getElementType().isConstQualified() || pointer->getPointeeType().isConstQualified();
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(variable->getInit());
  if (!constant || list == nullptr) return false;
  for (const clang::Expr* init : list->inits()) {
    const clang::Expr* element = WithoutCasts(init);
    if (!llvm::isa<clang::StringLiteral>(element) && !llvm::isa<clang::ImplicitValueInitExpr>(element)) return false;
  }
  return true;
}

void DeclaredTypeChecker::CheckDeclaredType(clang::QualType type, Holder holder, const std::string& name,
                                            source::Range range, const clang::VarDecl* variable) {
  if (range.begin == 0) return;
  const std::string quoted = "'" + name + "'";
  if (HasFunctionPointer(type)) {
    findings().Report(range, diag::HncFunctionPointer, quoted);
    return;
  }
  const bool is_array = context_.getAsArrayType(type) != nullptr;
  clang::QualType inner = type;
  while (const clang::ArrayType* array = context_.getAsArrayType(inner)) inner = array->getElementType();
  const auto* pointer = inner->getAs<clang::PointerType>();
  if (pointer == nullptr) return;
  clang::QualType target = pointer->getPointeeType();
  while (const clang::ArrayType* array = context_.getAsArrayType(target)) target = array->getElementType();
  if (target->isPointerType()) {
    findings().Report(range, diag::HncPointerDeclaration, quoted + " is a pointer to a pointer");
  } else if (holder == Holder::kMember) {
    findings().Report(range, diag::HncPointerDeclaration, quoted + " is a pointer in a struct or union");
  } else if (is_array && !IsTableOfStrings(variable)) {
    findings().Report(range, diag::HncPointerDeclaration, quoted + " is an array of pointers");
  }
}

void DeclaredTypeChecker::CheckMembers(const clang::RecordDecl* record) {
  record = record->getDefinition();
  if (record == nullptr || !checked_records_.insert(record).second) return;
  for (const clang::Decl* inner : record->decls()) {
    if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(inner)) CheckEnumerators(enumeration);
  }
  for (const clang::FieldDecl* field : record->fields()) {
    if (const auto* inner = field->getType()->getAs<clang::RecordType>()) CheckMembers(inner->getDecl());
    const source::Range range = NameOf(field);
    CheckDeclaredType(field->getType(), Holder::kMember, field->getNameAsString(), range);
    if (!field->isBitField()) continue;
    const clang::QualType type = field->getType().getCanonicalType();
    const bool fits = type->isSpecificBuiltinType(clang::BuiltinType::Int) ||
                      type->isSpecificBuiltinType(clang::BuiltinType::UInt) || type->isAnyCharacterType();
    if (!fits) findings().Report(range, diag::HncIncompatible, "a bit-field is int, unsigned or char");
  }
}

void DeclaredTypeChecker::CheckEnumerators(const clang::EnumDecl* enumeration) {
  for (const clang::EnumConstantDecl* constant : enumeration->enumerators()) {
    const int64_t value = constant->getInitVal().getExtValue();
    if (value < -32768 || value > 32767) {
      findings().Report(NameOf(constant), diag::HncConstantTooLarge, constant->getName());
      break;  // those after it follow
    }
    const clang::Expr* init = constant->getInitExpr();
    if (init == nullptr || constant->getName().starts_with(kProductPrefix)) continue;
    if (folder_.HasWildShift(expressions_.Convert(init))) {
      findings().Report(NameOf(constant), diag::HncConstantRequired, "with a shift count inside the width");
    }
  }
}

}  // namespace plcxx::hnc
