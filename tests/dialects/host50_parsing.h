// Parses host50 programs given as text and shows what was reported, for the tests of the front end.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/analysis/warnings.h"
#include "transpiler/dialects/host50/parser/parser.h"

namespace plcxx::host50 {

struct Parsed {
  source::SourceManager sources;
  diag::Engine diagnostics;
  Program program;

  /// "2:5 E103" of every error, in source order; "file2:2:5 E103" in another file than the first.
  std::vector<std::string> Errors() const { return Listed(diag::Severity::kError); }
  std::vector<std::string> Warnings() const { return Listed(diag::Severity::kWarning); }
  std::vector<std::string> Notes() const { return Listed(diag::Severity::kNote); }
  std::string TextOfFirstError() const {
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      if (diagnostic.severity == diag::Severity::kError) return diagnostic.text;
    }
    return {};
  }
  /// The lines of `print syntax` below a network, without places: "#0 LD %I0".
  std::vector<std::string> Instructions() const {
    std::vector<std::string> result;
    for (const std::string& line : Lines()) {
      if (line.starts_with('#')) result.push_back(line);
    }
    return result;
  }
  /// All lines of `print syntax` without indentation and places, options left out.
  std::vector<std::string> Lines() const {
    std::vector<std::string> result;
    const std::string text = PrintSyntax(sources, program);
    for (size_t begin = 0; begin < text.size();) {
      const size_t end = text.find('\n', begin);
      std::string line = text.substr(begin, end - begin);
      line.erase(0, line.find_first_not_of(' '));
      if (line[0] >= '0' && line[0] <= '9') line.erase(0, line.find(' ') + 1);
      if (!line.starts_with("option ")) result.push_back(std::move(line));
      begin = end + 1;
    }
    return result;
  }

 private:
  std::vector<std::string> Listed(diag::Severity severity) const {
    std::vector<std::string> result;
    for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
      if (diagnostic.severity != severity) continue;
      const source::Position place = sources.Locate(diagnostic.range.begin);
      const std::string file = place.file == program.files.front() ? "" : sources.Get(place.file).path + ":";
      result.push_back(file + std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                       std::string(diagnostic.row->code.substr(diagnostic.row->code.find('-') + 1)));
    }
    return result;
  }
};

using OptionMap = std::map<std::string, std::string>;

inline void ParseInto(Parsed& parsed, const std::vector<std::string>& files, const OptionMap& options = {}) {
  std::vector<source::FileId> ids;
  for (const std::string& text : files) {
    ids.push_back(parsed.sources.AddText("file" + std::to_string(ids.size() + 1), text));
  }
  parsed.program = Parse(parsed.sources, ids, options, parsed.diagnostics);
  CheckProgram(parsed.program, parsed.sources, parsed.diagnostics);
  PlaceInFirstLines(parsed.program, parsed.diagnostics);
  parsed.diagnostics.SortBySource();
}

/// A program of one network: its instructions begin in line 3.
inline std::string InNetwork(std::string_view instructions) {
  return "SLOW\nNETWORK\n" + std::string(instructions) + "\nEND_SLOW\n";
}

inline std::vector<std::string> InstructionsOf(const std::string& text) {
  Parsed parsed;
  ParseInto(parsed, {text});
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text << "\n" << parsed.TextOfFirstError();
  return parsed.Instructions();
}

inline std::vector<std::string> ErrorsOf(const std::string& text, const OptionMap& options = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, options);
  EXPECT_EQ(parsed.program.faulty, parsed.diagnostics.HasErrors()) << text;
  return parsed.Errors();
}

inline std::vector<std::string> WarningsOf(const std::string& text, const OptionMap& options = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, options);
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text << "\n" << parsed.TextOfFirstError();
  return parsed.Warnings();
}

/// The errors of one network that begins in line 3.
inline std::vector<std::string> NetworkErrors(std::string_view instructions) {
  return ErrorsOf(InNetwork(instructions));
}

}  // namespace plcxx::host50
