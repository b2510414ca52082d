// Lowers technol programs given as text and shows the IR, for the tests of the lowering and of paths.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/technol/control/locate.h"
#include "transpiler/dialects/technol/source/sources.h"
#include "transpiler/dialects/technol/technol.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::technol {

using OptionMap = std::map<std::string, std::string>;

/// One compilation.
struct LoweredProgram {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Lowered lowered;

  const ir::Program& program() const { return lowered.program; }
  /// "3 TE057" of every diagnostic with one of these beginnings, in source order.
  std::vector<std::string> Reported(const std::vector<std::string>& codes) const;
  /// The instructions of one routine as the printer shows them, without indentation and numbers of statements.
  std::vector<std::string> Routine(std::string_view name) const;
};

inline std::vector<std::string> LoweredProgram::Reported(const std::vector<std::string>& codes) const {
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    const std::string code(diagnostic.row->code.substr(diagnostic.row->code.find('-') + 1));
    const bool wanted = std::any_of(codes.begin(), codes.end(),
                                    [&](const std::string& beginning) { return code.starts_with(beginning); });
    if (wanted) result.push_back(std::to_string(sources.Locate(diagnostic.range.begin).line) + " " + code);
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
  request.load = [](const std::string&) { return source::LoadError{}; };
  const auto loaded = lowered.sources.AddBytes("/nowhere/a.plc", text, SourceOptions());
  if (const auto* file = std::get_if<source::FileId>(&loaded)) request.files.push_back(*file);
  lowered.lowered = kTechnol.lower(request);
  lowered.diagnostics.SortBySource();
  if (!lowered.diagnostics.HasErrors()) {
    EXPECT_THAT(ir::Verify(lowered.program(), ir::Stage::kLowered), testing::IsEmpty()) << ir::Print(lowered.program());
  }
}

/// The cells of these tests stand on line 2, the code of MODULE_MAIN begins on line 5.
inline std::string TechnolProgram(std::string_view code, std::string_view behind = "") {
  return "DATA\nBITS: DFM A,B,C,Q\nX: DB ?\nW: DW ?\nD: DD ?\nDATA_END\nMODULE_MAIN\n" + std::string(code) +
         "MODULE_MAIN_END\n" + std::string(behind) + "STOP\n";
}

/// The statements of MODULE_MAIN, without the stores of what registers hold at their ends.
inline std::vector<std::string> Main(std::string_view code, std::string_view behind = "",
                                     const OptionMap& options = {}) {
  LoweredProgram lowered;
  LowerInto(lowered, TechnolProgram(code, behind), options);
  EXPECT_THAT(lowered.Reported({"TE"}), testing::IsEmpty()) << code;
  std::vector<std::string> lines = lowered.Routine("MODULE_MAIN");
  const auto first =
      std::find_if(lines.begin(), lines.end(), [](const std::string& line) { return line.starts_with("stmt"); });
  lines.erase(lines.begin(), first);
  std::erase_if(lines, [](const std::string& line) {
    for (const std::string_view reg : {"rlo", "ax", "bx", "dr", "dx", "si", "di", "cf", "zf", "sf", "of", "af"}) {
      if (line.starts_with("store " + std::string(reg) + " ")) return true;
    }
    return false;
  });
  return lines;
}

}  // namespace plcxx::technol
