// One run of the C parser: Clang's objects, and the way from its places to ours.
#pragma once

#include <clang/AST/ASTConsumer.h>
#include <clang/AST/DeclGroup.h>
#include <clang/Frontend/CompilerInstance.h>
#include <clang/Lex/Token.h>

#include <string>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/hnc/parser/clang/macro_uses.h"
#include "transpiler/dialects/hnc/parser/module.h"

namespace clang {
class Parser;
}

namespace plcxx::hnc {

/// Places of the rewritten texts as places of the files. A place within a macro is the place of the macro's use.
class Places {
 public:
  Places(const ParserInput& input, clang::CompilerInstance& clang) : input_(input), clang_(clang) {}

  /// 0 for a place in a header of the product, and for no place.
  source::Offset Of(clang::SourceLocation place) const;
  /// Of the tokens from the one at `first` to the one at `last`.
  source::Range Of(clang::SourceLocation first, clang::SourceLocation last) const;
  source::Range Of(clang::SourceRange tokens) const { return Of(tokens.getBegin(), tokens.getEnd()); }
  source::Range OfToken(clang::SourceLocation token) const { return Of(token, token); }
  /// Does the place stand in a header of the product, not in a use of its macros?
  bool InProduct(clang::SourceLocation place) const;
  /// Of a place in a header of the product, where the program includes it; invalid: it does not.
  clang::SourceLocation IncludedAt(clang::SourceLocation place) const;

 private:
  /// What Clang numbers places by: one entry for each inclusion of a file and each expansion of a macro. Its own search
  /// begins at the end of all entries each time, while places are asked for in about their order.
  struct Entry {
    unsigned begin = 0;                 // the first of its places
    clang::SourceLocation first, last;  // expansion: tokens of the outermost use, in a file; file: none
    uint32_t file = kNotAsked;          // file: index into files_
  };
  struct File {
    const SourceText* text = nullptr;  // none: predefined, or made by the preprocessor
    std::vector<source::Offset> ends;  // by place in the text: of the token there; 0: not asked for
  };
  static constexpr uint32_t kNotAsked = UINT32_MAX;

  void AddEntries() const;
  size_t Search(unsigned number, size_t& last_found) const;
  /// Index into entries_.
  size_t EntryOf(clang::SourceLocation place) const;
  /// The tokens of the outermost use that the place is in, in a file.
  clang::SourceLocation FirstOf(clang::SourceLocation place) const;
  clang::SourceLocation LastOf(clang::SourceLocation place) const;
  /// Of a place in a file.
  File& FileOf(clang::SourceLocation place, size_t entry) const;
  source::Offset EndOfToken(clang::SourceLocation place, size_t entry) const;

  const ParserInput& input_;
  clang::CompilerInstance& clang_;
  mutable std::vector<Entry> entries_;  // as Clang has them
  mutable std::vector<File> files_;
  mutable size_t last_file_ = 0, last_expansion_ = 0;  // entries that were found last
};

struct Session {
  Session(const ParserInput& in, ParseUntil to, ParserOutput& out)
      : input(in), until(to), output(out), places(in, clang) {}

  const ParserInput& input;
  ParseUntil until;
  ParserOutput& output;
  clang::CompilerInstance clang;
  Places places;
  const clang::Parser* parser = nullptr;  // while it runs
  std::vector<clang::Token> tokens;       // after the preprocessor and the language's own words
  MacroUses macro_uses;
  /// Names whose letters are not all significant (2.3), of macros, too, and where they stand.
  struct LongName {
    std::string name;
    clang::SourceLocation place;
  };
  std::vector<LongName> long_names;
  std::vector<LoopBound> loop_bounds;  // #pragma plcxx loop_bound, by place
  std::vector<uint32_t>
      elided_uses;  // by index into KeptBodies::elided: the first of its macro uses, once it was passed
  std::unordered_set<const clang::FunctionDecl*> unclean;  // something was found while they were parsed
  uint32_t errors = 0;                                     // that Clang reports, whatever becomes of them
  bool stopped = false;  // nested too deep, too many errors: what follows the place is not looked at

  Findings& findings() { return output.findings; }
  void NoteName(const std::string& name, clang::SourceLocation place);
  /// Index into KeptBodies::elided of the body whose '{' is there; kNotElided: it is in the text.
  static constexpr uint32_t kNotElided = UINT32_MAX;
  uint32_t ElidedAt(source::Offset brace) const;
  clang::SourceManager& sources() { return clang.getSourceManager(); }
  /// The parser, which reads `tokens`, finds their end after the token where it is.
  void Stop();
};

/// Sets up Clang for the language (specification 3.7) and reports what it says through our catalogue.
void SetUp(Session& session);
/// Runs the preprocessor over the main source.
void Preprocess(Session& session);
/// Takes the language's own words out of the tokens: near, asm, interrupt, pseudo registers, what is an extension.
void FilterTokens(Session& session);
/// Parses the tokens and makes the tree.
void ParseTokens(Session& session);

/// What the parser has found, in its order.
class Declarations : public clang::ASTConsumer {
 public:
  bool HandleTopLevelDecl(clang::DeclGroupRef group) override {
    groups.push_back(group);
    return true;
  }
  void CompleteTentativeDefinition(clang::VarDecl* variable) override { tentative.push_back(variable); }

  std::vector<clang::DeclGroupRef> groups;
  std::vector<clang::VarDecl*> tentative;  // variables that nothing initialises
};

/// LLVM's bitcode of what Clang makes of the program, after the tree is made (generate_code.cc); empty: it has errors.
std::string GenerateCode(Session& session, const Declarations& declarations);

}  // namespace plcxx::hnc
