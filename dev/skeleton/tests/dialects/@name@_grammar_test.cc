// The reference grammar is executed: its sentences parse, and changed by one symbol they do not crash.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iterator>

#include "tests/dialects/grammar.h"
#include "transpiler/dialects/@name@/parser/parser.h"
#include "transpiler/dialects/@name@/@name@.h"

namespace plcxx::@name@ {
namespace {

using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("@name@");
  return grammar;
}

std::string Special(const std::string& name, Numbers& numbers) {
  if (name == "line end") return numbers.OneIn(2) ? "\r\n" : "\n";
  constexpr const char* kCharacters[] = {"a", "Z", " ", "7", ";", "-", ".", "\t", "="};
  return kCharacters[numbers.Below(std::size(kCharacters))];
}

std::string SentenceOf(uint64_t seed) {
  Numbers numbers(seed);
  std::string text;
  for (const std::string& terminal : TheGrammar().Sentence(numbers, Special)) text += terminal;
  return text;
}

/// "1:1 @name@-1 ..." of every error.
std::vector<std::string> ErrorsOf(const std::string& text) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  const source::FileId files[] = {sources.AddText("a.@name@", text)};
  const Program program = Parse(sources, files, diagnostics);
  EXPECT_THAT(PrintSyntax(sources, program), testing::StartsWith("file a.@name@\n"));
  PrintTokens(sources, files[0]);
  std::vector<std::string> errors;
  for (const diag::Diagnostic& diagnostic : diagnostics.all()) {
    const source::Position place = sources.Locate(diagnostic.range.begin);
    errors.push_back(std::to_string(place.line) + ":" + std::to_string(place.column) + " " +
                     std::string(diagnostic.row->code) + " " + diagnostic.text);
  }
  return errors;
}

TEST(@Name@Grammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(@Name@Grammar, EveryProductionHasAReader) {
  const std::string front_end = testing_support::FrontEndOf("@name@");
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(front_end.find(definition), std::string::npos) << name << " is read by " << definition;
  }
}

TEST(@Name@Grammar, SentencesParse) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    const std::string text = SentenceOf(seed);
    ASSERT_THAT(ErrorsOf(text), testing::IsEmpty()) << text;
  }
}

TEST(@Name@Grammar, ChangedByOneSymbolTheyDoNotCrash) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Numbers numbers(seed);
    std::string text = SentenceOf(seed);
    if (!text.empty()) text[numbers.Below(text.size())] = static_cast<char>(numbers.Below(256));
    ErrorsOf(text);
  }
}

// covers: @NAME@-001
TEST(@Name@Parser, RefusesByName) {
  EXPECT_THAT(ErrorsOf("; text\n  SOMETHING 1 ; more\n"),
              testing::ElementsAre("2:3 @name@-1 'SOMETHING' is not supported yet: dialect @name@ is being built"));
}

}  // namespace
}  // namespace plcxx::@name@
