// The reference grammar is executed: its sentences parse, and changed by one symbol they do not crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>

#include "tests/dialects/grammar.h"
#include "transpiler/dialects/classicladder/classicladder.h"
#include "transpiler/dialects/classicladder/parser/parser.h"

namespace plcxx::classicladder {
namespace {

using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("classicladder");
  return grammar;
}

std::string Special(const std::string& name, Numbers& numbers) {
  if (name == "line end") return numbers.OneIn(2) ? "\r\n" : "\n";
  if (name == "digit") return std::string(1, static_cast<char>('0' + numbers.Below(10)));
  constexpr const char* kCharacters[] = {"a", "Z", " ", "7", ";", "-", ".", "\t", "="};
  return kCharacters[numbers.Below(std::size(kCharacters))];
}

std::string SentenceOf(uint64_t seed) {
  Numbers numbers(seed);
  std::string text;
  for (const std::string& terminal : TheGrammar().Sentence(numbers, Special)) text += terminal;
  return text;
}

/// "1:1 classicladder-1 ..." of every error.
std::vector<std::string> ErrorsOf(const std::string& text) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  const source::FileId files[] = {sources.AddText("a.clp", text)};
  const Program program = Parse(sources, files, {}, diagnostics);
  EXPECT_THAT(PrintSyntax(sources, program), testing::StartsWith("size numRungs 100\n"));
  PrintTokens(sources, files[0]);
  std::vector<std::string> errors;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity != diag::Severity::kError) continue;
    const source::Position place = sources.Locate(diagnostic.range.begin);
    errors.push_back(std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                     std::string(diagnostic.row->code) + " " + diagnostic.text);
  }
  return errors;
}

TEST(ClassicladderGrammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(ClassicladderGrammar, EveryProductionHasAReader) {
  const std::string front_end = testing_support::FrontEndOf("classicladder");
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(front_end.find(definition), std::string::npos) << name << " is read by " << definition;
  }
}

// covers: CLASSICLADDER-002
TEST(ClassicladderGrammar, SentencesParse) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    const std::string text = SentenceOf(seed);
    ASSERT_THAT(ErrorsOf(text), testing::IsEmpty()) << text;
  }
}

TEST(ClassicladderGrammar, ChangedByOneSymbolTheyDoNotCrash) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Numbers numbers(seed);
    std::string text = SentenceOf(seed);
    if (!text.empty()) text[numbers.Below(text.size())] = static_cast<char>(numbers.Below(256));
    ErrorsOf(text);
  }
}

}  // namespace
}  // namespace plcxx::classicladder
