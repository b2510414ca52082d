// A program that notes what it reaches does what it did, and its notes say what the simulator says was given.
#include "transpiler/soak/notes.h"

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "tests/reference/random_program.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/temporary_directory.h"
#include "tests/volume.h"
#include "transpiler/ir/verifier.h"
#include "transpiler/scenarios/program.h"
#include "transpiler/scenarios/property_machine.h"
#include "transpiler/scenarios/property_monitor.h"
#include "transpiler/scenarios/property_places.h"
#include "transpiler/scenarios/scenario.h"
#include "transpiler/sim/simulator.h"

namespace plcxx::soak {
namespace {

using testing_support::Volume;

/// The program as it was and the one with notes, side by side, with the same inputs.
class SideBySide {
 public:
  SideBySide(const scenarios::ProveMachine& machine, const WatchPlan& plan, uint64_t seed)
      : goals_(machine.compilation.program),
        noted_(NoteReached(goals_, plan)),
        program_(machine.compilation.program),
        before_(program_),
        after_(noted_.program),
        given_(program_.insts.size()),
        random_(seed) {
    before_.NoteGiven(given_);
    for (const ir::Loop& loop : program_.loops) {
      if (loop.condition.valid()) conditions_.insert(program_.regions[loop.condition].insts.back().index);
    }
  }

  const NotedProgram& noted() const { return noted_; }
  sim::Simulator& before() { return before_; }
  bool IsNoted(size_t mark) { return after_.Read(noted_.PlaceOf(mark)) != 0; }

  void PowerOn() {
    before_.PowerOn();
    after_.PowerOn();
  }
  void RunPeriod() {
    for (uint32_t p = 0; p < program_.places.size(); ++p) {
      const ir::Place& place = program_.places[ir::PlaceId(p)];
      if (place.is_field() || place.indexed || !program_.spaces[place.space].host_visible || !random_.OneIn(8))
        continue;
      if (place.type == ir::Type::kF32 || place.type == ir::Type::kF64) continue;
      const uint64_t value = random_.OneIn(2) ? random_.Below(8) : random_.Next();
      before_.Write(place, value);
      after_.Write(place, value);
    }
    now_ms_ += program_.schedule.period_ms;
    before_.RunPeriod(now_ms_);
    after_.RunPeriod(now_ms_);
  }
  void ExpectTheSame() {
    for (uint32_t s = 0; s < program_.spaces.size(); ++s) {
      const ir::SpaceId space(s);
      if (!program_.spaces[space].host_visible) continue;
      const auto one = before_.Memory(space), other = after_.Memory(space);
      EXPECT_TRUE(std::ranges::equal(one, other)) << program_.spaces[space].name;
    }
    EXPECT_EQ(before_.TakeEvents(), after_.TakeEvents());
    for (size_t i = 0; i < noted_.marks.size(); ++i) {
      const Mark& mark = noted_.marks[i];
      if (mark.property) continue;
      const bool was_given = (given_[mark.inst.index] & mark.given) != 0;
      const bool is_left_out = conditions_.contains(mark.inst.index);
      EXPECT_EQ(IsNoted(i), was_given && !is_left_out) << "mark " << i << ", instruction " << mark.inst.index;
    }
  }

 private:
  Goals goals_;
  NotedProgram noted_;
  const ir::Program& program_;
  sim::Simulator before_, after_;
  std::vector<uint8_t> given_;
  std::set<uint32_t> conditions_;
  reference::Random random_;
  uint32_t now_ms_ = 0;
};

TEST(Notes, SayWhatWasGiven) {
  for (const reference::ReferenceDialect& dialect : reference::ReferenceDialects()) {
    for (uint64_t seed = 1; seed <= Volume<uint64_t>(6, 200); ++seed) {
      SCOPED_TRACE(std::string(dialect.name) + ", seed " + std::to_string(seed));
      reference::Random random(seed);
      const reference::RandomProgram program =
          dialect.generate(random, reference::ProgramSize::kSmall, reference::Spelling::kPlain);
      const testing_support::TemporaryDirectory directory;
      const scenarios::ScenarioOrErrors read = reference::WriteRandom(program, dialect, directory.path().string());
      ASSERT_TRUE(std::holds_alternative<scenarios::Scenario>(read));
      scenarios::ProveMachine machine;
      scenarios::MakeProveMachine(scenarios::RequestOf(std::get<scenarios::Scenario>(read), {}), machine);
      ASSERT_TRUE(machine.compilation.ok());
      const WatchPlan plan(machine, {});
      SideBySide both(machine, plan, seed);
      EXPECT_FALSE(both.noted().marks.empty());
      both.PowerOn();
      for (int period = 0; period < 60 && !testing::Test::HasFailure(); ++period) both.RunPeriod();
      both.ExpectTheSame();
    }
  }
}

constexpr const char* kProgram = R"($
U4A0 = I0A0
U4A1 = I0A0*I0A1
U4A2 = I0A2+I0A3
W5A0 = W1A0
)";
/// Of one moment but for the last two.
constexpr const char* kProperties = R"(never U4A0 and U4A1
U4A1 implies U4A2
at most one of U4A0, U4A1, U4A2
exactly one of U4A0, U4A1, U4A2
W5A0 < 200
W5A0 in 3..100
W5A0 is 7 or not U4A2
U4A0 is U4A2
)";

TEST(Notes, SayWhichPropertiesDidNotHold) {
  compilation::CompilationRequest request;
  request.sources = {"machine.plc"};
  request.texts["machine.plc"] = kProgram;
  scenarios::ProveMachine machine;
  scenarios::MakeProveMachine(request, machine);
  ASSERT_TRUE(machine.compilation.ok());
  compilation::Compilation& compilation = machine.compilation;
  const prove::properties::PropertyContext context =
      scenarios::PropertyContextOf(*compilation.dialect, compilation.program, machine.version.cells, machine.timing);
  std::vector<prove::properties::Property> properties;
  for (scenarios::PlacedProperty& one :
       scenarios::PropertiesOfFile("machine.prop", kProperties, compilation.dialect->name, context,
                                   *compilation.sources, compilation.diagnostics)) {
    properties.push_back(std::move(one.property));
  }
  ASSERT_EQ(properties.size(), 8U);
  const WatchPlan plan(machine, properties);
  size_t violated = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SideBySide both(machine, plan, seed);
    both.PowerOn();
    std::vector<scenarios::PropertyMonitor> monitors;
    for (const prove::properties::Property& property : properties) {
      monitors.emplace_back(plan.program(), plan.cells(), std::vector<prove::properties::Property>{property});
      monitors.back().PowerOn();
    }
    // Few enough that each property holds in some of the runs.
    for (int period = 0; period < 3; ++period) {
      both.RunPeriod();
      for (auto& monitor : monitors) monitor.AfterPart(both.before(), sim::Clock::Part::kWholePeriod);
    }
    both.ExpectTheSame();
    size_t marks = 0;
    for (size_t i = 0; i < both.noted().marks.size(); ++i) {
      const Mark& mark = both.noted().marks[i];
      if (!mark.property) continue;
      ++marks;
      EXPECT_EQ(both.IsNoted(i), monitors[*mark.property].violation().has_value()) << properties[*mark.property].text;
      violated += both.IsNoted(i) ? 1 : 0;
    }
    EXPECT_EQ(marks, properties.size());
  }
  EXPECT_GT(violated, 40U);
  EXPECT_LT(violated, 40U * properties.size());
}

}  // namespace
}  // namespace plcxx::soak
