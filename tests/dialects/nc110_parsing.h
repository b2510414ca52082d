// Parses nc110 programs given as text and shows what was reported, for the parser's tests.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "transpiler/dialects/nc110/parser/parser.h"

namespace plcxx::nc110 {

struct Parsed {
  source::SourceManager sources;
  diag::Engine diagnostics;
  Program program;

  /// "2:5 nc110-3" of every error, in source order.
  std::vector<std::string> Errors() const { return Listed(diag::Severity::kError); }
  std::vector<std::string> Warnings() const { return Listed(diag::Severity::kWarning); }
  /// The items as `print syntax` shows them, without places and file names.
  std::vector<std::string> Items() const;
  std::string TextOfFirstError() const;

 private:
  std::vector<std::string> Listed(diag::Severity severity) const;
};

inline std::vector<std::string> Parsed::Listed(diag::Severity severity) const {
  std::vector<std::string> result;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == severity) {
      const source::Position place = sources.Locate(diagnostic.range.begin);
      result.push_back(std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                       std::string(diagnostic.row->code));
    }
  }
  return result;
}

inline std::vector<std::string> Parsed::Items() const {
  std::vector<std::string> result;
  const std::string text = PrintSyntax(sources, program);
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    const std::string line = text.substr(begin, end - begin);
    if (line.starts_with("  ") && line.find('!') != 0) {
      result.push_back(line.substr(line.find(' ', 2) + 1));
    }
    begin = end + 1;
  }
  return result;
}

inline std::string Parsed::TextOfFirstError() const {
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == diag::Severity::kError) {
      return diagnostic.text;
    }
  }
  return {};
}

inline void ParseInto(Parsed& parsed, const std::vector<std::string>& files, const ParseOptions& options = {}) {
  std::vector<source::FileId> ids;
  for (const std::string& text : files) {
    ids.push_back(parsed.sources.AddText("file" + std::to_string(ids.size() + 1), text));
  }
  parsed.program = Parse(parsed.sources, ids, options, parsed.diagnostics);
  parsed.diagnostics.SortBySource();
}

inline std::vector<std::string> ItemsOf(const std::string& text, const ParseOptions& options = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, options);
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text << "\n" << parsed.TextOfFirstError();
  return parsed.Items();
}

inline std::vector<std::string> WarningsOf(const std::string& text, const ParseOptions& options = {}) {
  Parsed parsed;
  ParseInto(parsed, {text}, options);
  EXPECT_THAT(parsed.Errors(), testing::IsEmpty()) << text << "\n" << parsed.TextOfFirstError();
  return parsed.Warnings();
}

/// A wrong program: the only error it must raise, and the words its message must contain.
struct Wrong {
  std::string program;
  std::string error;  // "line:column code"
  std::vector<std::string> words;
};

inline std::string Lower(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

inline void ExpectWrong(const Wrong& wrong, const ParseOptions& options = {}) {
  Parsed parsed;
  ParseInto(parsed, {wrong.program}, options);
  const std::string text = parsed.TextOfFirstError();
  EXPECT_THAT(parsed.Errors(), testing::ElementsAre(wrong.error)) << wrong.program << "\n" << text;
  for (const std::string& word : wrong.words) {
    EXPECT_THAT(Lower(text), testing::HasSubstr(Lower(word))) << wrong.program;
  }
}

}  // namespace plcxx::nc110
