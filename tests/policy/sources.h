// Rules about single source files: their size, their names, their form, what they leave behind.
#pragma once

#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// .cc and .h above 600 lines. Tables (.def) are exempt. Those above 400 go to `to_question`.
Findings CheckSizes(const std::string& root, Findings& to_question);

/// Files and identifiers that call themselves utils, helper or manager.
Findings CheckNames(const std::string& root);

/// `default:` in a switch over an enum of ours (its labels are `case Name::kName`): an enumerator that is forgotten
/// there compiles.
Findings CheckDefaults(const std::string& root);

/// What clang-format would change.
Findings CheckFormat(const std::string& root);

/// Tests that write elsewhere than into tests/temporary_directory.h's directories.
Findings CheckLeftovers(const std::string& root);

/// Files that begin with `#!` and may not be executed: where one is the command of a test, the test cannot start.
Findings CheckScripts(const std::string& root);

}  // namespace plcxx::policy
