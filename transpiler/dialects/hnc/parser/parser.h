// Sources to the tree of syntax.h: the one entry of the front end.
//
// Loads the module with the C parser when it is called for the first time; reports everything that the tree tells to be
// wrong. Not its job: what needs the flow of the program (lowering).
#pragma once

#include <string>

#include "transpiler/dialects/dialect.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// Always gives a unit; `faulty` tells that errors were reported.
Unit Parse(dialects::Request& request);
/// Where something is kept of this run: with the tree that Parse gave.
void Keep(dialects::Request& request, Unit unit);

/// The same for a program without errors, and what Clang makes of it: LLVM's bitcode, empty where there is none.
struct CompiledUnit {
  Unit unit;
  std::string bitcode, compiler;
};
CompiledUnit ParseAndCompile(dialects::Request& request);

/// One token a line, after the preprocessor: line, column, kind, text.
std::string PrintTokens(dialects::Request& request);

/// The tree as nested lines (syntax_print.cc).
std::string PrintSyntax(const source::SourceManager& sources, const Unit& unit);

}  // namespace plcxx::hnc
