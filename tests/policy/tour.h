// The tour of the README, run as it is written.
//
// "file=NAME" fences are files of an empty directory; "console" fences hold commands ("$ ...") and what they print,
// where a line "..." stands for any number of lines. A fence that says "fails" expects exit code 1, any other 0. A
// command `cd` holds for all that follows, fences of files included. git knows a name for commits.
#pragma once

#include <string>
#include <string_view>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// `tool_directory` goes in front of PATH, $PLCXX is this repository. Commands that fail or print something else.
Findings RunTour(const std::string& name, std::string_view text, const std::string& tool_directory);

}  // namespace plcxx::policy
