// The reference grammar is executed: its sentences parse, and changed by one symbol they do not crash.

#include "tests/dialects/grammar.h"
#include "tests/dialects/host50_parsing.h"

namespace plcxx::host50 {
namespace {

using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("host50");
  return grammar;
}

/// What the names of the sentences stand for.
constexpr const char* kSymbols =
    "SYMBOLS\n%I1900 START\n%Q1901 'axis4-'\n%B1902 泵\n%W299 COUNT.x\n%QF299 f_1\n%TM99 T_RUN\n%C99 "
    "PARTS\nEND_SYMBOLS\n";

std::string Chosen(Numbers& numbers, std::initializer_list<const char*> texts) {
  return *(texts.begin() + static_cast<ptrdiff_t>(numbers.Below(texts.size())));
}

std::string Special(const std::string& name, Numbers& numbers) {
  const auto any = [&] {
    return Chosen(numbers, {"a", "Z", " ", "泵", "7", "(", ";", "'", "%", "-", ".", "=", "\"", "|"});
  };
  if (name == "any") return any();
  if (name == "tab") return "\t";
  if (name == "continuation") return numbers.OneIn(4) ? " \\ \n" : " ";
  if (name == "line end") return Chosen(numbers, {"\n", "\r\n"});
  if (name == "bit symbol")
    return Chosen(numbers, {"START ", "'axis4-'", "axis4-", "泵 ", "T_RUN", "T_RUN.Q", "PARTS.q"});
  if (name == "output symbol") return Chosen(numbers, {"axis4-", "'axis4-'", "'泵'"});
  if (name == "word symbol") return Chosen(numbers, {"COUNT.x", "'COUNT.x'"});
  if (name == "float symbol") return Chosen(numbers, {"f_1", "'f_1'"});
  if (name == "timer symbol") return Chosen(numbers, {"T_RUN", "'T_RUN'"});
  if (name == "counter symbol") return Chosen(numbers, {"PARTS", "'PARTS'"});
  if (name == "plain symbol") {
    return Chosen(numbers, {"START", "'axis4-'", "f_1", "T_RUN.V", "'PARTS'.P", "PARTS", "'COUNT.x'"});
  }
  if (name == "new symbol") {
    std::string text = Chosen(numbers, {"N", "_", "ß", "号"});
    for (uint64_t i = 4 + numbers.Below(9); i > 0; --i)
      text += Chosen(numbers, {"a", "7", "_", "+", "-", "/", ".", "#", "号"});
    return numbers.OneIn(3) ? "'" + text + "'" : text;
  }
  if (name == "row") {
    return Chosen(numbers, {"  |--[ %I0 ]--[/START]--( %Q0 ) ; row", "  |", "", "; alone", "  |--{TONS %TM90, 5}",
                            "  |--[P 泵 ]--{MOV 1, %W0}--(S 'axis4-' )", "  |--{COMP \"%W0 & 1 = 1\"}--(R %Q1)",
                            "  |--{CNUD %C1, 8, P=0, M=!%I1, N=1}"});
  }
  std::string text = name == "text" ? "x" : any();
  for (uint64_t i = numbers.Below(9); i > 0; --i) text += any();
  if (name == "string character") std::erase(text, '"');
  return text;
}

std::string Joined(const std::vector<std::string>& terminals) {
  std::string text;
  for (const std::string& terminal : terminals) text += terminal;
  return text;
}

/// What a grammar cannot say: the state of the rung, what exists, what exists once, types of expressions.
bool IsBeyondGrammar(const diag::Diagnostic& diagnostic) {
  const std::string_view code = diagnostic.row->code.substr(diagnostic.row->code.find('-') + 1);
  for (const std::string_view beyond :
       {"E302", "E303", "E304", "E305", "E306", "E307", "E308", "E309", "E404", "E501", "E502", "E504"}) {
    if (code == beyond) return true;
  }
  return code.starts_with("E20") || diagnostic.row->key == diag::Host50DirectiveTwice.row.key;
}

TEST(Host50Grammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(Host50Grammar, EveryProductionHasAReader) {
  const std::string front_end = testing_support::FrontEndOf("host50");
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(front_end.find(definition), std::string::npos) << name << " is read by " << definition;
  }
}

TEST(Host50Grammar, SentencesParse) {
  size_t instructions = 0;
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    Numbers numbers(seed);
    const std::string text = Joined(TheGrammar().Sentence(numbers, Special));
    Parsed parsed;
    ParseInto(parsed, {text, kSymbols});
    instructions += parsed.program.instructions.size();
    for (const diag::Diagnostic& diagnostic : parsed.diagnostics.all()) {
      if (diagnostic.severity != diag::Severity::kError || IsBeyondGrammar(diagnostic)) continue;
      const source::Position place = parsed.sources.Locate(diagnostic.range.begin);
      ADD_FAILURE() << diagnostic.row->code << " " << diagnostic.text << " in line " << place.line << " of\n" << text;
      return;
    }
  }
  EXPECT_GT(instructions, 1000u) << "the sentences are too short to show anything";
}

