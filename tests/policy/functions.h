// The rule about the length of functions.
//
// In: the sources of transpiler and runtime_support. Out: the functions that are too long. Not its job: files
// (sources.h).
#pragma once

#include <cstddef>
#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// Of 12,000 functions half have at most 7 lines, 99 in 100 at most 46, and 999 in 1,000 at most 67: what is longer
/// than this does several things, and these have names.
inline constexpr size_t kMaxFunctionLines = 80;

/// Functions above kMaxFunctionLines. Lines of comments, of literals and of the preprocessor do not count, nor do the
/// labels of a switch and its `break;`: a dispatch over an enumeration is a table.
Findings CheckFunctions(const std::string& root);

}  // namespace plcxx::policy
