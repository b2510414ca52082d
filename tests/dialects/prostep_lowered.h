// Lowers prostep programs given as text and shows the IR, for the tests of the lowering.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/prostep/prostep.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::prostep {

using OptionMap = std::map<std::string, std::string>;

/// One compilation.
struct LoweredProgram {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Lowered lowered;

  const ir::Program& program() const { return lowered.program; }
  /// "3 W18" of every diagnostic, in source order.
  std::vector<std::string> Reported() const;
  /// The instructions of one routine as the printer shows them, without indentation and numbers of statements.
  std::vector<std::string> Routine(std::string_view name) const;
};

inline std::vector<std::string> LoweredProgram::Reported() const {
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    const std::string_view code = diagnostic.row->code;
    result.push_back(std::to_string(sources.Locate(diagnostic.range.begin).line) + " " +
                     std::string(code.substr(code.find('-') + 1)));
  }
  return result;
}

inline std::vector<std::string> LoweredProgram::Routine(std::string_view name) const {
  std::vector<std::string> result;
  const std::string text = ir::Print(program());
  bool inside = false;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    if (line == "}") inside = false;
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    if (line.starts_with("routine ")) {
      inside = line.starts_with("routine " + std::string(name) + " ");
      continue;
    }
    if (!inside) continue;
    const size_t subject = line.find("; ");
    if (!line.starts_with("stmt ")) {
      result.emplace_back(line);
    } else {
      result.push_back(subject == std::string_view::npos ? "stmt" : "stmt " + std::string(line.substr(subject + 2)));
    }
  }
  return result;
}

inline void LowerInto(LoweredProgram& lowered, const std::string& text, const OptionMap& options = {}) {
  dialects::Request request;
  request.sources = &lowered.sources;
  request.diagnostics = &lowered.diagnostics;
  request.options = options;
  request.files.push_back(lowered.sources.AddText("a.plc", text));
  lowered.lowered = kProstep.lower(request);
  lowered.diagnostics.SortBySource();
  if (!lowered.diagnostics.HasErrors()) {
    EXPECT_THAT(ir::Verify(lowered.program(), ir::Stage::kLowered), testing::IsEmpty()) << ir::Print(lowered.program());
  }
}

/// The instructions of PM 9, which is all of `statements`, behind the zeros with which the scheduler enters it.
inline std::vector<std::string> LoopModule(const std::string& statements, const OptionMap& options = {}) {
  LoweredProgram lowered;
  LowerInto(lowered, ":MOD PM 9\n" + statements + ":END PM 9\n", options);
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << statements;
  std::vector<std::string> lines = lowered.Routine("PM9");
  const auto first = std::find_if(lines.begin(), lines.end(), [](const std::string& line) {
    return line.starts_with("stmt") || line.starts_with("label");
  });
  lines.erase(lines.begin(), first);
  return lines;
}

/// What was reported of a program, warnings about what it lacks left out: W30, W35, W36, W37.
inline std::vector<std::string> Warnings(const std::string& text, const OptionMap& options = {}) {
  LoweredProgram lowered;
  LowerInto(lowered, text, options);
  std::vector<std::string> reported = lowered.Reported();
  std::erase_if(reported, [](const std::string& line) {
    const std::string code = line.substr(line.find(' ') + 1);
    return code == "W30" || code == "W35" || code == "W36" || code == "W37";
  });
  return reported;
}

}  // namespace plcxx::prostep
