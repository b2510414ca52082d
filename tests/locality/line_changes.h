// How many lines a person has to read of the difference between two versions of generated files.
//
// In: the files of both. Out: removed and added lines of a shortest difference, and changed lines: of a stretch in
// which a lines were replaced by b lines, the larger number. A file that only one version has counts as a whole.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/emit/output_file.h"

namespace plcxx::locality {

struct LineChanges {
  size_t removed = 0;
  size_t added = 0;
  size_t changed = 0;
};

/// By the algorithm of Myers: time and memory grow with the number of differences, not with the length.
LineChanges CompareLines(std::string_view before, std::string_view after);

/// Over all files of both versions, by name.
LineChanges CompareFiles(const std::vector<emit::OutputFile>& before, const std::vector<emit::OutputFile>& after);

/// What 200 edits are judged by.
struct Distribution {
  size_t median = 0;
  size_t percentile99 = 0;  // one edit in a hundred may exceed it
  size_t most = 0;
};
/// Not of an empty list.
Distribution DistributionOf(std::vector<size_t> changed);
/// Whether the edits stay within their statements: a median of at most 3 lines, and 99 of 100 at most 20.
bool IsLocal(const Distribution& distribution);

}  // namespace plcxx::locality
