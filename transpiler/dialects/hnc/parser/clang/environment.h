// What the names in a body mean at its place, as one number: a body with the same text and the same environment is read
// to the same tree, whatever else has changed in the program.
//
// The environment has all that a name can be: macros, with what their texts name in turn; all declarations at file
// level, with their types down to the members of records; how many of them stand in front of the body; and the
// function's own parameters. What is not told apart here would be taken over wrongly, so that too much is in it rather
// than too little.
#pragma once

#include <clang/AST/Decl.h>
#include <clang/Lex/MacroInfo.h>
#include <llvm/ADT/DenseMap.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/node_converter.h"

namespace plcxx::hnc {

/// One number of many, in their order.
class Digest {
 public:
  void Add(uint64_t value);
  void Add(std::string_view text);
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0;
};

using BodyWords = std::shared_ptr<const std::vector<std::string>>;

class Environment : private NodeConverter {
 public:
  using NodeConverter::NodeConverter;

  /// The declarations of the program, once it is parsed.
  void Collect();
  /// Null where a name goes on in the next line.
  BodyWords WordsOf(const clang::CompoundStmt* body) const;
  /// Of the body that the function has, `words` being all names in it; 0: it cannot be said.
  uint64_t Of(const clang::FunctionDecl* function, const std::vector<std::string>& words);

 private:
  struct Meaning {
    uint64_t digest = 0;
    uint32_t order = 0;  // of the declaration in the program
  };

  void Add(const clang::Decl* declaration, uint32_t order);
  void AddMembers(const clang::RecordDecl* record, uint32_t order);
  void AddMeaning(const clang::NamedDecl* declaration, const Digest& digest, uint32_t order);
  Digest DigestOf(const clang::NamedDecl* declaration) const;
  void DigestVariable(Digest& digest, const clang::VarDecl* variable) const;
  void DigestFunction(Digest& digest, const clang::FunctionDecl* function) const;
  /// False: it puts names together.
  bool DigestMacro(Digest& digest, const clang::MacroInfo& macro, std::vector<clang::IdentifierInfo*>& names) const;

  llvm::DenseMap<const clang::IdentifierInfo*, std::vector<Meaning>> meanings_;
  llvm::DenseMap<const clang::FunctionDecl*, uint32_t> orders_;  // of definitions
  Digest nameless_;                                              // what has no name
};

}  // namespace plcxx::hnc
