#include "transpiler/dialects/hnc/parser/clang/record_layout.h"

#include <clang/AST/ASTContext.h>
#include <clang/AST/Decl.h>

#include <algorithm>

namespace plcxx::hnc {

bool RecordLayouts::layoutRecordType(const clang::RecordDecl* record, uint64_t& size, uint64_t& alignment,
                                     llvm::DenseMap<const clang::FieldDecl*, uint64_t>& offsets,
                                     llvm::DenseMap<const clang::CXXRecordDecl*, clang::CharUnits>& /*bases*/,
                                     llvm::DenseMap<const clang::CXXRecordDecl*, clang::CharUnits>& /*virtual_bases*/) {
  const clang::ASTContext& context = record->getASTContext();
  const auto is_sound = [](const clang::FieldDecl* field) {
    return !field->isInvalidDecl() && !field->getType()->isIncompleteType();
  };
  if (record->isInvalidDecl() || !std::ranges::all_of(record->fields(), is_sound)) return false;
  uint64_t end = 0;                      // of what is laid out, in bits
  uint64_t unit_end = 0, unit_bits = 0;  // of the open unit of bit-fields; 0 bits: none
  uint64_t used = 0;                     // where the next bit-field of the unit begins
  size = 0;
  for (const clang::FieldDecl* field : record->fields()) {
    const uint64_t bits = context.getTypeSize(field->getType());
    if (record->isUnion()) {
      offsets[field] = 0;
      const bool counts = !field->isBitField() || field->getBitWidthValue(context) != 0;
      size = std::max(size, counts ? bits : 0);
      continue;
    }
    if (!field->isBitField()) {
      unit_bits = 0;
      offsets[field] = end;
      end += bits;
      continue;
    }
    const uint64_t width = field->getBitWidthValue(context);
    if (width == 0) {
      unit_bits = 0;
      offsets[field] = end;
      continue;
    }
    if (unit_bits != bits || used + width > unit_end) {
      used = end;
      unit_bits = bits;
      unit_end = end += bits;  // it counts with its full size
    }
    offsets[field] = used;
    used += width;
  }
  if (!record->isUnion()) size = end;
  alignment = context.getCharWidth();
  return true;
}

}  // namespace plcxx::hnc
