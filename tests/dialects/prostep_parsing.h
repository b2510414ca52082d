// Parses prostep programs given as text and shows what was reported, for the tests of the front end.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/dialects/prostep/analysis/program_checks.h"
#include "transpiler/dialects/prostep/parser/parser.h"
#include "transpiler/dialects/prostep/prostep.h"

namespace plcxx::prostep {

struct Parsed {
  source::SourceManager sources;
  diag::Engine diagnostics;
  std::vector<source::FileId> files;
  Program program;

  /// "2:5 E10" of every error, in source order.
  std::vector<std::string> Errors() const { return Listed(diag::Severity::kError); }
  std::vector<std::string> Warnings() const { return Listed(diag::Severity::kWarning); }
  std::string FirstText() const { return diagnostics.all().empty() ? "" : diagnostics.all().front().text; }
  /// The lines of `print syntax` without places and file names.
  std::vector<std::string> Items() const;

 private:
  std::vector<std::string> Listed(diag::Severity severity) const;
};

inline std::vector<std::string> Parsed::Listed(diag::Severity severity) const {
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity != severity) continue;
    const source::Position place = sources.Locate(diagnostic.range.begin);
    const std::string_view code = diagnostic.row->code;
    result.push_back(std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                     std::string(code.substr(code.find('-') + 1)));
  }
  return result;
}

inline std::vector<std::string> Parsed::Items() const {
  std::vector<std::string> result;
  const std::string text = PrintSyntax(sources, program);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (line.starts_with("  ")) result.push_back(line.substr(line.find(' ', 2) + 1));
    begin = end + 1;
  }
  return result;
}

enum class Checks : uint8_t { kParser, kWholeProgram };

/// Several files are one program. `bytes` are loaded as the dialect loads its sources.
inline void ParseInto(Parsed& parsed, const std::vector<std::string>& files, Checks checks = Checks::kParser,
                      std::optional<source::Encoding> encoding = std::nullopt) {
  source::LoadOptions options = kProstep.load;
  options.encoding = encoding;
  for (const std::string& bytes : files) {
    const auto loaded = parsed.sources.AddBytes("a.plc", bytes, options);
    if (const auto* file = std::get_if<source::FileId>(&loaded)) parsed.files.push_back(*file);
  }
  parsed.program = Parse(parsed.sources, parsed.files, parsed.diagnostics);
  ResolveCalls(parsed.program, parsed.diagnostics);
  if (checks == Checks::kWholeProgram && !parsed.diagnostics.HasErrors()) {
    CheckUncalled(parsed.program, parsed.diagnostics);
    CheckActivity(parsed.program, parsed.sources, parsed.diagnostics);
    CheckLabels(parsed.program, parsed.diagnostics);
    CheckMessages(parsed.program, parsed.diagnostics);
    CheckTimersAndCounters(parsed.program, parsed.diagnostics);
    CheckInputWrites(parsed.program, parsed.diagnostics);
  }
  parsed.diagnostics.SortBySource();
}

/// The lines of one module PM 20 without its MOD and END; the first of them is line 2.
inline std::string InModule(std::string_view lines) { return ":MOD PM 20\n" + std::string(lines) + "\n:END PM 20\n"; }

inline std::vector<std::string> ErrorsOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  return parsed.Errors();
}
inline std::vector<std::string> WarningsOf(const std::string& text, Checks checks = Checks::kParser) {
  Parsed parsed;
  ParseInto(parsed, {text}, checks);
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text;
  return parsed.Warnings();
}
inline std::vector<std::string> ItemsOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text;
  return parsed.Items();
}

}  // namespace plcxx::prostep
