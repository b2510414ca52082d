// One program per rule that must be refused, and programs that keep them all.

#include "transpiler/ir/verifier.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/ir/reader.h"

namespace plcxx::ir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::string_view kMemory = R"(
space m 4 volatile little
space locals 8 routine little
state T5 on_delay_timer
state C5 ring_counter
state K1 text_flag
state INBOX text_inbox
place bit bit m[0].0
place byte i8 m[1]
place row i8 m[0] stride 1 low 0 high 4 indexed
place budget i32 locals[0]
place slice i32 locals[4]
host fault (kind : i8) -> i8
)";

Program Read(std::string_view routines) { return ReadOrDie(std::string(kMemory) + std::string(routines)); }

std::string Fast(std::string_view body) { return "routine fast fast {\n" + std::string(body) + "}\n"; }

std::vector<std::string> Findings(const Program& program, Stage stage = Stage::kStructured) {
  return Verify(program, stage);
}
std::vector<std::string> Findings(std::string_view body) { return Findings(Read(Fast(body))); }

/// The only instruction of this kind.
Inst& Find(Program& program, OpKind op) {
  for (Inst& inst : program.insts) {
    if (inst.op == op) return inst;
  }
  PLCXX_UNREACHABLE();
}

TEST(Verifier, AcceptsWhatKeepsTheRules) {
  EXPECT_THAT(Findings(Read(R"(
routine sub subroutine (n : i32 = budget) -> i32 budget {
}
routine slow slow (slice : i32 = slice) sliced slices 3 {
  prologue {
    text.update K1 INBOX "GO"
  }
  body {
    stmt s1
    %0 = load bit
    if %0 {
      stmt s2
      %0 = load byte
      store byte %0
    }
    store bit %s1.0
    stmt s3
    %0 = const i32 3
    %1 = load row[%0]
    %2 = call sub (%0)
    block @1 {
      loop @2 guard 100 {
        condition {
          %3 = eq.i8 %1 %1
        }
        body {
          %4 = load bit
          exit @2 if %4
          exit @1
        }
        exhausted {
          %5 = host fault (%1)
        }
      }
      loop @3 budget 0 budget {
        body {
          %8 = load bit
          repeat @3 if %8 refused {
            exit @1
          }
        }
      }
    }
    switch %2 {
      case 1 2 falls_through {
      }
      default {
        %6 = load bit
        step.on_delay T5 %6 %0 %2
      }
    }
  }
  epilogue {
  }
}
routine period schedule {
  %0 = const i32 0
  call slow (%0)
}
schedule period period
)")),
              IsEmpty());
}

TEST(Verifier, ForwardJumpsBeforeStructuringOnly) {
  const Program program = Read(Fast("jump L1\nlabel L1\n"));
  EXPECT_THAT(Findings(program, Stage::kLowered), IsEmpty());
  EXPECT_THAT(Findings(program), ElementsAre("fast, jump: left over from before structuring",
                                             "fast, label: left over from before structuring"));
  EXPECT_THAT(Findings(Read(Fast("label L1\njump L1\n")), Stage::kLowered),
              ElementsAre("fast, jump: goes back to L1 without a budget"));
  EXPECT_THAT(Findings(Read(Fast("label L1\njump L1 budget budget refused {\n}\n")), Stage::kLowered), IsEmpty());
  EXPECT_THAT(Findings(Read(Fast("jump L1 budget budget\nlabel L1\n")), Stage::kLowered),
              ElementsAre("fast, jump: goes forward with a budget"));
  EXPECT_THAT(Findings(Read(Fast("jump L1\nlabel L1\nlabel L1\n")), Stage::kLowered),
              ElementsAre("fast, label: the label is there twice"));
  EXPECT_THAT(Findings(Read(Fast("%0 = load bit\nif %0 {\n jump L1\n}\nlabel L1\n")), Stage::kLowered), IsEmpty());
  EXPECT_THAT(Findings(Read(Fast("%0 = load bit\nif %0 {\n label L1\n}\njump L1\n")), Stage::kLowered),
              ElementsAre("fast, jump: no label L1 in its region"));
}

TEST(Verifier, ValuesAreComputedBeforeTheirUse) {
  Program program = Read(Fast("stmt s1\n%0 = load bit\nstore bit %0\n"));
  std::swap(program.regions[program.routines[RoutineId(0)].body].insts[1],
            program.regions[program.routines[RoutineId(0)].body].insts[2]);
  EXPECT_THAT(Findings(program), ElementsAre("fast, statement 0, store: stored value is used before it is computed"));
}

TEST(Verifier, ValuesAreVisibleByNesting) {
  EXPECT_THAT(Findings("%0 = load bit\nif %0 {\n %1 = load bit\n} else {\n store bit %1\n}\n"),
              ElementsAre("fast, store: stored value is computed in a region that is not around it"));
}

TEST(Verifier, ValuesDoNotCrossStatements) {
  EXPECT_THAT(Findings("stmt s1\n%0 = load bit\nstmt s2\nstore bit %s1.0\n"),
              ElementsAre("fast, statement 1, store: stored value crosses a statement"));
  EXPECT_THAT(Findings("stmt s1\n%0 = load bit\nif %0 {\n stmt s2\n store bit %s1.0\n}\n"),
              ElementsAre("fast, statement 1, store: stored value crosses a statement"));
}

TEST(Verifier, OperandsAndResultsHaveTheDeclaredTypes) {
  EXPECT_THAT(Findings("%0 = load byte\n%1 = not.bit %0\n"), ElementsAre("fast, not.bit: operand 1 is i8, not bit"));
  EXPECT_THAT(Findings("%0 = load byte\nstore bit %0\n"), ElementsAre("fast, store: stored value is i8, not bit"));
  EXPECT_THAT(Findings("%0 = load byte\nif %0 {\n}\n"), ElementsAre("fast, if: condition is i8, not bit"));
  EXPECT_THAT(Findings("%0 = const i8 256\n"), ElementsAre("fast, const: 256 is too large"));
  EXPECT_THAT(Findings("%0 = load byte\n%1 = load row[%0]\n"), ElementsAre("fast, load: index is i8, not i32"));
  EXPECT_THAT(Findings("%0 = load row\n"), ElementsAre("fast, load: row needs an index"));
  EXPECT_THAT(Findings("%0 = const i32 0\n%1 = load byte[%0]\n"), ElementsAre("fast, load: byte has no index"));
  Program program = Read(Fast("%0 = load bit\n%1 = not.bit %0\n"));
  Find(program, OpKind::kBitNot).type = Type::kI8;
  Find(program, OpKind::kBitNot).c = 0;
  EXPECT_THAT(Findings(program),
              ElementsAre("fast, not.bit: too many operands", "fast, not.bit: result of another type"));
  Find(program, OpKind::kBitNot).a = support::Id<void>::kNone;
  EXPECT_THAT(Findings(program)[0], "fast, not.bit: operand 1 is missing");
}

TEST(Verifier, StepsAdvanceInstancesOfTheirKind) {
  EXPECT_THAT(Findings("%0 = load bit\n%1 = const i32 1\nstep.on_delay C5 %0 %1 %1\n"),
              ElementsAre("fast, step.on_delay: state instance of another kind"));
  EXPECT_THAT(Findings("text.update C5 K1 \"GO\"\n"),
              ElementsAre("fast, text.update: no text flag", "fast, text.update: no text inbox"));
}

TEST(Verifier, OnlyWhoWritesTheStateHasASpaceForIt) {
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nhost fill () writes_state in m\n")), IsEmpty());
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nhost fill () reads_state in m\n")),
              ElementsAre("host function fill: writes no such space"));
}

