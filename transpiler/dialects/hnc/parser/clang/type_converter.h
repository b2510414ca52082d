// Types and layouts (specification 5.6).
#pragma once

#include <array>
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
  /// Equal descriptions are one type.
  TypeId Add(Type type);

 private:
  struct Known {
    TypeId id;
    uint32_t noted = 0;  // by which body last
  };

  TypeId Describe(clang::QualType type);
  void Note(clang::QualType type, Known& known);
  void NoteRecord(clang::QualType type, TypeId id);
  void FillMembers(const clang::RecordDecl* record, RecordId id);
  std::string TextOf(clang::QualType type) const;

  std::array<uint32_t, 10> noted_integers_{};  // by bytes and sign: by which body last
  // Only asked, never walked through.
  std::unordered_map<std::string, TypeId> types_;
  std::unordered_map<const void*, Known> known_types_;  // by Clang's type
  std::unordered_map<const clang::RecordDecl*, RecordId> records_;
};

}  // namespace plcxx::hnc
