// Random graphs of jumps, through the passes that make regions of them: the generated code computes what the simulator
// computes. Loops cross, begin in each other's middle, and stand one behind the other in a routine; conditions are
// steps and calls as often as signals.

#include "tests/emit/emitted_program.h"
#include "transpiler/passes/nest_blocks.h"
#include "transpiler/passes/pipeline.h"
#include "transpiler/passes/structure.h"

namespace plcxx::emit {
namespace {

constexpr std::string_view kJumpMemory = R"(space m 8 volatile little host_visible
space r 8 routine little
place a bit m[0].0
place b bit m[0].1
place c bit m[0].2
place d bit m[0].3
place x i8 m[1]
place trace i32 m[4]
place rounds i32 r[0]
place gone bit r[4].0
host fault (kind : i8 = (LOW, HIGH), index : i32)
host port (at : i8) -> bit
state C5 decade_counter
state C6 decade_counter
place count5 i16 field C5 value
place count6 i16 field C6 value
routine Gone subroutine -> bit gone {
  stmt s1
  %0 = load x
  %1 = const i8 7
  %2 = ult.i8 %0 %1
  store gone %2
  %3 = add.i8 %0 %1
  store x %3
}
)";

/// One routine: statements with labels, any of which jumps to any label.
class JumpWriter {
 public:
  explicit JumpWriter(std::mt19937& random) : random_(random) {}

  std::string Body(uint32_t count, uint32_t& statement) {
    out_.clear();
    for (uint32_t i = 0; i < count; ++i) {
      const std::string label = "label L" + std::to_string(i) + "\n";
      char marker[24];
      std::snprintf(marker, sizeof marker, "stmt s%x\n", ++statement);
      out_ += Below(2) == 0 ? label + marker : marker + label;
      Statement(i, count, statement);
    }
    return out_ + "label L" + std::to_string(count) + "\n";
  }

 private:
  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }

  /// Computes %9.
  void Condition() {
    const std::string signal(1, "abcd"[Below(4)]);
    out_ += "%8 = load " + signal + "\n";
    switch (Below(6)) {
      case 0:
        out_ += "%9 = step.count_up C5 %8\n";
        break;
      case 1:
        out_ += "%9 = step.count_down C6 %8\n";
        break;
      case 2:
        out_ += "%7 = load x\n%9 = host port (%7)\n";
        break;
      case 3:
        out_ += "%9 = call Gone ()\n";
        break;
      default:
        out_ += "%9 = not.bit %8\n";
    }
  }

  void Statement(uint32_t at, uint32_t count, uint32_t number) {
    if (Below(3) != 0) {
      out_ += "%0 = load trace\n%1 = const i32 31\n%2 = mul.i32 %0 %1\n%3 = const i32 " + std::to_string(number) +
              "\n%4 = add.i32 %2 %3\nstore trace %4\n";
    }
    if (Below(3) == 0) {
      const std::string to(1, "abcd"[Below(4)]);
      out_ += "%5 = load " + std::string(1, "abcd"[Below(4)]) + "\n%6 = not.bit %5\nstore " + to + " %6\n";
    }
    const uint32_t what = Below(7);
    if (what > 4) return;
    Condition();
    if (what == 4) return;  // for nothing
    const uint32_t target = Below(count + 1);
    std::string jump = "jump L" + std::to_string(target) + (what == 3 ? "" : " if %9");
    if (target <= at) {
      jump += " budget rounds refused {\n  %10 = const i8 1\n  %11 = const i32 " + std::to_string(number) +
              "\n  host fault (%10, %11)\n  jump L" + std::to_string(Below(2) == 0 ? count : at + 1) + "\n}";
    }
    out_ += jump + "\n";
    if (Below(3) == 0) out_ += "store d %9\n";
  }

  std::mt19937& random_;
  std::string out_;
};

/// Routines of `statements` and up to eleven more.
ir::Program RandomJumps(uint32_t seed, uint32_t routines, uint32_t statements = 2) {
  std::mt19937 random(seed);
  std::string text(kJumpMemory), calls;
  uint32_t statement = 1;
  for (uint32_t i = 0; i < routines; ++i) {
    JumpWriter writer(random);
    const std::string name = "R" + std::to_string(i);
    text += "routine " + name + " subroutine {\n" + writer.Body(statements + i % 12, statement) + "}\n";
    const std::string budget = "%" + std::to_string(i);
    calls += "  " + budget + " = const i32 9\n  store rounds " + budget + "\n  call " + name + " ()\n";
  }
  ir::Program program = ir::ReadOrDie(text + "routine period schedule {\n" + calls + "}\nschedule period period\n");
  for (const std::string& finding : ir::Verify(program, ir::Stage::kLowered)) ADD_FAILURE() << finding;
  passes::Structure(program);
  passes::NestBlocks(program);
  passes::Optimize(program);
  return program;
}

TEST(EmitRandom, GraphsOfJumps) {
  for (uint32_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const EmittedProgram program(RandomJumps(seed, 36), {"a", "b", "c", "d", "x"}, seed);
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated(seed);
    if (HasFailure()) return;
  }
}

// Braces around the locals that a goto jumps over are not nested for ever: deeper inside a local has no value where it
// is declared.
TEST(EmitRandom, DeepGraphsOfJumps) {
  const EmittedProgram program(RandomJumps(7, 1, 400), {"a", "b", "c", "d", "x"}, 7);
  EXPECT_FALSE(legalize::Legalize(program.program(), {.name = "p"}).loose_locals.empty());
  program.ExpectRunsAsSimulated();
}

}  // namespace
}  // namespace plcxx::emit