TEST(Verifier, PlacesLieInsideTheirSpaces) {
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nplace w i32 m[1]\n")),
              ElementsAre("place w: outside of space m"));
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nplace w i32 m[4294967295]\n")),
              ElementsAre("place w: outside of space m"));
  EXPECT_THAT(
      Findings(ReadOrDie("space m 4 volatile little\nplace b bit m[1].8\nplace c bit m[0]\nplace d i8 m[0].1\n")),
      ElementsAre("place b: no bit 0..7", "place c: no bit 0..7", "place d: a bit of a word"));
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nplace r i8 m[0] stride 1 low 0 high 5 indexed\n")),
              ElementsAre("place r: index bounds outside of space m"));
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nplace r i8 m[0] stride 0 low 0 high 4 indexed\n")),
              ElementsAre("place r: index bounds outside of space m"));
  EXPECT_THAT(
      Findings(ReadOrDie("state T5 on_delay_timer\nplace t i8 field T5 done\nplace e i32 field T5 elapsed_ms\n")),
      ElementsAre("place t: the field is bit", "place e: field elapsed_ms is hidden"));
  EXPECT_THAT(
      Findings(ReadOrDie("space m 4 volatile little\nzone m 0 5 input\ninitial m 2 1\ninitial m 2 1\ninitial m 4 1\n")),
      ElementsAre("space m: zone outside", "space m: initial values do not ascend", "space m: initial value outside"));
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nzone m bits 30 32 input\n")), ElementsAre());
  EXPECT_THAT(Findings(ReadOrDie("space m 4 volatile little\nzone m bits 30 33 input\n")),
              ElementsAre("space m: zone outside"));
}

