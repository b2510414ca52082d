// Which requirements of a checklist the tests name.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "tests/policy/repository.h"

namespace plcxx::policy {

struct Coverage {
  std::vector<std::string> ids;                           // of the checklist, in its order
  std::map<std::string, std::string> titles;              // by id
  std::map<std::string, std::vector<std::string>> tests;  // by id: "tests/ir/items_test.cc:12"
  std::vector<std::string> unknown;                       // named by a test, but not in the checklist
};

/// Reads `covers: NC110-063 NC110-070..076` from the comments of every file below tests/ of `root`.
Coverage FindCoverage(const std::string& root, std::string_view checklist);

/// The ids that no test names.
std::vector<std::string> Uncovered(const Coverage& coverage);

/// One line per id: its title and the tests that name it.
std::string Table(const Coverage& coverage);

}  // namespace plcxx::policy
