// The reference grammar is executed: its sentences parse, and changed by one symbol they do not crash.
#include <set>

#include "tests/dialects/grammar.h"
#include "tests/dialects/technol_parsing.h"
#include "transpiler/dialects/technol/source/lexer.h"

namespace plcxx::technol {
namespace {

using testing_support::Grammar;
using testing_support::Numbers;

const Grammar& TheGrammar() {
  static const Grammar grammar = testing_support::GrammarOf("technol");
  return grammar;
}

/// What the sentences may refer to. Its END is that of the prolog.
constexpr std::string_view kDefinitions =
    "POLOZKA STRUC\nF1 DB 1\nF2 DW 2\nPOLOZKA ENDS\nEQUI KONST,5\n"
    "NASTAV MACRO CO,KAM\nNOP\nENDM\n"
    "SKUPINA MACRO\nLOCAL SK\nSK: DB 1\nENDM\n"
    "DATA\nBITY: DFM BIT,BIT2\nBAJT: DS 1\nSLOVO: DS 2\nPOLE: DS 50\nDATA_END\n"
    "MECH_BEGIN MECH\nMECH_END MECH\n";

/// The texts between question marks. New names are never used, closing names are those that were opened last.
class Texts {
 public:
  std::string operator()(const std::string& name, Numbers& numbers) {
    const auto one_of = [&numbers](std::initializer_list<const char*> texts) {
      return std::string(texts.begin()[numbers.Below(texts.size())]);
    };
    if (name == "new name") return one_of({"N", "_n", "@X", "?a"}) + std::to_string(++count_);
    if (name == "open structure") return structure_ = "S" + std::to_string(++count_);
    if (name == "close structure") return structure_;
    if (name == "open module") return module_ = "MODULE_M" + std::to_string(++count_);
    if (name == "close module") return module_ + "_END";
    if (name == "open mechanism") return mechanism_ = "MECH" + std::to_string(++count_);
    if (name == "close mechanism") return mechanism_;
    if (name == "text") return one_of({"Seite 5", "", "x ** y", "; nic", "LDR"});
    if (name == "file") return one_of({"X.INC", "..\\inc\\X.INC", "'x y.inc'", "\"x.inc\""});
    if (name == "system header") return one_of({"T_04.ASH", "INCLT.ash"});
    if (name == "string") return one_of({"'text'", "'a;b'", "'a,b'"});
    if (name == "number") return one_of({"0FFh", "1010b", "17q", "5d", "'A'", "0Bh", "7O", "'''"});
    if (name == "label") return one_of({"LABEL1", "LABEL2"});
    if (name == "mechanism") return "MECH";
    if (name == "bit") return one_of({"BIT", "BIT2", "REQ_CLOSE_ALL", "UPS_OFF"});
    if (name == "byte cell") return one_of({"BAJT", "IN5", "OUT63", "MATTL"});
    if (name == "word cell") return "SLOVO";
    if (name == "field") return one_of({"F1", "F2", "TCH_AKTIV", "KONST"});
    if (name == "area") return one_of({"LABEL_MEM", "TAB_TECHNOL", "POLE"});
    if (name == "argument") return one_of({"BI", "", "(A,B)", "'a,b'"});
    EXPECT_EQ(name, "line end");
    return one_of({"\n", " ; Kommentar, č\n", "\r\n", "\t\n"});
  }

