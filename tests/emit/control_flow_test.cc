// Blocks, exits, budgeted loops and named locals as C++: read, and run beside the simulator.

#include <gmock/gmock.h>

#include "tests/emit/emitted_program.h"

namespace plcxx::emit {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::string_view kMemory = R"(space m 16 volatile little host_visible
space r 32 routine little
place a bit m[0].0
place b bit m[0].1
place c bit m[0].2
place d bit m[1].0
place n i8 m[2]
place k i8 m[3]
place left i32 m[4]
place total i32 m[8]
place w i16 m[12]
place s bit r[0].0
place ax i16 r[2]
place rounds i32 r[4]
place got i32 r[8]
place unread bit r[12].0
place slice i8 r[13]
place in i16 r[14]
place out_value i16 r[16]
host fault (kind : i8 = (LOW, HIGH), index : i32)
host nc_read (width : i8) -> bit out value : i32
host port (at : i8) -> bit
)";

const std::vector<std::string> kInputs = {"a", "b", "c", "n", "k", "left", "w"};

std::string Program(std::string_view routines) {
  return std::string(kMemory) + std::string(routines) + "schedule period period\n";
}

std::string Period(std::string_view body) { return Program("routine period schedule {\n" + std::string(body) + "}\n"); }

/// Runs in both flavours as simulated; gives the release text.
std::string RunProgram(const std::string& text) {
  const EmittedProgram program(text, kInputs);
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  return program.Source();
}

