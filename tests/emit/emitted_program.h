// A program of the IR, emitted, compiled and run beside the simulator: whatever is stored where and however it is
// spelled, both must read the same at every named place after every period.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/driver/run_plcxx.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/engines/compiled_engine.h"
#include "transpiler/ir/reader.h"
#include "transpiler/ir/verifier.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::emit {

inline constexpr std::string_view kStrict =
    " -Wall -Wextra -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti -ffp-contract=off -I " PLCXX_ROOT
    "/runtime_support ";
inline constexpr uint32_t kRounds = 24;

/// Values that each place gets before each period, by the seed of the test.
class EmittedProgram {
 public:
  /// `inputs`: names of places that are written before each period. The program needs a schedule with a period.
  EmittedProgram(std::string_view text, std::vector<std::string> inputs, uint32_t seed = 1)
      : EmittedProgram(ir::ReadOrDie(text), std::move(inputs), seed) {}
  EmittedProgram(ir::Program program, std::vector<std::string> inputs, uint32_t seed)
      : program_(std::move(program)), inputs_(std::move(inputs)) {
    AddInit();
    for (const std::string& finding : ir::Verify(program_, ir::Stage::kStructured)) ADD_FAILURE() << finding;
    std::mt19937_64 random(seed);
    for (uint32_t round = 0; round < kRounds; ++round) {
      for (const std::string& input : inputs_) values_.push_back(Value(PlaceOf(input).type, random));
    }
  }

  const ir::Program& program() const { return program_; }

  std::string Source(Flavour flavour = Flavour::kRelease) const { return Files(flavour).back().text; }
  std::string Header(Flavour flavour = Flavour::kRelease) const { return Files(flavour).front().text; }

  /// Compiles the release flavour without a warning and compares what it computes with the simulator.
  void ExpectRunsAsSimulated() const {
    const std::string expected = Simulated();
    for (const OutputFile& file : Files(Flavour::kRelease)) work_.Write(file.name, file.text);
    work_.Write("main.cpp", Main());
    for (const std::string compiler : {"g++ -std=c++17 -O2", "clang++-19 -std=c++17 -O1"}) {
      if (Shell(compiler.substr(0, compiler.find(' ')) + " --version >/dev/null 2>&1") != 0) continue;
      const std::string sanitize = " -fsanitize=undefined -fno-sanitize-recover=all ";
      // Warnings of GCC depend on what its optimizer sees; Clang gives the same ones below.
      if (compiler.front() == 'g') {
        ASSERT_EQ(Shell(compiler + std::string(kStrict) + "-c p.cpp -o /dev/null"), 0) << compiler << "\n" << Source();
      }
      ASSERT_EQ(Shell(compiler + sanitize + std::string(kStrict) + "p.cpp main.cpp -o run && ./run >out.txt"), 0)
          << compiler << "\n"
          << Source();
      ASSERT_EQ(work_.Read("out.txt"), expected) << compiler << "\n" << Header() << Source();
    }
  }

  /// The debug flavour, with random statements switched off and random inputs forced.
  void ExpectDebugsAsSimulated(uint32_t seed = 1) const {
    work_.Write("debug.cpp", Source(Flavour::kDebug));
    const std::string compiler = engines::FindCompiler();
    ASSERT_FALSE(compiler.empty());
    auto platform = engines::MakeHostPlatform(compiler);
    ASSERT_EQ(platform.index(), 0u) << std::get<1>(platform).message;
    auto compiled = engines::CompileFor(std::get<0>(platform), program_, sources_, Flavour::kDebug);
    ASSERT_EQ(compiled.index(), 0u) << std::get<1>(compiled).message << Source(Flavour::kDebug);
    auto started = engines::StartCompiled(std::get<0>(compiled));
    ASSERT_EQ(started.index(), 0u);
    sim::Simulator simulator(program_);
    const std::vector<sim::Engine*> engines = {std::get<0>(started).get(), &simulator};
    std::mt19937 random(seed);
    for (sim::Engine* engine : engines) {
      engine->AnswerHostCalls(Answer);
      engine->PowerOn();
    }
    for (uint32_t round = 0; round < kRounds; ++round) {
      for (size_t i = 0; i < inputs_.size(); ++i) {
        const ir::Place& place = PlaceOf(inputs_[i]);
        const uint64_t value = values_[round * inputs_.size() + i];
        const uint32_t kind = random() % 8;
        for (sim::Engine* engine : engines) {
          if (kind == 0) engine->Force(place, value);
          if (kind == 1) engine->Release(place);
          if (kind > 1) engine->Write(place, value);
        }
      }
      for (uint32_t i = 0; i < program_.statements.size(); ++i) {
        const bool on = random() % 6 != 0;
        for (sim::Engine* engine : engines) engine->EnableStatement(ir::StatementId(i), on);
      }
      for (sim::Engine* engine : engines) engine->RunPeriod(10 * (round + 1));
      EXPECT_EQ(engines[0]->TakeEvents(), engines[1]->TakeEvents()) << round;
      for (uint32_t i = 0; i < program_.places.size(); ++i) {
        const ir::Place& place = program_.places[ir::PlaceId(i)];
        if (!IsCompared(place)) continue;
        ASSERT_EQ(engines[0]->Read(place), engines[1]->Read(place)) << place.name << " in round " << round << "\n"
                                                                    << Source(Flavour::kDebug);
      }
    }
  }