TEST(Verifier, ConstantTablesLieInTheirSpace) {
  EXPECT_THAT(Findings(ReadOrDie("space m 8 volatile little\nconstant m 0 2\nconstant m 2 8\n")), ElementsAre());
  EXPECT_THAT(Findings(ReadOrDie("space m 8 volatile little\nconstant m 4 9\nconstant m 0 2\n")),
              ElementsAre("space m: constant outside", "space m: constants do not ascend"));
}

TEST(Verifier, RegionsHaveOneOwner) {
  Program program = Read(Fast("%0 = load bit\nif %0 {\n} else {\n}\n"));
  Find(program, OpKind::kIf).c = Find(program, OpKind::kIf).b;
  EXPECT_THAT(Findings(program), ElementsAre("fast, if: its region has another owner"));
  Find(program, OpKind::kIf).c = program.routines[RoutineId(0)].body.index;  // a cycle must not hang
  EXPECT_THAT(Findings(program), ElementsAre("fast, if: its region has another owner"));
}

TEST(Verifier, InstructionsStandInOnePlace) {
  Program program = Read(Fast("%0 = load bit\n"));
  auto& insts = program.regions[program.routines[RoutineId(0)].body].insts;
  insts.push_back(insts[0]);
  EXPECT_THAT(Findings(program), ElementsAre("fast, load: stands in two places"));
}

TEST(Verifier, LoopsAreBounded) {
  EXPECT_THAT(Findings("loop @1 guard 0 {\n body {\n }\n}\n"), ElementsAre("fast, loop: no bound"));
  EXPECT_THAT(Findings("loop @1 budget 3 {\n body {\n }\n}\n"), ElementsAre("fast, loop: no budget place"));
  EXPECT_THAT(Findings("loop @1 guard 3 budget {\n body {\n }\n}\n"), ElementsAre("fast, loop: budget without use"));
  EXPECT_THAT(Findings("loop @1 proven 3 {\n condition {\n  %0 = load byte\n }\n body {\n }\n}\n"),
              ElementsAre("fast, loop: its condition is no bit"));
}

TEST(Verifier, ExitsNameWhatIsAroundThem) {
  Program program = Read(Fast("block @1 {\n}\nblock @1 {\n exit @1\n}\n"));
  Find(program, OpKind::kExit).payload = program.regions[program.routines[RoutineId(0)].body].insts[0].index;
  EXPECT_THAT(Findings(program), ElementsAre("fast, exit: no block or loop around it"));
}

