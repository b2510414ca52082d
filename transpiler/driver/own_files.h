// Which files plcxx has written itself: only those may give way to a new one without an order.
//
// A file that the command line names (`-o mill.hpp`, `--junit r.xml`) is such an order. Of a name that plcxx makes
// (main.cpp of main.plc) the user may have a file of another kind.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace plcxx::driver {

/// Is there a file with something in it at `path` that is not of the kind of `text`, as far as its beginning shows?
bool IsForeign(const std::string& path, std::string_view text);

/// What a file of counterexamples begins with.
inline constexpr std::string_view kDifferenceHead = "# U4A8 is 1 in the old version and 0 in the new one.";
inline constexpr std::string_view kViolationHead = "# A run that violates the property";
/// And a run that a soak has kept.
inline constexpr const char* kKeptRunHead = "# Kept by plcxx soak: it reaches what no other run does.";

/// "STEM.yaml", or "STEM_2.yaml" ... where a file of another kind than `head` has that name in the folder, or one of
/// this run, which are in `taken`.
std::string FreeName(const std::string& directory, const std::string& stem, std::string_view head,
                     std::set<std::string>& taken);

}  // namespace plcxx::driver
