// Types and layouts (specification 5.6).
#pragma once

#include <string>
#include <unordered_map>

#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

class TypeConverter : private NodeConverter {
 public:
  using NodeConverter::NodeConverter;

  TypeId TypeOf(clang::QualType type);
  TypeId Integer(unsigned bits, bool is_signed);
  RecordId RecordOf(const clang::RecordDecl* record);

 private:
  TypeId Describe(clang::QualType type);
  TypeId Add(Type type);
  void FillMembers(const clang::RecordDecl* record, RecordId id);
  std::string TextOf(clang::QualType type) const;

  // Only asked, never walked through.
  std::unordered_map<std::string, TypeId> types_;
  std::unordered_map<const void*, TypeId> known_types_;  // by Clang's type
  std::unordered_map<const clang::RecordDecl*, RecordId> records_;
};

}  // namespace plcxx::hnc
