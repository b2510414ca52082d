// Lowers nc110 programs given as text and shows the IR, for the tests of the lowering and of the text files.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/nc110.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::nc110 {

/// One compilation; the files that options name are given as text by `named`.
struct LoweredProgram {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Lowered lowered;

  const ir::Program& program() const { return lowered.program; }
  /// "3 nc110-W310" of every diagnostic, in source order.
  std::vector<std::string> Reported() const {
    std::vector<std::string> result;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      const uint32_t line = diagnostic.range.begin == 0 ? 0 : sources.Locate(diagnostic.range.begin).line;
      result.push_back(std::to_string(line) + " " + std::string(diagnostic.row->code));
    }
    return result;
  }
  /// The instructions of one routine as the printer shows them, without indentation.
  std::vector<std::string> Routine(std::string_view name) const;
};

inline std::vector<std::string> Lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
    lines.emplace_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

inline std::vector<std::string> LoweredProgram::Routine(std::string_view name) const {
  std::vector<std::string> result;
  bool inside = false;
  for (const std::string& line : Lines(ir::Print(program()))) {
    if (line.starts_with("routine ")) {
      inside = line.starts_with("routine " + std::string(name) + " ");
      continue;
    }
    if (line.starts_with("schedule ")) inside = false;
    // The number of a statement is a hash; its subject tells enough.
    const size_t subject = line.find("; ");
    const bool marker = line.starts_with("stmt ");
    if (inside)
      result.push_back(!marker ? line : subject == std::string::npos ? "stmt" : "stmt " + line.substr(subject + 2));
  }
  return result;
}

using OptionMap = std::map<std::string, std::string>;

inline void LowerInto(LoweredProgram& lowered, const std::vector<std::string>& files, const OptionMap& options = {},
                      const OptionMap& named = {}) {
  dialects::Request request;
  request.sources = &lowered.sources;
  request.diagnostics = &lowered.diagnostics;
  request.options = options;
  request.load = [&](const std::string& path) -> std::variant<source::FileId, source::LoadError> {
    const auto found = named.find(path);
    if (found == named.end()) return source::LoadError{source::LoadProblem::kMissing, "no such file"};
    return lowered.sources.AddText(path, found->second);
  };
  for (const std::string& text : files) {
    request.files.push_back(lowered.sources.AddText("file" + std::to_string(request.files.size() + 1), text));
  }
  lowered.lowered = kNc110.lower(request);
  lowered.diagnostics.SortBySource();
  if (!lowered.diagnostics.HasErrors()) {
    EXPECT_THAT(ir::Verify(lowered.program(), ir::Stage::kLowered), testing::IsEmpty()) << ir::Print(lowered.program());
  }
}

/// The body of the slow part, which is all of `statements`, up to its end.
inline std::vector<std::string> SlowBody(const std::string& statements, const OptionMap& options = {}) {
  LoweredProgram lowered;
  LowerInto(lowered, {"$\n" + statements}, options);
  EXPECT_FALSE(lowered.diagnostics.HasErrors()) << statements;
  std::vector<std::string> body;
  bool inside = false;
  for (const std::string& line : lowered.Routine("slow")) {
    if (line == "epilogue {") break;
    if (inside) body.push_back(line);
    if (line == "body {") inside = true;
  }
  if (!body.empty()) body.pop_back();  // the body's own brace
  return body;
}

}  // namespace plcxx::nc110