TEST(Verifier, CasesAreDistinct) {
  EXPECT_THAT(Findings("%0 = load byte\nswitch %0 {\n case 1 2 {\n }\n case 2 {\n }\n}\n"),
              ElementsAre("fast, switch: two cases for one value"));
  EXPECT_THAT(Findings("%0 = load byte\nswitch %0 {\n default {\n }\n default {\n }\n}\n"),
              ElementsAre("fast, switch: two cases for one value"));
}

TEST(Verifier, CallsMakeNoCycle) {
  EXPECT_THAT(Findings(Read("routine a subroutine {\ncall b ()\n}\nroutine b subroutine {\ncall a ()\n}\n")),
              ElementsAre("b calls itself through a"));
  EXPECT_THAT(Findings(Read("routine a subroutine {\ncall a ()\n}\n")), ElementsAre("a calls itself through a"));
}

TEST(Verifier, ArgumentsFitTheParameters) {
  EXPECT_THAT(Findings("%0 = load bit\n%1 = host fault (%0)\n"),
              ElementsAre("fast, host: argument kind is bit, not i8"));
  EXPECT_THAT(Findings("%0 = host fault ()\n"), ElementsAre("fast, host: 0 arguments for 1 parameters"));
  EXPECT_THAT(Findings(Read("routine sub subroutine (n : i32 = slice) {\n}\n" + Fast("call sub ()\n"))),
              ElementsAre("fast, call: 0 arguments for 1 parameters"));
}

TEST(Verifier, EveryStatementHasOneMarker) {
  EXPECT_THAT(Findings("stmt s1\nstmt s1\n"), ElementsAre("fast, statement 0, stmt: statement 0 is marked twice"));
  EXPECT_THAT(Findings(ReadOrDie("statement s1 subject U4A8\n")), ElementsAre("statement 0 (U4A8) has disappeared"));
}

TEST(Verifier, RoutinesAreAsTheirKindsAllow) {
  EXPECT_THAT(Findings(Read("routine a fast sliced {\n}\n")),
              ElementsAre("a: only a slow routine is sliced", "a: sliced without parameter slice"));
  EXPECT_THAT(Findings(Read("routine a slow (slice : i32 = slice) sliced slices 65 {\n}\n")),
              ElementsAre("a: impossible number of slices"));
  EXPECT_THAT(Findings(Read("routine a slow slices 2 {\n}\n")), ElementsAre("a: impossible number of slices"));
  EXPECT_THAT(Findings(Read("routine a slow (n : i32) {\n}\n")), ElementsAre("a: parameters without places"));
  EXPECT_THAT(Findings(Read("routine a subroutine (n : i8 = byte) {\n}\n")),
              ElementsAre("a: parameter n outlives the routine"));
  EXPECT_THAT(Findings(Read("routine a subroutine -> i8 budget {\n}\n")),
              ElementsAre("a: result is not of its place's type"));
  EXPECT_THAT(Findings(Read("routine a subroutine -> i8 none {\n}\n")), ElementsAre("a: result without place"));
  EXPECT_THAT(Findings(Read("routine a fast {\n}\nroutine b slow {\ncall a ()\n}\n")),
              ElementsAre("b, call: a is no subroutine"));
  EXPECT_THAT(Findings(Read("routine a fast {\n}\nschedule period a\n")),
              ElementsAre("schedule: period is of another kind"));
  Program program = Read(Fast(""));
  program.routines[RoutineId(0)].body = {};
  EXPECT_THAT(Findings(program), ElementsAre("fast: no body"));
}

TEST(Verifier, SurvivesIdsThatNameNothing) {
  Program program =
      Read(Fast("%0 = load bit\nstore bit %0\nstmt s1\nblock @1 {\n}\n%1 = const i8 1\nswitch %1 {\n}\n"));
  for (const InstId id : program.regions[program.routines[RoutineId(0)].body].insts) program[id].payload = 1000;
  Find(program, OpKind::kBlock).a = 1000;
  EXPECT_THAT(Findings(program).size(), testing::Ge(5u));
}

}  // namespace
}  // namespace plcxx::ir
