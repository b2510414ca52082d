// The reference grammar is executed: its sentences parse, and changed by one symbol they do not crash.
#include <iterator>

#include "tests/dialects/grammar.h"
#include "tests/dialects/prostep_parsing.h"

namespace plcxx::prostep {
namespace {

using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("prostep");
  return grammar;
}

std::string Special(const std::string& name, Numbers& numbers) {
  constexpr const char* kCharacters[] = {"a", "Z", " ", "ł", "7", "(", ":", ";", "*", "%", "-", ".", "\t", "=", "ż"};
  const auto any = [&] { return std::string(kCharacters[numbers.Below(std::size(kCharacters))]); };
  if (name == "any") return any();
  if (name == "tab") return "\t";
  if (name == "ETX") return "\x03:A";
  if (name == "SUB") return "\x1A:A";
  if (name == "line end") {
    constexpr const char* kEnds[] = {"\n", "\r\n", "\n", "\r\n"};  // a mixture of all four joins with the next line's
    return kEnds[numbers.Below(std::size(kEnds))];
  }
  if (name == "label character") {
    constexpr std::string_view kLabel = "ABXYZ0189_.#(/=<";
    return std::string(1, kLabel[numbers.Below(kLabel.size())]);
  }
  std::string text = name == "free text" ? "Uwaga" : name == "no operand" ? "lub " : " ";
  for (uint64_t i = numbers.Below(9); i > 0; --i) {
    const std::string next = any();
    if (name == "text" || next != ":") text += next;
  }
  if (name == "free text") std::erase(text, ':');
  return text;
}

std::string Joined(const std::vector<std::string>& terminals) {
  std::string text;
  for (const std::string& terminal : terminals) text += terminal;
  return text;
}

/// What a grammar cannot say: agreement of numbers, names that exist, brackets in pairs.
bool IsBeyondGrammar(const diag::Diagnostic& diagnostic) {
  for (const std::string_view code : {"E06", "E13", "E14", "E15", "E18", "E20", "E21", "E22"}) {
    if (diagnostic.row->code.ends_with(code)) return true;
  }
  return diagnostic.row->key == diag::ProstepLabelReserved.row.key;
}

TEST(ProstepGrammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(ProstepGrammar, EveryProductionHasAReader) {
  const std::string front_end = testing_support::FrontEndOf("prostep");
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(front_end.find(definition), std::string::npos) << name << " is read by " << definition;
  }
}

TEST(ProstepGrammar, SentencesParse) {
  size_t instructions = 0;
  for (uint64_t seed = 0; seed < 3000; ++seed) {
    Numbers numbers(seed);
    const std::string text = Joined(TheGrammar().Sentence(numbers, Special));
    Parsed parsed;
    ParseInto(parsed, {text});
    instructions += parsed.program.instructions.size();
    for (const diag::Diagnostic& diagnostic : parsed.diagnostics.all()) {
      if (diagnostic.severity != diag::Severity::kError || IsBeyondGrammar(diagnostic)) continue;
      const source::Position place = parsed.sources.Locate(diagnostic.range.begin);
      ADD_FAILURE() << diagnostic.row->code << " " << diagnostic.text << " in line " << place.line << " of\n" << text;
      return;
    }
  }
  EXPECT_GT(instructions, 3000u) << "the sentences are too short to show anything";
}

TEST(ProstepGrammar, SmallLettersAreTheSame) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Numbers numbers(seed);
    const std::string text = Joined(TheGrammar().Sentence(numbers, Special));
    std::string lower = text;
    for (char& c : lower) {
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    EXPECT_EQ(ErrorsOf(text), ErrorsOf(lower)) << text;
  }
}

void ExpectWhole(const Parsed& parsed, const std::string& text) {
  const Program& program = parsed.program;
  uint32_t next = 0, next_label = 0;
  for (const Module& module : program.modules) {
    ASSERT_EQ(module.instructions.first, next) << text;
    ASSERT_EQ(module.labels.first, next_label) << text;
    next += module.instructions.count;
    next_label += module.labels.count;
  }
  ASSERT_EQ(next, program.instructions.size()) << text;
  ASSERT_EQ(next_label, program.labels.size()) << text;
  source::Offset last = 0;
  for (const Instruction& instruction : program.instructions) {
    ASSERT_GE(instruction.range.begin, last) << text;
    ASSERT_GE(instruction.whole.end, instruction.range.end) << text;
    ASSERT_TRUE(!instruction.faulty || parsed.diagnostics.HasErrors()) << text;
    ASSERT_LE(instruction.comments.first + instruction.comments.count, program.comments.size()) << text;
    ASSERT_LE(instruction.arguments.first + instruction.arguments.count, program.arguments.size()) << text;
    last = instruction.whole.end;
  }
}

TEST(ProstepGrammar, ChangedByOneSymbolTheTreeIsStillWhole) {
  for (uint64_t seed = 0; seed < 3000; ++seed) {
    Numbers numbers(seed + 1'000'000);
    std::vector<std::string> terminals = TheGrammar().Sentence(numbers, Special);
    if (terminals.empty()) continue;
    const auto at = static_cast<ptrdiff_t>(numbers.Below(terminals.size()));
    const std::string other = terminals[numbers.Below(terminals.size())];
    switch (numbers.Below(4)) {
      case 0:
        terminals.erase(terminals.begin() + at);
        break;
      case 1:
        terminals.insert(terminals.begin() + at, other);
        break;
      case 2:
        terminals[static_cast<size_t>(at)] = other;
        break;
      default:
        terminals[static_cast<size_t>(at)] = "\xFF";
        break;
    }
    const std::string text = Joined(terminals);
    Parsed parsed;
    ParseInto(parsed, {text}, Checks::kWholeProgram);
    ExpectWhole(parsed, text);
    EXPECT_FALSE(PrintSyntax(parsed.sources, parsed.program).empty() && !parsed.files.empty());
    for (const source::FileId file : parsed.files) PrintTokens(parsed.sources, file);
  }
}

}  // namespace
}  // namespace plcxx::prostep
