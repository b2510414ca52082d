// Every operation that has a form in planes, in each lane beside the simulator, which calls the function itself.
#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/fleet/lanes_beside.h"
#include "tests/volume.h"
#include "transpiler/engines/platform.h"
#include "transpiler/ir/op.h"
#include "transpiler/ir/reader.h"

namespace plcxx::fleet {
namespace {

struct Form {
  ir::OpKind op;
  int constant;  // the operand that has to be one; -1: none
};
constexpr Form kForms[] = {
#define PLCXX_SLICED(Kind, function) {ir::OpKind::k##Kind, -1},
#define PLCXX_SLICED_BY(Kind, operand, function) {ir::OpKind::k##Kind, operand},
#define PLCXX_SLICED_CLOCK(Kind, function)
#include "transpiler/fleet/sliced_operations.def"
#undef PLCXX_SLICED
#undef PLCXX_SLICED_BY
#undef PLCXX_SLICED_CLOCK
};

constexpr ir::OpKind kStepsByClock[] = {
#define PLCXX_SLICED(...)
#define PLCXX_SLICED_BY(...)
#define PLCXX_SLICED_CLOCK(Kind, function) ir::OpKind::k##Kind,
#include "transpiler/fleet/sliced_operations.def"
#undef PLCXX_SLICED
#undef PLCXX_SLICED_BY
#undef PLCXX_SLICED_CLOCK
};

constexpr uint64_t kConstants[] = {0, 1, 7, 9, 10, 0x3010, 0x2345, 1000, 60000, 0xFFFFFFFF};

/// A program of one routine, which grows an operation at a time.
class Text {
 public:
  Text() {
    // Operands of all types, and single bits for what steps.
    declarations_ = "space IN 64 volatile little host_visible\nspace OUT 8192 volatile little host_visible\n";
    for (int i = 0; i < 3; ++i) {
      const std::string at = std::to_string(16 * i), n = std::to_string(i);
      declarations_ += "place bit" + n + " bit IN[" + at + "].0\nplace i8" + n + " i8 IN[" +
                       std::to_string(16 * i + 1) + "]\nplace i16" + n + " i16 IN[" + std::to_string(16 * i + 2) +
                       "]\nplace i32" + n + " i32 IN[" + std::to_string(16 * i + 4) + "]\nplace i64" + n + " i64 IN[" +
                       std::to_string(16 * i + 8) + "]\n";
    }
    for (int i = 0; i < 64; ++i)
      declarations_ += "place in" + std::to_string(i) + " bit IN[" + std::to_string(48 + i / 8) + "]." +
                       std::to_string(i % 8) + "\n";
  }

  /// `constant`: which operand is one; none: -1.
  void Add(ir::OpKind op, int constant, uint64_t value) {
    const ir::OpInfo& info = ir::Info(op);
    std::string call = std::string(info.text);
    if (info.state) {
      const std::string instance = "S" + std::to_string(instances_++);
      declarations_ += "state " + instance + " " + std::string(ir::Info(*info.state).text) + "\n";
      call += " " + instance;
    }
    Call(info, call, constant, value);
  }
  /// Starts of a timer with one word, and time that passes for it.
  void AddTimer(std::string_view start, std::string_view word) {
    const std::string timer = "S" + std::to_string(instances_++);
    declarations_ += "state " + timer + " time_word_timer\n";
    const std::string c = Value("load " + NextInput()), z = Value("load " + NextInput()), w = Value(std::string(word));
    Store(ir::Type::kBit, Value("step." + std::string(start) + " " + timer + " " + c + " " + w));
    body_ += "step.reset_timer " + timer + " " + Value("and.bit " + z + " " + Value("load bit0")) + "\n";
    body_ += "step.pass_time " + timer + " " + Value("const i32 12") + "\n";
    body_ += "step.pass_time " + timer + " " + Value("zext.i8.i32 " + Value("load i80")) + "\n";
  }
  /// A timer that counts a period of the section.
  void AddUnitTimer(ir::OpKind op, const std::string& preset, uint32_t period_ms) {
    const ir::OpInfo& info = ir::Info(op);
    const std::string timer = "S" + std::to_string(instances_++);
    declarations_ += "state " + timer + " unit_timer\n";
    for (const char* field : {"bit output", "i32 preset", "i32 value"}) {  // what the control may write
      const std::string text(field), name = text.substr(text.find(' ') + 1);
      declarations_ +=
          "place " + timer + "_" + name + " " + text.substr(0, text.find(' ')) + " field " + timer + " " + name + "\n";
    }
    Store(ir::Type::kBit, Value(std::string(info.text) + " " + timer + " " + Value("load " + NextInput()) + " " +
                                Value(preset) + " " + Value("const i32 " + std::to_string(period_ms))));
    Store(ir::Type::kBit, Value("load " + timer + "_output"));
  }
  void AddCounter() {
    const std::string counter = "S" + std::to_string(instances_++);
    declarations_ += "state " + counter + " decade_counter\n";
    Store(ir::Type::kBit, Value("step.count_up " + counter + " " + Value("load " + NextInput())));
    Store(ir::Type::kBit, Value("step.count_down " + counter + " " + Value("load " + NextInput())));
    body_ +=
        "step.set_counter_on_edge " + counter + " " + Value("load " + NextInput()) + " " + Value("load i160") + "\n";
    body_ += "step.set_counter " + counter + " " + Value("load bit1") + " " + Value("const i16 2455") + "\n";
  }
  std::string ToString() const {
    return declarations_ + "routine period schedule {\n" + body_ + "}\nschedule period period\nschedule period_ms 10\n";
  }

