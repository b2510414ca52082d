// A Diff as text for a terminal, Markdown for a merge request, JSON and SARIF for programs.
#pragma once

#include <string>
#include <vector>

#include "transpiler/diagnostics/render.h"
#include "transpiler/review/diff/diff.h"
#include "transpiler/review/diff/groups.h"

namespace plcxx::driver {

struct DiffNames {
  std::string old_label, new_label;
  std::string program = {};   // of several; empty: there is one
  std::string new_file = {};  // where the statements of the new version begin
};

std::string DiffText(const review::diff::Diff& diff, const DiffNames& names, diag::Colour colour);
std::string DiffMarkdown(const review::diff::Diff& diff, const DiffNames& names);
std::string DiffJson(const review::diff::Diff& diff, const DiffNames& names);
std::string DiffSarif(const review::diff::Diff& diff, const DiffNames& names);

/// "2 outputs differ, 1 is not decided; 41 proved equal"
std::string DiffSummary(const review::diff::Diff& diff);

/// The changed statements as lines of a patch; empty when what comes first shows them all.
std::string ChangesAsPatch(const review::diff::Diff& diff);

/// Of a group: why it is in the list, and "U4A0..3 (4)".
std::string Cause(const review::diff::DiffGroup& group);
std::string Heading(const review::diff::DiffGroup& group);

}  // namespace plcxx::driver
