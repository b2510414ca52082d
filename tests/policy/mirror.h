// The tests stand as what they test: tests/X is about transpiler/X.
//
// In: the list of what is about no single folder (mirror.txt). Out: folders of tests that no folder of the transpiler
// or of runtime_support has the name of, and test files in a folder of whose namesake they include nothing.
#pragma once

#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// `exceptions`: a folder below tests/, or a file, and the reason, in each line; a folder is one with all below it.
Findings CheckMirror(const std::string& root, const std::string& exceptions);

}  // namespace plcxx::policy
