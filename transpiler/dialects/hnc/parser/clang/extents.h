// Where expressions and statements begin and end.
//
// Clang answers by going down to the first or last part each time: for each sum of a long chain of sums, and each label
// of a long row of labels, as far as the chain. Here each that is far up a chain is asked once.
#pragma once

#include <clang/AST/Expr.h>
#include <clang/AST/Stmt.h>
#include <clang/Basic/SourceLocation.h>
#include <llvm/ADT/DenseMap.h>

namespace plcxx::hnc {

class Extents {
 public:
  clang::SourceLocation BeginOf(const clang::Expr* expr);
  clang::SourceLocation EndOf(const clang::Stmt* statement);

 private:
  llvm::DenseMap<const clang::Stmt*, clang::SourceLocation> begins_, ends_;
};

}  // namespace plcxx::hnc
