// Where members of structures are (specification 5.6), told to Clang before it lays a record out itself.
//
// Clang's own layouts come near: -fpack-struct=1 with -mms-bitfields. But where `:0` closes a unit that does not begin
// at an even address, Clang forgets the rest of the unit, or aligns what follows; `sizeof` in a constant expression is
// Clang's, so that its layout has to be the right one from the beginning.
#pragma once

#include <clang/AST/ExternalASTSource.h>

namespace plcxx::hnc {

class RecordLayouts : public clang::ExternalASTSource {
 public:
  bool layoutRecordType(const clang::RecordDecl* record, uint64_t& size, uint64_t& alignment,
                        llvm::DenseMap<const clang::FieldDecl*, uint64_t>& offsets,
                        llvm::DenseMap<const clang::CXXRecordDecl*, clang::CharUnits>& bases,
                        llvm::DenseMap<const clang::CXXRecordDecl*, clang::CharUnits>& virtual_bases) override;
};

}  // namespace plcxx::hnc