TEST(Host50Grammar, SmallLettersAreTheSame) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Numbers numbers(seed);
    std::vector<std::string> terminals = TheGrammar().Sentence(numbers, Special);
    const std::string text = Joined(terminals);
    for (std::string& terminal : terminals) {
      const auto holds = [&](const char* name) { return terminal.find(name) != std::string::npos; };
      if (holds("START") || holds("RUN") || holds("PARTS") || holds("COUNT")) continue;  // names differ
      for (char& c : terminal) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
      }
    }
    Parsed large, small;
    ParseInto(large, {text, kSymbols});
    ParseInto(small, {Joined(terminals), kSymbols});
    EXPECT_EQ(large.Errors(), small.Errors()) << text;
  }
}

void ExpectInside(const Span& span, size_t size, const std::string& text) {
  ASSERT_LE(size_t{span.first} + span.count, size) << text;
}

void ExpectWhole(const Parsed& parsed, const std::string& text) {
  const Program& program = parsed.program;
  ASSERT_EQ(program.faulty, parsed.diagnostics.HasErrors()) << text;
  uint32_t next = 0, next_network = 0;
  for (const Section& section : program.sections) {
    ASSERT_EQ(section.networks.first, next_network) << text;
    next_network += section.networks.count;
  }
  ASSERT_EQ(next_network, program.networks.size()) << text;
  for (const Network& network : program.networks) {
    ASSERT_EQ(network.instructions.first, next) << text;
    next += network.instructions.count;
    for (uint32_t i = network.instructions.first; i < next; ++i) {
      const Instruction& instruction = program.instructions[InstructionId(i)];
      ExpectInside(instruction.operands, program.operands.size(), text);
      ExpectInside(instruction.pins, program.pins.size(), text);
      ExpectInside(instruction.comments, program.comments.size(), text);
      ExpectInside(instruction.input.results, program.results.size(), text);
      ASSERT_TRUE(!instruction.faulty || program.faulty) << text;
      for (uint32_t r = 0; r < instruction.input.results.count; ++r) {
        const InstructionId result = program.results[instruction.input.results.first + r];
        ASSERT_TRUE(result.index >= network.instructions.first && result.index < i) << text;
      }
    }
  }
  ASSERT_EQ(next, program.instructions.size()) << text;
  for (uint32_t i = 0; i < program.exprs.size(); ++i) {
    const Expr& expr = program.exprs[ExprId(i)];
    ASSERT_TRUE(!expr.left.valid() || expr.left.index < i) << text;
    ASSERT_TRUE(!expr.right.valid() || expr.right.index < i) << text;
  }
}

TEST(Host50Grammar, ChangedByOneSymbolTheTreeIsStillWhole) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
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
    ParseInto(parsed, {text, kSymbols});
    ExpectWhole(parsed, text);
    EXPECT_FALSE(PrintSyntax(parsed.sources, parsed.program).empty());
    for (const source::FileId file : parsed.program.files) PrintTokens(parsed.sources, file);
  }
}

}  // namespace
}  // namespace plcxx::host50
