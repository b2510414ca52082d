// Finds what can be mutated in the files that are asked for, and rewrites it to calls of mutation_points.h.
//
// Left alone, by rule: what constant evaluation computes (constexpr variables, tables, template arguments, array
// bounds, case labels), texts, what a macro wrote (PLCXX_CHECK among them), the arguments of calls that report
// something, room that is reserved (ExcludedCalls), and jumps without which the program is the same one
// (needless_jumps.h).
#pragma once

#include <clang/AST/ASTContext.h>

#include <map>
#include <string>
#include <vector>

#include "tests/mutants/mutate/edits.h"

namespace plcxx::mutants {

struct Mutant {
  unsigned id = 0;
  std::string file;
  unsigned line = 0;
  std::string function, kind, text;
};

struct Rewritten {
  std::vector<Mutant> mutants;
  std::map<std::string, Edits> files;  // by path
};

/// `files`: real paths. Ids begin with `first`.
Rewritten FindSites(clang::ASTContext& context, const std::vector<std::string>& files, unsigned first);

}  // namespace plcxx::mutants
