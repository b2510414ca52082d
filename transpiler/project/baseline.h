// Warnings of an old program that were accepted once, so that only new ones are seen.
//
// In: the diagnostics of a compilation. Out: those that no entry accepts; a file of entries. An entry names the code,
// the file and the text of the statement, never a line: a statement that moves keeps its warnings accepted, and one
// that changes does not.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <variant>

#include "transpiler/compilation/compilation.h"
#include "transpiler/yaml/place.h"

namespace plcxx::project {

inline constexpr std::string_view kBaselineFile = "plcxx.baseline";

struct Baseline {
  std::map<std::string, size_t> accepted;  // how many of each entry, as they are written
};

std::variant<Baseline, yaml::Error> ReadBaseline(const std::string& path);

/// All warnings and notes of the compilation as a file; files are named relative to `folder`.
std::string BaselineText(const compilation::Compilation& compilation, const std::string& folder);

struct Accepted {
  size_t warnings = 0;  // that were taken out
  size_t stale = 0;     // entries that no warning has needed
};

/// As Compile, without the warnings that `baseline` accepts: they are no errors either where the request makes errors
/// of warnings.
compilation::Compilation CompileAccepting(const compilation::CompilationRequest& request, compilation::Stage until,
                                          const Baseline& baseline, const std::string& folder, Accepted& accepted);

}  // namespace plcxx::project