 private:
  uint32_t count_ = 0;
  std::string structure_, module_, mechanism_;
};

std::vector<std::string> SentenceOf(Numbers& numbers) {
  Texts texts;
  return TheGrammar().Sentence(numbers, [&texts](const std::string& name, Numbers& more) { return texts(name, more); });
}

/// Blanks where words would run together, and now and then elsewhere.
std::string Joined(const std::vector<std::string>& terminals, Numbers& numbers) {
  std::string text(kDefinitions);
  for (const std::string& terminal : terminals) {
    const bool words = !terminal.empty() && IsNameCharacter(text.back()) &&
                       (IsNameCharacter(terminal.front()) || terminal.front() == '\'' || terminal.front() == '.');
    const bool path = text.ends_with("INCLUDE");
    if (words || path || numbers.OneIn(4)) text += numbers.OneIn(4) ? "\t " : " ";
    text += terminal;
  }
  return text;
}

/// What a grammar cannot say: agreement of names, of widths, of ranges.
bool IsBeyondGrammar(const diag::Diagnostic& diagnostic) {
  static const std::set<std::string_view> codes = {"technol-TE006", "technol-TE007", "technol-TE010", "technol-TE015",
                                                   "technol-TE017", "technol-TE022", "technol-TE031", "technol-TE032",
                                                   "technol-TE033", "technol-TE041", "technol-TE042", "technol-TE052",
                                                   "technol-TE068", "technol-TE069", "technol-TE073"};
  return codes.contains(diagnostic.row->code);
}

TEST(TechnolGrammar, IsWhole) { EXPECT_THAT(TheGrammar().Problems(), testing::IsEmpty()); }

TEST(TechnolGrammar, EveryProductionHasAReader) {
  const std::string front_end = testing_support::FrontEndOf("technol");
  for (const std::string& name : TheGrammar().Names()) {
    const std::string definition = TheGrammar().ReaderOf(name) + "(";
    EXPECT_NE(front_end.find(definition), std::string::npos) << name << " is read by " << definition;
  }
}

TEST(TechnolGrammar, SentencesParse) {
  size_t instructions = 0;
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Numbers numbers(seed);
    const std::vector<std::string> terminals = SentenceOf(numbers);
    const std::string text = Joined(terminals, numbers);
    Parsed parsed;
    ParseInto(parsed, {text});
    instructions += parsed.program.statement_count;
    for (const diag::Diagnostic& diagnostic : parsed.diagnostics.all()) {
      if (diagnostic.severity != diag::Severity::kError || IsBeyondGrammar(diagnostic)) continue;
      const source::Position place = parsed.sources.Locate(diagnostic.range.begin);
      ADD_FAILURE() << diagnostic.row->code << " " << diagnostic.text << " in line " << place.line << " of\n" << text;
      return;
    }
  }
  EXPECT_GT(instructions, 3000u) << "the sentences are too short to show anything";
}

void ExpectWhole(const Parsed& parsed, const std::string& text) {
  const Program& program = parsed.program;
  ASSERT_GE(program.units.size(), 1u) << text;
  uint32_t labels = 0;
  for (uint32_t i = 0; i < program.instructions.size(); ++i) {
    const Instruction& instruction = program.instructions[InstructionId(i)];
    ASSERT_LT(instruction.unit.index, program.units.size()) << text;
    ASSERT_LE(instruction.operands.first + instruction.operands.count, program.operands.size()) << text;
    ASSERT_LE(instruction.comments.first + instruction.comments.count, program.comments.size()) << text;
    ASSERT_TRUE(!instruction.faulty || parsed.diagnostics.HasErrors()) << text;
    labels += instruction.labels.count;
  }
  ASSERT_EQ(labels, program.labels.size()) << text;
  for (const Label& label : program.labels) {
    ASSERT_LT(label.at.index, program.instructions.size()) << text;
    ASSERT_EQ(label.unit, program.instructions[label.at].unit) << text;
  }
  for (const Unit& unit : program.units) {
    ASSERT_LE(unit.first.index, unit.end.index) << text;
    if (unit.kind == UnitKind::kSubprograms) continue;
    const Op mark = unit.kind == UnitKind::kModule ? Op::kModuleEnd : Op::kMechanismEnd;
    ASSERT_EQ(program.instructions[unit.end].op, mark) << text;
  }
}

TEST(TechnolGrammar, ChangedByOneSymbolTheTreeIsStillWhole) {
  for (uint64_t seed = 0; seed < 400; ++seed) {
    Numbers numbers(seed + 1'000'000);
    std::vector<std::string> terminals = SentenceOf(numbers);
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
    const std::string text = Joined(terminals, numbers);
    Parsed parsed;
    ParseInto(parsed, {text});
    ExpectWhole(parsed, text);
    EXPECT_FALSE(PrintSyntax(parsed.sources, parsed.program).empty());
    for (const source::FileId file : parsed.request.files) PrintTokens(parsed.sources, file);
  }
}

}  // namespace
}  // namespace plcxx::technol
