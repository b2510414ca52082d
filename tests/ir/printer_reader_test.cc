// The text form: what is printed is read back, and what is wrong is refused with its line.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "transpiler/ir/builder.h"
#include "transpiler/ir/printer.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/verifier.h"

namespace plcxx::ir {
namespace {

constexpr std::string_view kEverything = R"(program "two words" nc110
space A 32 volatile little host_visible arrays part_of ALL 64 "package A: \"in\" and out"
zone A 0 4 input
zone A 4 8 output
zone A bits 38 40 input
constant A 5 6
constant A 8 20
initial A 5 0xf
space T 64 retentive big
space locals 8 routine little
state T5 on_delay_timer
state C5 ring_counter
state K1 text_flag
state INBOX text_inbox
place U4A8 bit A[4].0 address %U4A8
place "odd name" i8 A[3]
place ROW i8 A[8] stride 2 low 8 high 28 indexed
place T5U bit field T5 done
place slice i32 locals[0]
place slice~2 i32 locals[4] named slice
host fault (kind : i8 = (LOW, HIGH), index : i32) -> i16 writes_state in A "what it is"
host now () -> i32 routine_exchange
text "START"
statement s1f subject U4A8 opens
statement s1f~2 subject "a b"
statement s20 closes
routine sub subroutine (n : i32 = slice) -> i32 slice~2 file "of\nthe file\n\n" "twice\n\nand once" {
  %0 = load slice
  %1 = add.i32 %0 %0
  store slice~2 %1
}
routine slow slow (slice : i32 = slice) sliced slices 4 {
  prologue {
    text.update K1 INBOX "START"
  }
  body {
    stmt s1f ; U4A8
    %0 = load U4A8
    if %0 {
      stmt s1f~2 ; "a b"
      %0 = const i8 0x33
      %1 = const i32 12
      store ROW[%1] %0
      %2 = load ROW[%1]
    } else {
      %3 = poison bit
      jump L1 if %3
      jump L2
    }
    label L1
    label L2
    stmt s20
    %0 = load T5U
    %1 = not.bit %0
    %2 = const i32 5
    step.on_delay T5 %1 %2 %2
    %3 = const i16 3
    %4 = step.count_slow C5 %1 %3 %2
    block @1 {
      exit @1 if %1
      loop @2 budget 100 slice {
        condition {
          %5 = load U4A8
        }
        body {
          exit @1
          exit @2 if %s1f.0
        }
        exhausted {
          %6 = const i8 0
          %7 = host fault (%6, %2)
        }
      }
    }
    switch %2 {
      case 0 0x1 12 falls_through {
      }
      default {
        %8 = call sub (%2)
      }
    }
  }
}
schedule init sub
schedule period_ms 20
schedule slow_done slice
text_inbox INBOX
message_bits A 4 first 1 count 8
message_word "odd name"
message 9 colour 2 "spindle \x01 stopped\n"
menu_text 1 colour 0 "OFF"
table modes (number : i16, name : none) "M functions"
row 3 "spindle \"on\"; clockwise"
row 300 ""
)";

TEST(Text, EverythingComesBack) {
  const auto result = Read(kEverything);
  if (const auto* error = std::get_if<ReadError>(&result)) FAIL() << "line " << error->line << ": " << error->message;
  EXPECT_EQ(Print(std::get<Program>(result)), kEverything);
}

TEST(Text, ReadMeansWhatItSays) {
  const Program program = ReadOrDie(kEverything);
  EXPECT_EQ(program.name, "two words");
  EXPECT_EQ(program.spaces[SpaceId(0)].title, "package A: \"in\" and out");
  EXPECT_EQ(program.places[PlaceId(0)].address, "%U4A8");
  EXPECT_EQ(program.places[PlaceId(0)].bit, 0);
  EXPECT_EQ(program.places[PlaceId(5)].name, "slice");
  EXPECT_EQ(program.statements[StatementId(1)].id, 0x1Fu);
  EXPECT_TRUE(program.statements[StatementId(0)].opens_block);
  EXPECT_EQ(program.routines[RoutineId(0)].file_comment, "of\nthe file\n\n");
  EXPECT_EQ(program.routines[RoutineId(0)].comment, "twice\n\nand once");
  EXPECT_EQ(program.routines[RoutineId(1)].slices, 4);
  EXPECT_EQ(program.loops[LoopId(0)].kind, LoopBound::kBudget);
  EXPECT_EQ(program.messages[0].text, "spindle \x01 stopped\n");
  EXPECT_EQ(program.tables[0].texts[program.tables[0].cells[1]], "spindle \"on\"; clockwise");
  EXPECT_EQ(program.tables[0].cells[2], 300u);
}

TEST(Text, ShortTextsAreEnough) {
  const Program program = ReadOrDie(R"(
    space m 1 volatile little      ; comment
    place a bit m[0].0

    routine fast fast {
      stmt s1
      %lamp = load a
      store a %lamp
    })");
  EXPECT_EQ(program.statements.size(), 1u);
  EXPECT_THAT(Print(program), testing::HasSubstr("  %0 = load a\n  store a %0\n"));
}

TEST(Text, RoutinesCallRoutinesFurtherDown) {
  const Program program = ReadOrDie("routine fast fast {\n call sub ()\n}\nroutine sub subroutine {\n}\n");
  EXPECT_EQ(program.calls[CallId(0)].routine, RoutineId(1));
}

TEST(Text, AnInsertedStatementChangesItsOwnLinesOnly) {
  const auto build = [](int extra) {
    Program program;
    Builder builder(program);
    const SpaceId space = program.spaces.Add({.name = "m", .bytes = 1});
    const PlaceId place = program.places.Add({.name = "a", .space = space, .bit = 0});
    builder.SetRegion(builder.NewRegion());
    program.routines.Add({.name = "fast", .kind = RoutineKind::kFast, .body = builder.region()});
    for (int i = extra; i < 3; ++i) {
      builder.Statement(program.statements.Add({.id = static_cast<uint32_t>(i + 7)}));
      builder.Store(place, builder.Load(place));
    }
    return Print(program);
  };
  std::string longer = build(0);
  for (const std::string_view lines : {"statement s7\n", "  stmt s7\n  %0 = load a\n  store a %0\n"}) {
    const size_t at = longer.find(lines);
    ASSERT_NE(at, std::string::npos);
    longer.erase(at, lines.size());
  }
  EXPECT_EQ(longer, build(1));
}

TEST(Text, DamagedTextsAreRefusedOrReadNeverMore) {
  std::mt19937 random(815);
  for (int round = 0; round < 1000; ++round) {
    std::string text(kEverything);
    for (int i = 0; i <= round % 3; ++i) {
      const size_t at = random() % text.size(), length = 1 + random() % 12;
      if (random() % 2 == 0) {
        text.erase(at, length);
      } else {
        text.insert(at, text.substr(random() % text.size(), length));
      }
    }
    const auto result = Read(text);
    if (const Program* program = std::get_if<Program>(&result)) {
      Verify(*program, Stage::kLowered);
      const std::string printed = Print(*program);
      EXPECT_EQ(Print(ReadOrDie(printed)), printed) << text;
    }
  }
}

struct Wrong {
  std::string_view text;
  uint32_t line;
  std::string_view message;
};

TEST(Text, WhatIsWrongIsRefusedWithItsLine) {
  const Wrong cases[] = {
      {"hello\n", 1, "declaration expected, found 'hello'"},
      {"\n\nspace A 3x volatile little\n", 3, "number expected, found '3x'"},
      {"space A 3 forever little\n", 1, "lifetime expected, found 'forever'"},
      {"space A 3 volatile little big\n", 1, "'big' is too much on this line"},
      {"place p bit A[0].0\n", 1, "unknown space 'A'"},
      {"space A 1 volatile little\nspace A 1 volatile little\n", 2, "space 'A' is declared twice"},
      {"space A 1 volatile little \"x\n", 1, "string without end, or with an unknown escape"},
      {"state T5 egg_timer\n", 1, "unknown kind of state 'egg_timer'"},
      {"state T5 on_delay_timer\nplace p bit field T5 dead\n", 2, "unknown field 'dead'"},
      {"routine f fast {\n", 1, "'{' without '}'"},
      {"routine f fast {\n  fly %0\n}\n", 2, "unknown operation 'fly'"},
      {"routine f fast {\n  %1 = not.bit %0\n}\n", 2, "unknown value '%0'"},
      {"routine f fast {\n  const bit 1\n}\n", 2, "the result needs a name: '%0 = '"},
      {"routine f fast {\n  %0 = label L1\n}\n", 2, "this operation has no result"},
      {"routine f fast {\n  %0 = const bit 1\n  %0 = const bit 0\n}\n", 3, "value '%0' is defined twice"},
      {"routine f fast {\n  exit @1\n}\n", 2, "no block or loop '@1' around this"},
      {"routine f fast {\n  jump 7\n}\n", 2, "label expected, found '7'"},
      {"routine f fast {\n  stmt x\n}\n", 2, "statement expected (s and a hexadecimal number), found 'x'"},
      {"routine f fast {\n  stmt s1\n  body {\n  }\n}\n", 5, "instructions beside prologue, body, epilogue"},
      {"table t (a : i8, b : none)\nrow 1 2\n", 2, "text in quotation marks expected in column 'b'"},
      {"table t (a : i8, b : none)\nrow 1\n", 2, "text in quotation marks expected in column 'b'"},
      {"table t (a : i8, b : none)\nrow \"x\" \"y\"\n", 2, "number expected, found 'x'"},
      {"row 1\n", 1, "row without a table"},
      {"schedule noon\n", 1, "unknown entry of the schedule 'noon'"},
  };
  for (const Wrong& wrong : cases) {
    const auto result = Read(wrong.text);
    ASSERT_TRUE(std::holds_alternative<ReadError>(result)) << wrong.text;
    EXPECT_EQ(std::get<ReadError>(result).line, wrong.line) << wrong.text;
    EXPECT_EQ(std::get<ReadError>(result).message, wrong.message) << wrong.text;
  }
}

}  // namespace
}  // namespace plcxx::ir
