// The files of a source tree as the rules see them.
//
// In: a root (the repository, or a fixture that looks like one). Out: paths relative to it, sorted, and their texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plcxx::policy {

/// This repository; the copy of it that PLCXX_POLICY_ROOT names.
const std::string& Root();
/// A small tree that breaks one rule.
std::string Fixture(std::string_view name);

/// One finding per line: "transpiler/ir/op.cc:12: what is wrong".
using Findings = std::vector<std::string>;

/// All files below `folder` of `root`; none when it does not exist. Builds, .git and this folder's fixtures are left
/// out. `endings` such as {".cc", ".h"}; empty: every file.
std::vector<std::string> FilesBelow(const std::string& root, std::string_view folder,
                                    const std::vector<std::string>& endings = {});

std::string ReadFile(const std::string& path);
std::vector<std::string> Lines(std::string_view text);
/// The words between blanks.
std::vector<std::string> Words(std::string_view text);
std::string Place(std::string_view file, size_t line);
/// For a failure's text: one finding per line.
std::string Joined(const Findings& findings);

}  // namespace plcxx::policy