 private:
  std::string Value(const std::string& what) {
    const std::string name = "%v" + std::to_string(values_++);
    body_ += name + " = " + what + "\n";
    return name;
  }
  std::string NextInput() { return "in" + std::to_string(inputs_++ % 64); }
  void Store(ir::Type type, const std::string& value) {
    const std::string name = "o" + std::to_string(out_);
    declarations_ += "place " + name + " " + std::string(ir::Name(type)) + " OUT[" + std::to_string(out_) + "]" +
                     (type == ir::Type::kBit ? ".0" : "") + "\n";
    out_ += ir::Bytes(type) > 0 ? ir::Bytes(type) : 1;
    body_ += "store " + name + " " + value + "\n";
  }
  void Call(const ir::OpInfo& info, std::string call, int constant, uint64_t number) {
    for (int i = 0; i < info.operand_count; ++i) {
      const std::string type(ir::Name(info.operands[i]));
      const unsigned bits = info.operands[i] == ir::Type::kBit ? 1 : 8 * ir::Bytes(info.operands[i]);
      const uint64_t fitting = bits == 64 ? number : number & ((uint64_t{1} << bits) - 1);
      call += " " + (i == constant ? Value("const " + type + " " + std::to_string(fitting))
                     : info.operands[i] == ir::Type::kBit && info.state ? Value("load " + NextInput())
                                                                        : Value("load " + type + std::to_string(i)));
    }
    if (info.result == ir::Type::kNone) {
      body_ += call + "\n";
    } else {
      Store(info.result, Value(call));
    }
  }

  std::string declarations_, body_;
  int values_ = 0, instances_ = 0, inputs_ = 0;
  uint32_t out_ = 0;
};

std::string AllOperations() {
  Text text;
  for (const Form& form : kForms) {
    if (form.constant < 0) text.Add(form.op, -1, 0);
    for (const uint64_t constant : kConstants) {
      if (form.constant >= 0) text.Add(form.op, form.constant, constant);
    }
    if (form.constant < 0 && ir::Info(form.op).operand_count > 1) text.Add(form.op, 1, 0x1010);
  }
  for (const char* start :
       {"start_pulse", "start_extended", "start_on_delay", "start_latched_delay", "start_off_delay"}) {
    for (const char* word : {"load i161", "const i16 5", "const i16 4099", "const i16 0"}) text.AddTimer(start, word);
  }
  for (int i = 0; i < 3; ++i) text.AddCounter();
  for (const ir::OpKind op : kStepsByClock) {
    if (ir::Info(op).state != ir::StateKind::kUnitTimer) continue;
    for (const char* preset : {"const i32 0", "const i32 1", "const i32 3", "const i32 4294967295", "load i321"}) {
      for (const uint32_t period_ms : {40u, 25'000u}) text.AddUnitTimer(op, preset, period_ms);
    }
  }
  return text.ToString();
}

class SlicedOperations : public testing::TestWithParam<unsigned> {};

TEST_P(SlicedOperations, GiveWhatTheirFunctionsGive) {
  if (GetParam() > WidestFleet()) GTEST_SKIP() << "this processor has no such vectors";
  const ir::Program program = ir::ReadOrDie(AllOperations());
  const LibraryOrFailure built = CompileFleet(
      program, {.compiler = engines::FindCompiler(), .level = "1", .lanes = GetParam(), .forces = false, .cache = {}});
  const auto* const library = std::get_if<std::shared_ptr<const Library>>(&built);
  ASSERT_NE(library, nullptr) << std::get<std::string>(built);
  for (const uint64_t seed : {1, 2, 3}) {
    EXPECT_EQ(CompareLanes(*library, seed, 400), "");
    EXPECT_EQ(CompareLanes(*library, seed, 400, Hosts::kWild), "");
  }
}

/// To compile all operations takes most of the time: the widest of this processor in a normal run.
std::vector<unsigned> Widths() {
  return testing_support::Volume(std::vector<unsigned>{WidestFleet()}, std::vector<unsigned>{64, 256, 512});
}

INSTANTIATE_TEST_SUITE_P(Widths, SlicedOperations, testing::ValuesIn(Widths()));

}  // namespace
}  // namespace plcxx::fleet