 private:
  /// The debug flavour is driven by init and period; most programs here have nothing to do at power-on.
  void AddInit() {
    if (program_.schedule.init.valid()) return;
    ir::Routine init{.name = "init", .kind = ir::RoutineKind::kInit};
    init.body = program_.regions.Add({});
    program_.schedule.init = program_.routines.Add(std::move(init));
  }

  static uint64_t Value(ir::Type type, std::mt19937_64& random) {
    if (type == ir::Type::kBit) return random() & 1;
    if (type == ir::Type::kF32) {
      constexpr float kFloats[] = {0.0F, -0.0F, 1.0F, -1.5F, 3.25F, 1e10F, -1e-10F, 123.75F};
      return std::bit_cast<uint32_t>(kFloats[random() % std::size(kFloats)]);
    }
    // Small numbers often, so that indices and counts meet their limits.
    const uint64_t value = random() % 3 == 0 ? random() : random() % 12;
    return value & (ir::Bytes(type) == 8 ? ~uint64_t{0} : (uint64_t{1} << (8 * ir::Bytes(type))) - 1);
  }

  /// What the host gives: something that depends on the arguments, and a second result now and then.
  static sim::HostAnswer Answer(ir::HostFunctionId, std::span<const uint64_t> arguments) {
    uint64_t sum = 1;
    for (const uint64_t argument : arguments) sum = sum * 31 + argument;
    sim::HostAnswer answer{.result = sum & 1, .out = {}};
    if (sum % 3 != 0) answer.out = sum & 0xFF;
    return answer;
  }

  std::vector<OutputFile> Files(Flavour flavour) const {
    return print::PrintCpp(legalize::Legalize(program_, {.name = "p", .flavour = flavour}), sources_);
  }

  const ir::Place& PlaceOf(const std::string& name) const {
    for (const ir::Place& place : program_.places) {
      if (place.name == name) return place;
    }
    ADD_FAILURE() << "no place " << name;
    return program_.places[ir::PlaceId(0)];
  }

  bool IsCompared(const ir::Place& place) const {
    if (place.indexed) return false;
    return place.is_field() || program_.spaces[place.space].lifetime != ir::Lifetime::kRoutine;
  }

  std::string Simulated() const {
    sim::Simulator simulator(program_);
    const Emittable emittable = legalize::Legalize(program_, {.name = "p"});
    simulator.AnswerHostCalls(Answer);
    simulator.PowerOn();
    std::string out;
    for (uint32_t round = 0; round <= kRounds; ++round) {
      for (size_t i = 0; i < inputs_.size() && round > 0; ++i) {
        simulator.Write(PlaceOf(inputs_[i]), values_[(round - 1) * inputs_.size() + i]);
      }
      if (round > 0) simulator.RunPeriod(10 * round);
      for (uint32_t i = 0; i < program_.places.size(); ++i) {
        const ir::Place& place = program_.places[ir::PlaceId(i)];
        if (!IsCompared(place) || emittable.place_names[i].empty()) continue;
        out +=
            std::to_string(round) + " " + emittable.place_names[i] + " " + std::to_string(simulator.Read(place)) + "\n";
      }
      for (const sim::HostEvent& event : simulator.TakeEvents()) {
        events_.push_back(program_.host_functions[event.function].name);
      }
    }
    return out;
  }

