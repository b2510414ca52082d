#include "transpiler/dialects/prostep/parser/parser.h"

#include "tests/dialects/prostep_parsing.h"

namespace plcxx::prostep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> ItemsInModule(const std::string& lines) {
  std::vector<std::string> items = ItemsOf(InModule(lines));
  EXPECT_EQ(items.front(), "module PM 20");
  EXPECT_EQ(items.back(), "end");
  return {items.begin() + 1, items.end() - 1};
}

TEST(ProstepParser, Operands) {
  EXPECT_THAT(ItemsInModule(":A I 10.1\n:on\tc5\n:=P11.7\n:S  F 255.0 x\n:R T 063\n:LD C 0\n:T DW 998\n:L PB 131"),
              ElementsAre("A I 10.1", "ON C 5", "= P 11.7", "S F 255.0", "R T 63", "LD C 0", "T DW 998", "L PB 131"));
}

TEST(ProstepParser, TheOperandDecidesTheMeaning) {
  Parsed parsed;
  ParseInto(parsed, {InModule(":S I 0.0\n:S C 1\n:K 5D\n:R C 1\n:R T 1\n:O\n:O T 1\n:L C 1\n:L T 1\n:L DB 1\n:L\n:K 1\n"
                              ":JU PM 21\n:JU FM 4\n:JU X\nX:NOP") +
                     ":MOD PM 21\n:END PM 21\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  std::vector<Op> ops;
  for (const Instruction& instruction : parsed.program.instructions) ops.push_back(instruction.op);
  EXPECT_THAT(ops, ElementsAre(Op::kSet, Op::kSetCounter, Op::kResetCounter, Op::kResetTimer, Op::kOrString, Op::kOr,
                               Op::kLoadCounter, Op::kLoadTimer, Op::kLoad, Op::kLoad, Op::kCall, Op::kPerform,
                               Op::kJump, Op::kNop));
  const Program& program = parsed.program;
  EXPECT_EQ(program.instructions[InstructionId(10)].module, ModuleId(1));
  EXPECT_EQ(program.instructions[InstructionId(11)].function, Function::kToBcd);
  EXPECT_EQ(program.instructions[InstructionId(12)].target, LabelId(0));
  EXPECT_EQ(program.labels[LabelId(0)].at, InstructionId(13));
}

TEST(ProstepParser, Constants) {
  EXPECT_THAT(ItemsInModule(":L\n:K 12D\n:L\n:K 12H\n:L\n: K18\n:L\n:K -1\n:L\n:K 12DH\n:L\n:K 0ffffh\n:L\n:K-32768"),
              ElementsAre("L K 18", "L K 18", "L K 18", "L K 65535", "L K 301", "L K 65535", "L K 32768"));
}

TEST(ProstepParser, OperandLines) {
  EXPECT_THAT(ItemsInModule(":SP T 5 start\n\n; half\n:   ; nothing\nfree text\n: K 2050D czas\n:!=\n:DB 20"),
              ElementsAre("SP T 5 [K 8272]", "!= DB 20"));
  EXPECT_THAT(ItemsInModule(":JU FM 3\n:IB 4\n:K 3\n:DB 4\n:JC FM 15\n:OB 255\n:PW 22\n:JU FM 70\n:FW 252\n:DW 996"),
              ElementsAre("JU FM 3 Divide [IB 4] [K 3] [DB 4]", "JC FM 15 ReadByte [OB 255] [PW 22]",
                          "JU FM 70 MoveLong [FW 252] [DW 996]"));
}

TEST(ProstepParser, TwoOperandsOfFm64) {
  EXPECT_THAT(ItemsInModule(":JU FM 64\n:DB 0\n:DB 4\n:JU FM 65\n:DB 0\n:DB 4\n:DB 8"),
              ElementsAre("JU FM 64 AndLong [DB 0] [DB 4] [DB 4]", "JU FM 65 OrLong [DB 0] [DB 4] [DB 8]"));
}

TEST(ProstepParser, SynonymsAreOneFunction) {
  EXPECT_THAT(ItemsInModule(":JU FM 30\n:DB 0\n:DB 4\n:DB 8\n:JU FM 75\n:DB 0\n:JU FM 34\n:DB 0\n:DB 4"),
              ElementsAre("JU FM 30 AddLong [DB 0] [DB 4] [DB 8]", "JU FM 75 NegateLong [DB 0]",
                          "JU FM 34 MoveLong [DB 0] [DB 4]"));
}

TEST(ProstepParser, Labels) {
  EXPECT_THAT(
      ItemsInModule("A:\nB1.#x : ; note\n  c:A I 0.0\n:JC end\n:JU A\n:JC B1.#X\n:JU C\nEND:"),
      ElementsAre("label A", "label B1.#X", "label C", "A I 0.0", "JC END", "JU A", "JC B1.#X", "JU C", "label END"));
  EXPECT_THAT(ItemsOf(":MOD PM 20\n:JU X\nX:END PM 20\n"), ElementsAre("module PM 20", "JU X", "label X", "end"));
  EXPECT_THAT(ItemsInModule("DT1 :A I 0.0\n:JU DT1"), ElementsAre("label DT1", "A I 0.0", "JU DT1"));
}

TEST(ProstepParser, LabelsBelongToTheirModule) {
  Parsed parsed;
  ParseInto(parsed, {":MOD PM 1\nX:NOP\n:JU X\n:END PM 1\n:MOD PM 2\n:JU X\nX:NOP\n:END PM 2\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_EQ(parsed.program.instructions[InstructionId(1)].target, LabelId(0));
  EXPECT_EQ(parsed.program.instructions[InstructionId(2)].target, LabelId(1));
}

TEST(ProstepParser, Modules) {
  Parsed parsed;
  ParseInto(parsed, {"DDB 1 2\n:MOD PM 09\n:END PM 9\n\x1A:x", "%PLC\n:mod pm0 x\n:NOP\n:end pm0\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  const Program& program = parsed.program;
  ASSERT_EQ(program.modules.size(), 2u);
  EXPECT_EQ(program.module_of[9], ModuleId(0));
  EXPECT_EQ(program.module_of[0], ModuleId(1));
  EXPECT_EQ(program.modules[ModuleId(0)].file, parsed.files[0]);
  EXPECT_EQ(program.modules[ModuleId(1)].instructions.count, 1u);
  EXPECT_EQ(program.statement_count, 1u);
  EXPECT_EQ(program.line_count, 7u);
}

std::string CommentsOf(const Parsed& parsed, Span span) {
  std::string text;
  for (uint32_t i = 0; i < span.count; ++i) {
    const Comment& comment = parsed.program.comments[span.first + i];
    text += comment.blank_line_before ? "/" : "";
    text += comment.place == CommentPlace::kLeading ? "<" : comment.place == CommentPlace::kInside ? "=" : ">";
    text += parsed.sources.Text(comment.range);
  }
  return text;
}

TEST(ProstepParser, Comments) {
  Parsed parsed;
  ParseInto(parsed, {"; a\n\nb\nDDB 1 2 c\n; d\n:MOD PM 1 e\n f\n\n: ; g\nX:\n:A I 0.0;h\n:L ;i\n; j\n:K 1 k\n;l\n"
                     ":END PM 1 m\n; n\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  const Program& program = parsed.program;
  EXPECT_EQ(CommentsOf(parsed, program.files[0].header), "<; a");
  EXPECT_EQ(CommentsOf(parsed, program.data[0].comments), "/<b>c");
  const Module& module = program.modules[ModuleId(0)];
  EXPECT_EQ(CommentsOf(parsed, module.comments), "<; d>e");
  EXPECT_EQ(CommentsOf(parsed, program.instructions[InstructionId(0)].comments), "<f/<; g>;h");
  EXPECT_EQ(CommentsOf(parsed, program.instructions[InstructionId(1)].comments), "=;i=; j>k");
  EXPECT_EQ(CommentsOf(parsed, module.end_comments), "<;l>m");
  EXPECT_EQ(CommentsOf(parsed, program.files[0].rest), "<; n");
}

TEST(ProstepParser, EveryLineEnd) {
  for (const std::string end : {"\n", "\r\n", "\r", "\n\r"}) {
    const std::string text = ":MOD PM 1" + end + end + "; x" + end + ":A X" + end + ":END PM 1";
    EXPECT_THAT(ErrorsOf(text), ElementsAre("4:4 E10"));
  }
  EXPECT_THAT(ErrorsOf(":MOD PM 1\r\n\r:NOP\n\r\n:A X\r:END PM 1"), ElementsAre("5:4 E10"));
}

TEST(ProstepParser, Mazovia) {
  Parsed parsed;
  ParseInto(parsed, {"DM 1 .Za\x92"
                     "\x86"
                     "cz\n; \x8F\n"});
  EXPECT_THAT(parsed.Errors(), IsEmpty());
  EXPECT_EQ(parsed.program.messages[0].text, "Załącz");
}

TEST(ProstepParser, ChosenEncodings) {
  const auto text_of = [](const std::string& bytes, source::Encoding encoding) {
    Parsed parsed;
    ParseInto(parsed, {"DM 1 ." + bytes + "\n"}, Checks::kParser, encoding);
    EXPECT_THAT(parsed.Errors(), IsEmpty());
    return parsed.program.messages[0].text;
  };
  EXPECT_EQ(text_of("Za\x88\xA5"
                    "cz",
                    source::Encoding::kCp852),
            "Załącz");
  EXPECT_EQ(text_of("Za\xB3\xB9"
                    "cz",
                    source::Encoding::kCp1250),
            "Załącz");
  EXPECT_EQ(text_of("Załącz", source::Encoding::kUtf8), "Załącz");
  EXPECT_EQ(text_of("\xC3\xB3", source::Encoding::kMazovia), "├│") << "chosen is chosen, valid UTF-8 or not";
}

TEST(ProstepParser, BytesThatAreWrongInTheChosenEncoding) {
  Parsed parsed;
  ParseInto(parsed, {"; \xFF\n;\n; \x81 ok\n"}, Checks::kParser, source::Encoding::kUtf8);
  EXPECT_THAT(parsed.Errors(), ElementsAre("1:3 E01", "3:3 E01"));
  Parsed code;
  ParseInto(code, {InModule(":A \x81 0.0")}, Checks::kParser, source::Encoding::kCp1250);
  EXPECT_THAT(code.Errors(), ElementsAre("2:4 E01"));
}

}  // namespace
}  // namespace plcxx::prostep
