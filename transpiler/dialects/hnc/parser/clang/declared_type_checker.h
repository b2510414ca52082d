// What a declared type may not contain (specification 6.5): pointers to functions, pointers within aggregates, pointers
// to pointers; bit-fields of other types than 5.6 has; enumerators without a value of int.
#pragma once

#include <cstdint>
#include <string>
#include <unordered_set>

#include "transpiler/dialects/hnc/parser/clang/constant_folder.h"
#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class ExpressionConverter;

/// What has the type.
enum class Holder : uint8_t { kObject, kMember, kParameter, kResult };

class DeclaredTypeChecker : private NodeConverter {
 public:
  DeclaredTypeChecker(Conversion& conversion, ConstantFolder& folder, ExpressionConverter& expressions)
      : NodeConverter(conversion), folder_(folder), expressions_(expressions) {}

  void CheckDeclaredType(clang::QualType type, Holder holder, const std::string& name, source::Range range,
                         const clang::VarDecl* variable = nullptr);
  void CheckMembers(const clang::RecordDecl* record);
  void CheckEnumerators(const clang::EnumDecl* enumeration);

 private:
  bool IsTableOfStrings(const clang::VarDecl* variable) const;

  ConstantFolder& folder_;
  ExpressionConverter& expressions_;
  std::unordered_set<const clang::RecordDecl*> checked_records_;
};

}  // namespace plcxx::hnc
