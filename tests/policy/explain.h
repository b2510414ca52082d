// The programs of the explain pages, compiled.
//
// A page holds fences: "```nc110 wrong [set=key=value]... [program=first]" is a program that raises the page's code,
// "```nc110 right ..." one that does not, "```nc110 file=NAME" a file beside both: a source of the program when its
// name ends in .plc, .sym or .TCH (before the program; program=first: behind it), else a file that a set= option names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/policy/repository.h"

namespace plcxx::policy {

struct Fence {
  std::vector<std::string> words;  // "nc110", "wrong", "set=slices=2"
  std::string text;
  size_t line = 0;
};

std::vector<Fence> Fences(std::string_view page);

/// Codes of the catalogue without a page, and pages without a code.
Findings CheckPagesExist(const std::vector<std::string>& codes, const std::vector<std::string>& pages);

/// Compiles every wrong and right program of a page.
Findings CheckPage(const std::string& code, std::string_view page);

}  // namespace plcxx::policy