TEST(EmitBlocks, AnExitToTheEndOfTheRoutineReturns) {
  const std::string source = RunProgram(Period(R"(
  stmt s1 ; first
  %0 = load a
  block @1 {
    exit @1 if %0
    stmt s2
    %0 = load b
    store c %0
    exit @1 if %0
    stmt s3
    %0 = load n
    store k %0
  }
)"));
  EXPECT_THAT(source, HasSubstr("  if (m[a]) return;\n"));
  EXPECT_THAT(source, HasSubstr("  if (t102) return;\n"));
  EXPECT_THAT(source, Not(HasSubstr("goto")));
  EXPECT_THAT(source, Not(HasSubstr(":;")));
}

TEST(EmitBlocks, ElsewhereItGoesToALabelNamedAfterWhatFollows) {
  const std::string source = RunProgram(R"(statement s9 subject "O 1.0"
)" + Period(R"(
  stmt s1
  block @1 {
    stmt s2
    %0 = load a
    %1 = load b
    store b %0
    store c %1
    exit @1 if %0
    stmt s3
    %0 = load n
    store k %0
    %1 = load c
    store d %1
    store d %1
  }
  stmt s9
  %0 = load k
  store n %0
)"));
  EXPECT_THAT(source, HasSubstr("    if (t102) goto to_O_1_0;\n"));
  EXPECT_THAT(source, HasSubstr("  }\n\nto_O_1_0:;\n  // O 1.0\n"));
}

TEST(EmitBlocks, ABlockWithoutLocalsHasNoBraces) {
  const std::string source = RunProgram(Period(R"(
  stmt s1
  block @1 {
    stmt s2
    %0 = load a
    exit @1 if %0
    stmt s3
    %0 = load n
    store k %0
  }
  stmt s4
  %0 = load k
  store n %0
)"));
  EXPECT_THAT(source, HasSubstr("  if (m[a]) goto to_next;\n"));
  EXPECT_THAT(source, HasSubstr("  m[k] = m[n];\n\nto_next:;\n"));
}

TEST(EmitBlocks, NestedBlocksAndDeadStatements) {
  const std::string source = RunProgram(Period(R"(
  stmt s1
  %0 = load a
  %1 = load b
  block @1 {
    block @2 {
      exit @2 if %0
      stmt s2
      %0 = load c
      exit @1 if %0
      stmt s3
      %0 = load n
      %1 = const i8 3
      %2 = add.i8 %0 %1
      store k %2
      exit @1
      stmt s4
      %0 = load k
      store n %0
    }
    stmt s5
    %0 = load d
    if %0 {
      %1 = load a
      exit @1 if %1
      stmt s6
      %2 = load b
      store d %2
    } else {
      stmt s7
      %0 = load d
      %1 = not.bit %0
      store d %1
      exit @1
    }
    stmt s8
    %0 = const i8 9
    store n %0
  }
)"));
  EXPECT_THAT(source, HasSubstr("return;"));
  EXPECT_THAT(source, HasSubstr("goto to_next;"));
}

TEST(EmitBlocks, AnEpilogueIsNotJumpedOver) {
  const std::string source = RunProgram(Program(R"(routine period schedule {
  body {
    stmt s1
    %0 = load a
    block @1 {
      exit @1 if %0
      stmt s2
      %0 = load n
      store k %0
    }
  }
  epilogue {
    %0 = load total
    %1 = const i32 1
    %2 = add.i32 %0 %1
    store total %2
  }
}
)"));
  EXPECT_THAT(source, HasSubstr("  if (m[a]) goto to_end;\n"));
  EXPECT_THAT(source, Not(HasSubstr("return;")));
}

TEST(EmitBlocks, InALoopOrSwitchTheWordThatBindsIsTaken) {
  const std::string source = RunProgram(Period(R"(
  stmt s1
  %0 = load n
  %1 = const i32 3
  store left %1
  loop @1 guard 20 {
    body {
      stmt s2
      %0 = load k
      %1 = load a
      block @2 {
        exit @2 if %1
        stmt s3
        %0 = load k
        %1 = const i8 1
        %2 = add.i8 %0 %1
        store k %2
        switch %2 {
          case 4 {
            exit @1
          }
          case 5 6 {
            %3 = load b
            exit @2 if %3
            stmt s4
            %4 = load c
            store d %4
          }
          case 7 falls_through {
            %5 = load c
            exit @2 if %5
          }
          default {
            stmt s5
            %6 = load a
            store b %6
          }
        }
      }
    }
    exhausted {
      %0 = const i8 1
      %1 = const i32 77
      host fault (%0, %1)
    }
  }
  stmt s9
  %0 = load k
  store n %0
)"));
  EXPECT_THAT(source, HasSubstr("continue;"));
  EXPECT_THAT(source, HasSubstr("fault(host, fault_kind::HIGH, 77);\n"));
}

constexpr std::string_view kLoop = R"(
  stmt s1
  %0 = const i32 5
  store rounds %0
  stmt s2
  loop @1 budget 0 rounds {
    body {
      stmt s3 ; head
      %0 = load total
      %1 = const i32 1
      %2 = add.i32 %0 %1
      store total %2
      stmt s4
      %0 = load n
      %1 = const i8 3
      %2 = add.i8 %0 %1
      store n %2
      %3 = const i8 40
      %4 = ult.i8 %2 %3
      repeat @1 if %4 refused {
        %5 = const i8 0
        %6 = const i32 12
        host fault (%5, %6)
      }
      stmt s5
      %0 = load n
      store k %0
    }
  }
)";

TEST(EmitLoops, ABudgetIsCountedDownAndTheRefusalExecuted) {
  const std::string source = RunProgram(Period(kLoop));
  EXPECT_THAT(source, HasSubstr("  uint32_t rounds = 0;\n"));
  EXPECT_THAT(source, HasSubstr("  for (;;) {\n"));
  EXPECT_THAT(source, HasSubstr("      if (rounds != 0) {\n        --rounds;\n        continue;\n      }\n"
                                "      fault(host, fault_kind::LOW, 12);\n    }\n"));
  EXPECT_THAT(source, HasSubstr("    break;\n  }\n"));
}

TEST(EmitLoops, ABudgetOfTheStateSurvivesThePeriod) {
  std::string text = Period(kLoop);
  while (text.find("0 rounds") != std::string::npos) text.replace(text.find("0 rounds"), 8, "0 left");
  while (text.find("store rounds") != std::string::npos) text.replace(text.find("store rounds"), 12, "store left");
  // A budget that an input gives would be any number of rounds.
  const EmittedProgram program(text, {"a", "b", "c", "n", "k", "w"});
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  EXPECT_THAT(program.Source(), HasSubstr("if (m[left] != 0) {\n        m[left] = m[left] - 1;\n        continue;\n"));
}

// The comment of a statement without code is no code that the end of the body could be reached behind.
TEST(EmitLoops, BehindAJumpBackACommentIsNoWayOut) {
  const std::string source = RunProgram(Period(R"(
  stmt s1
  %0 = const i32 4
  store rounds %0
  block @2 {
    loop @1 budget 0 rounds {
      body {
        stmt s2
        %0 = load k
        %1 = const i8 3
        %2 = add.i8 %0 %1
        store k %2
        %3 = load a
        exit @1 if %3
        repeat @1 refused {
          exit @2
        }
        stmt s3
      }
    }
    stmt s4
    %0 = load b
    store c %0
  }
)"));
  EXPECT_THAT(source, HasSubstr("      continue;\n    }\n    return;\n  }\n"));
}

TEST(EmitLoops, RepeatsAndExitsThroughOtherLoopsGoByLabels) {
  const std::string source = RunProgram(R"(statement s3 subject "F1"
)" + Period(R"(
  stmt s1
  %0 = const i32 9
  store rounds %0
  loop @1 budget 0 rounds {
    body {
      stmt s3
      %0 = load n
      %1 = const i8 7
      %2 = add.i8 %0 %1
      store n %2
      stmt s4
      loop @2 budget 0 rounds {
        body {
          stmt s5
          %0 = load k
          %1 = const i8 3
          %2 = add.i8 %0 %1
          store k %2
          %3 = const i8 9
          %4 = ult.i8 %2 %3
          repeat @2 if %4
          stmt s6
          %0 = load n
          %1 = const i8 100
          %2 = ult.i8 %0 %1
          repeat @1 if %2 refused {
            exit @1
          }
          stmt s7
          %0 = load a
          exit @1 if %0
          stmt s8
          %0 = load b
          store c %0
        }
      }
      stmt s10
      %0 = load c
      store d %0
    }
  }
  stmt s9
  %0 = load k
  store n %0
)"));
  EXPECT_THAT(source, HasSubstr("  again_F1:;\n"));
  EXPECT_THAT(source, HasSubstr("goto again_F1;"));
  EXPECT_THAT(source, HasSubstr("goto to_next;"));
}

TEST(EmitLocals, ASubroutineGetsByReferenceWhatItOrACalleeTouches) {
  const EmittedProgram program(Program(R"(routine period schedule {
  stmt s1
  call fast ()
  %0 = load total
  store left %0
}
routine fast fast {
  stmt s2
  %0 = load a
  store s %0
  call PM17 ()
  stmt s3
  %0 = load s
  store b %0
  stmt s4
  call PM19 ()
}
routine PM17 subroutine {
  stmt s5
  %0 = load s
  %1 = not.bit %0
  store s %1
  call PM18 ()
}
routine PM18 subroutine {
  stmt s6
  %0 = load ax
  %1 = load w
  %2 = add.i16 %0 %1
  store ax %2
  store w %2
}
routine PM19 subroutine {
  stmt s7
  %0 = load c
  store d %0
}
)"),
                               kInputs);
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  const std::string source = program.Source();
  EXPECT_THAT(source, HasSubstr("static void PM17(State& m, bool& s, uint16_t& ax, Host& host) noexcept;\n"
                                "static void PM18(State& m, uint16_t& ax, Host& host) noexcept;\n"
                                "static void PM19(State& m, Host& host) noexcept;\n"));
  EXPECT_THAT(source, HasSubstr("void fast(State& m, Host& host) noexcept {\n  bool s = false;\n  uint16_t ax = 0;\n"));
  EXPECT_THAT(source, HasSubstr("  PM17(m, s, ax, host);\n"));
  EXPECT_THAT(source, HasSubstr("  PM18(m, ax, host);\n"));
  EXPECT_THAT(source, HasSubstr("void period(State& m, Host& host) noexcept {\n  fast(m, host);\n"));
  EXPECT_THAT(program.Header(), Not(HasSubstr("PM17")));
}

TEST(EmitLocals, ALocalThatIsOnlyWrittenIsNoWarning) {
  const std::string source = RunProgram(Period("  %0 = load a\n  store unread %0\n"));
  EXPECT_THAT(source, HasSubstr("  [[maybe_unused]] bool unread = false;\n"));
}

TEST(EmitLocals, ParametersAreValuesAndResultsAreReturned) {
  const std::string source = RunProgram(Program(R"(routine period schedule {
  stmt s1
  %0 = load w
  %1 = call twice (%0)
  store w %1
  stmt s2
  %0 = const i8 2
  call slow (%0)
}
routine slow slow (slice : i8 = slice) {
  stmt s3
  %0 = load slice
  store k %0
}
routine twice subroutine (in : i16 = in) -> i16 out_value {
  stmt s4
  %0 = load in
  %1 = load a
  block @1 {
    store out_value %0
    exit @1 if %1
    stmt s5
    %2 = load in
    %3 = add.i16 %2 %2
    store out_value %3
  }
}
)"));
  EXPECT_THAT(source,
              HasSubstr("uint16_t twice(State& m, uint16_t in, Host&) noexcept {\n  uint16_t out_value = 0;\n"));
  EXPECT_THAT(source, HasSubstr("  if (t104) return out_value;\n"));
  EXPECT_THAT(source, HasSubstr("  return Add16(t105, t105);\n}\n"));
  EXPECT_THAT(source, HasSubstr("  m[w] = twice(m, m[w], host);\n"));
}

TEST(EmitHost, ResultsAreSpelledWhereTheyAreUsed) {
  const EmittedProgram program(Period(R"(
  stmt s1
  %0 = load n
  %1 = host nc_read (%0) out got
  if %1 {
    %2 = load got
    store total %2
  } else {
    %3 = const i8 0
    %4 = load got
    host fault (%3, %4)
  }
  stmt s2
  %0 = load k
  %1 = host port (%0)
  %2 = load a
  %3 = and.bit %1 %2
  store d %3
  stmt s3
  %0 = load n
  %1 = const i8 1
  %2 = and.i8 %0 %1
  %3 = load got
  host fault (%2, %3)
)"),
                               kInputs);
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  EXPECT_THAT(program.Header(), HasSubstr("bool nc_read(Host& host, uint8_t width, uint32_t& value) noexcept;\n"));
  EXPECT_THAT(program.Source(), HasSubstr("  if (nc_read(host, m[n], got)) {\n    m[total] = got;\n  } else {\n"));
  EXPECT_THAT(program.Source(), HasSubstr("  const bool t102 = port(host, m[k]);\n  m[d] = t102 & m[a];\n"));
  EXPECT_THAT(program.Source(), HasSubstr("  fault(host, static_cast<fault_kind>(m[n] & 1), got);\n"));
}

TEST(EmitComparisons, ForegoneOnesAreNoWarnings) {
  const std::string source = RunProgram(Period(R"(
  %0 = load n
  %1 = zext.i8.i32 %0
  %2 = const i32 300
  %3 = ult.i32 %1 %2
  store b %3
  %4 = load left
  %5 = const i32 0
  %6 = uge.i32 %4 %5
  store c %6
  %7 = load w
  %8 = zext.i8.i16 %0
  %9 = eq.i16 %7 %8
  store d %9
  %10 = load a
  %11 = zext.bit.i32 %10
  %12 = const i32 2
  %13 = ne.i32 %11 %12
  store a %13
  %14 = load k
  %15 = load k
  %16 = eq.i8 %14 %15
  store s %16
  %17 = load w
  %18 = sgt.i16 %17 %17
  store b %18
)"));
  EXPECT_THAT(source, HasSubstr("Equal8(m[k], m[k]);\n"));
  EXPECT_THAT(source, HasSubstr("m[b] = SignedGreater16(t2, t2);\n"));
  EXPECT_THAT(source, HasSubstr("Less32(t1, 300)"));
  EXPECT_THAT(source, HasSubstr("m[c] = GreaterEqual32(m[left], 0);\n"));
  EXPECT_THAT(source, HasSubstr("m[d] = m[w] == t1;\n"));
  EXPECT_THAT(source, HasSubstr("m[a] = NotEqual32(m[a], 2);\n"));
}

TEST(EmitDebug, ALoopThatIsSwitchedOffAsksNothing) {
  RunProgram("statement s1 subject HEAD opens\n" + Period(R"(
  stmt s1
  loop @1 guard 4 {
    condition {
      %0 = load n
      %1 = host port (%0)
    }
    body {
      stmt s2
      %0 = load n
      %1 = const i8 1
      %2 = add.i8 %0 %1
      store n %2
    }
  }
)"));
}

TEST(EmitDebug, AJumpThatIsSwitchedOffJumpsOverNothing) {
  const EmittedProgram program(Period(R"(
  stmt s1
  %0 = load a
  %1 = not.bit %0
  if %1 stays {
    stmt s2
    %0 = load n
    store k %0
  }
  stmt s3
  %0 = load b
  store c %0
  if %0 jumps {
    %1 = load w
    store w %1
  } else {
    stmt s4
    %0 = load k
    %1 = const i8 1
    %2 = add.i8 %0 %1
    store n %2
  }
)"),
                               kInputs);
  program.ExpectRunsAsSimulated();
  program.ExpectDebugsAsSimulated();
  const std::string debug = program.Source(Flavour::kDebug);
  EXPECT_THAT(debug, HasSubstr("  if (!m.on(0) || !m[a]) {\n"));
  EXPECT_THAT(debug, HasSubstr("  if (m.on(2)) {\n    m[c] = t103;\n  }\n  if (m.on(2) && t103) {\n"));
}

}  // namespace
}  // namespace plcxx::emit
