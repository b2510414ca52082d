// Lowers host50 programs given as text and shows the IR, for the tests of the lowering.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/lowering/lowering.h"
#include "transpiler/dialects/host50/parser/parser.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::host50 {

using Text = std::vector<std::string>;
using OptionMap = std::map<std::string, std::string>;

inline Text Lines(std::string_view text) {
  Text lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

struct LoweredProgram {
  source::SourceManager sources;
  diag::Engine diagnostics;
  ir::Program program;

  std::string Printed() const { return ir::Print(program); }
  /// The instructions of one routine as the printer shows them, without indentation and the closing brace.
  Text Routine(std::string_view name) const {
    Text result;
    bool inside = false;
    for (const std::string& line : Lines(Printed())) {
      if (line.starts_with("routine ") || line.starts_with("schedule ")) {
        if (inside) result.pop_back();
        inside = line.starts_with("routine " + std::string(name) + " ");
        continue;
      }
      // The number of a statement is a hash; its subject tells enough.
      const size_t subject = line.find("; ");
      const bool marker = line.starts_with("stmt ");
      if (inside) {
        result.push_back(!marker ? line : subject == std::string::npos ? "stmt" : "stmt " + line.substr(subject + 2));
      }
    }
    return result;
  }
};

inline void LowerInto(LoweredProgram& lowered, const std::vector<std::string>& files, const OptionMap& options = {}) {
  std::vector<source::FileId> ids;
  for (const std::string& text : files) {
    ids.push_back(lowered.sources.AddText("file" + std::to_string(ids.size() + 1), text));
  }
  const Program tree = Parse(lowered.sources, ids, options, lowered.diagnostics);
  for (const diag::Diagnostic& diagnostic : lowered.diagnostics.all()) {
    ADD_FAILURE() << lowered.sources.Locate(diagnostic.range.begin).line << ' ' << diagnostic.row->code << " in\n"
                  << files.front();
  }
  lowered.program = Lower(tree, tree.settings, lowered.sources);
  EXPECT_THAT(ir::Verify(lowered.program, ir::Stage::kLowered), testing::IsEmpty()) << lowered.Printed();
}

/// One network of the slow part.
inline std::string Slow(std::string_view instructions) {
  return "SLOW\nNETWORK\n" + std::string(instructions) + "END_SLOW\n";
}

/// The slow part of a program that has nothing but one network; lines are separated by ';' in `instructions`.
inline Text SlowBody(std::string instructions, const OptionMap& options = {}) {
  std::ranges::replace(instructions, ';', '\n');
  LoweredProgram lowered;
  LowerInto(lowered, {Slow(instructions + "\n")}, options);
  return lowered.Routine("slow");
}

}  // namespace plcxx::host50
