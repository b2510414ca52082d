// Rules about what texts may hold: committed C++ output, and everything else in the repository.
#pragma once

#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// Dates, paths, versions and line numbers in the generated C++ below samples/ of `root`.
Findings CheckGenerated(const std::string& root);

/// Paths of somebody's machine, e-mail addresses, hosts of package registries, in any text file.
Findings CheckPrivate(const std::string& root);

/// Files of the repository that a document names between backticks, and that are not there.
Findings CheckNamedFiles(const std::string& root);

/// Sources (.h, .cc, .def) that a comment of a source names, by their path or its end, and that are not there.
Findings CheckNamedSources(const std::string& root);

/// Folders directly below transpiler/ that CONTRIBUTING.md does not name.
Findings CheckNamedFolders(const std::string& root);

/// Files that a page of the documents, or the README, has its reader write ("file=NAME" behind the fence, which no
/// browser shows), and whose name is not in the paragraph above.
Findings CheckShownFiles(const std::string& root);

/// Commands of the command line of `root`, and variables of the environment that it reads, that docs/security.md does
/// not name: who runs plcxx for others wants all of them.
Findings CheckSecurity(const std::string& root);

}  // namespace plcxx::policy