  /// The host's functions, the inputs as a table, and every place printed after every period.
  std::string Main() const {
    const Emittable emittable = legalize::Legalize(program_, {.name = "p"});
    std::string out =
        "#include <stdio.h>\n#include <string.h>\n#include \"p.hpp\"\nnamespace p {\nstruct Host { uint32_t now; };\n";
    for (uint32_t i = 0; i < program_.host_functions.size(); ++i) {
      if (!emittable.host_used[i]) continue;
      out += HostFunction(program_.host_functions[ir::HostFunctionId(i)]);
    }
    out +=
        "}\nusing namespace p;\ntemplate <class T> unsigned long long Raw(T value) {\n  unsigned long long raw = 0;\n"
        "  memcpy(&raw, &value, sizeof value);\n  return raw;\n}\n"
        "template <class T> T Of(unsigned long long raw) {\n  T value;\n  memcpy(&value, &raw, sizeof value);\n"
        "  return value;\n}\nstatic State m;\nstatic void Show(unsigned round) {\n";
    for (uint32_t i = 0; i < program_.places.size(); ++i) {
      const ir::Place& place = program_.places[ir::PlaceId(i)];
      const std::string& name = emittable.place_names[i];
      if (!IsCompared(place) || name.empty()) continue;
      out += "  printf(\"%u " + name + " %llu\\n\", round, Raw<" + std::string(ir::CppName(place.type)) + ">(m[" +
             name + "]));\n";
    }
    out += "}\n" + InputTable() + "int main() {\n  Host host{0};\n";
    if (program_.schedule.init.valid()) out += "  init(m, host);\n";
    out += "  Show(0);\n";
    out += "  for (unsigned round = 0; round < " + std::to_string(kRounds) + "; ++round) {\n";
    for (size_t i = 0; i < inputs_.size(); ++i) {
      const std::string& name = emittable.place_names[Index(inputs_[i])];
      if (name.empty()) continue;  // the program does not use it
      out += "    m[" + name + "] = Of<" + std::string(ir::CppName(PlaceOf(inputs_[i]).type)) + ">(given[round][" +
             std::to_string(i) + "]);\n";
    }
    out += "    host.now = 10 * (round + 1);\n    " + program_.routines[program_.schedule.period].name +
           "(m, host);\n    Show(round + 1);\n  }\n";
    return out + "}\n";
  }

  /// A table and a loop over it: written out, the assignments cost the compilers more than the program itself.
  std::string InputTable() const {
    if (inputs_.empty()) return "";
    std::string out = "[[maybe_unused]] const unsigned long long given[][" + std::to_string(inputs_.size()) + "] = {\n";
    for (size_t i = 0; i < values_.size(); ++i) {
      out += (i % inputs_.size() == 0 ? "  {" : "") + std::to_string(values_[i]) + "ull" +
             ((i + 1) % inputs_.size() == 0 ? "},\n" : ", ");
    }
    return out + "};\n";
  }

  size_t Index(const std::string& name) const {
    return static_cast<size_t>(&PlaceOf(name) - &program_.places[ir::PlaceId(0)]);
  }

  std::string HostFunction(const ir::HostFunction& function) const {
    std::string out = std::string(ir::CppName(function.result)) + " " + function.name + "(Host& host";
    std::string sum = "  unsigned long long sum = 1;\n";
    for (const ir::Parameter& parameter : function.parameters) {
      const bool named = !parameter.enumerators.empty();
      out += ", " + (named ? function.name + "_" + parameter.name : std::string(ir::CppName(parameter.type))) + " " +
             parameter.name;
      sum += "  sum = sum * 31 + static_cast<unsigned long long>(" + parameter.name + ");\n";
    }
    if (!function.out.name.empty()) {
      out += ", " + std::string(ir::CppName(function.out.type)) + "& " + function.out.name;
      sum += "  if (sum % 3 != 0) " + function.out.name + " = static_cast<" +
             std::string(ir::CppName(function.out.type)) + ">(sum & 0xFF);\n";
    }
    const bool now = program_.schedule.now.valid() && &program_.host_functions[program_.schedule.now] == &function;
    if (now) return out + ") noexcept { return host.now; }\n";
    if (function.result != ir::Type::kNone) {
      sum += "  return static_cast<" + std::string(ir::CppName(function.result)) + ">(sum & 1);\n";
    }
    return out + ") noexcept {\n  static_cast<void>(host);\n" + sum + "}\n";
  }

  int Shell(const std::string& command) const {
    return std::system(("cd '" + work_.Path("") + "' && " + command).c_str());
  }

  ir::Program program_;
  std::vector<std::string> inputs_;
  std::vector<uint64_t> values_;
  source::SourceManager sources_;
  mutable std::vector<std::string> events_;
  driver::Workplace work_;
};

}  // namespace plcxx::emit
