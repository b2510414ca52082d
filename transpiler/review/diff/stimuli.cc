#include "transpiler/review/diff/stimuli.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "transpiler/ir/constants.h"
#include "transpiler/ir/op.h"
#include "transpiler/prove/machine/transition.h"

namespace plcxx::review::diff {
namespace {

constexpr size_t kMostChanged = 8;                // constants of one version that are looked at
constexpr uint64_t kLongestMs = 2 * 60 * 60'000;  // no preset of a machine is watched for longer
constexpr uint64_t kPieceMs = 10'000;             // of a wait, so that a search can end in time
constexpr uint64_t kHalvesWatched = 6;            // of the time between two presets, from the shorter one on
constexpr uint32_t kMostCounts = 1000;
constexpr size_t kMostPresets = 12;     // different constants, when none was changed
constexpr uint64_t kHeadstartMs = 200;  // for what comes before a timer

/// What declared data are when power comes, each as wide as the program reads it: presets stand there, too.
std::vector<uint64_t> InitialWordsOf(const prove::machine::Version& version) {
  const ir::Program& program = *version.program;
  std::map<std::tuple<uint32_t, uint32_t, uint32_t>, uint64_t> words;  // by space, offset and number of bytes
  for (const ir::Place& place : program.places) {
    if (place.is_field() || place.indexed || place.type == ir::Type::kBit || !execute::IsInside(program, place))
      continue;
    const ir::Space& space = program.spaces[place.space];
    uint64_t value = 0;
    uint32_t bit = 0;
    for (const execute::CellId id : execute::CellsOf(program, version.cells, place)) {
      const execute::Cell cell = execute::CellAt(program, version.cells, id);
      value |= uint64_t{prove::machine::PowerOnBit(space, cell.offset, cell.bit)} << bit++;
    }
    if (value != 0) words[{place.space.index, place.offset, ir::Bytes(place.type)}] = value;
  }
  std::vector<uint64_t> values;
  for (const auto& [where, value] : words) values.push_back(value);
  return values;
}

/// Ascending, each as often as it stands there.
std::vector<uint64_t> ConstantsOf(const prove::machine::Version& version) {
  std::vector<uint64_t> constants = InitialWordsOf(version);
  ir::ForEachNumber(*version.program, [&constants](uint64_t number) { constants.push_back(number); });
  std::ranges::sort(constants);
  return constants;
}

/// The milliseconds that one unit of a preset may be.
std::set<uint64_t> UnitsOf(const ir::Program& program) {
  std::set<uint64_t> units{1, 10, 20, 100, 1000, 60'000};
  units.insert(std::max<uint64_t>(1, program.schedule.period_ms));
  for (const ir::Routine& routine : program.routines) {
    units.insert(std::max<uint64_t>(1, uint64_t{program.schedule.period_ms} * routine.slices));
  }
  return units;
}

/// Of a preset that carries its unit: three decades, in bits 13 and 12 the power of ten of their milliseconds.
uint64_t TimeWordMs(uint64_t word) {
  uint64_t ms = (word >> 8 & 15) * 100 + (word >> 4 & 15) * 10 + (word & 15);
  for (uint64_t scale = word >> 12 & 3; scale > 0; --scale) ms *= 10;
  return ms;
}

}  // namespace

std::vector<prove::diff::SetCell> RandomInputs(terms::Random& random, std::vector<prove::diff::SetCell> inputs,
                                               int run) {
  constexpr std::array<uint32_t, 5> kEighths = {7, 4, 1, 6, 2};
  const uint32_t density = kEighths[static_cast<size_t>(run) % kEighths.size()];
  for (prove::diff::SetCell& input : inputs) input.value = (random.Next() >> 7) % 8 < density ? 1 : 0;
  return inputs;
}

std::vector<prove::diff::SetCell> AlmostTheSame(terms::Random& random, std::vector<prove::diff::SetCell> inputs) {
  for (uint64_t i = random.Next() % 3; i > 0; --i) inputs[(random.Next() >> 7) % inputs.size()].value ^= 1;
  return inputs;
}

ChangedConstants FindChangedConstants(const prove::machine::Version& old_version,
                                      const prove::machine::Version& new_version) {
  const std::vector<uint64_t> old_constants = ConstantsOf(old_version), new_constants = ConstantsOf(new_version);
  std::vector<uint64_t> gone, come;
  std::ranges::set_difference(old_constants, new_constants, std::back_inserter(gone));
  std::ranges::set_difference(new_constants, old_constants, std::back_inserter(come));
  ChangedConstants changed{.times_ms = {}, .are_any = !gone.empty() || !come.empty()};
  if (gone.size() > kMostChanged || come.size() > kMostChanged) return changed;
  const std::set<uint64_t> units = UnitsOf(*old_version.program);
  std::set<uint32_t> times;
  const auto add_until = [&times](uint64_t preset, uint64_t unit) {
    times.insert(static_cast<uint32_t>(preset * unit * 9 / 8 + kHeadstartMs));
  };
  if (gone.empty() && come.empty()) {
    // Something else was changed about a timer, perhaps: until a little after each preset.
    const std::set<uint64_t> presets(old_constants.begin(), old_constants.end());
    for (const uint64_t preset : presets) {
      for (const uint64_t unit : units) {
        if (preset == 0 || presets.size() > kMostPresets || preset > kLongestMs / unit) continue;
        add_until(preset, unit);
      }
    }
  }
  const auto add_between = [&times](uint64_t one, uint64_t other, uint64_t unit) {
    const auto [low, high] = std::minmax(one, other);
    if (high > kLongestMs / unit) return;
    // A timer may start some scans late, and what follows from it may need some more.
    for (uint64_t half = 1; half <= kHalvesWatched; ++half) {
      times.insert(static_cast<uint32_t>((2 * low + half * (high - low)) * unit / 2));
    }
  };
  // One that only went, or only came, is the end of something that is there in one version.
  for (const std::vector<uint64_t>* const constants : {&gone, &come}) {
    for (const uint64_t constant : *constants) {
      if (constant <= kMostCounts) changed.counts = std::max(changed.counts, static_cast<uint32_t>(constant));
      for (const uint64_t unit : units) {
        if ((gone.empty() || come.empty()) && constant <= kLongestMs / unit) add_until(constant, unit);
      }
    }
  }
  for (const uint64_t before : gone) {
    for (const uint64_t after : come) {
      const uint64_t greater = std::max(before, after);
      for (const uint64_t unit : units) add_between(before, after, unit);
      if (greater <= 0xFFFF) add_between(TimeWordMs(before), TimeWordMs(after), 1);
    }
  }
  changed.times_ms.assign(times.begin(), times.end());
  return changed;
}

Stimuli HoldStimuli(std::vector<prove::diff::SetCell> inputs, int run, const std::vector<uint32_t>& times_ms) {
  constexpr std::array<uint64_t, 6> kPatience = {30'000, 30'000, 15 * 60'000, 30'000, 15 * 60'000, kLongestMs};
  const uint64_t longest = kPatience[static_cast<size_t>(run) % kPatience.size()];
  Stimuli stimuli{{.inputs = std::move(inputs), .words = {}, .slow = 1}};
  std::set<uint32_t> ends{500, 1500, 3500, 8500, 28'500};
  ends.insert(times_ms.begin(), times_ms.end());
  uint32_t now = 0;
  for (const uint32_t end : ends) {
    if (end > longest) break;
    while (now < end) {
      const auto ms = static_cast<uint32_t>(std::min<uint64_t>(end - now, kPieceMs));
      stimuli.push_back({.inputs = {}, .words = {}, .slow = 0, .ms = ms});
      now += ms;
    }
  }
  return stimuli;
}

Stimuli PulseStimuli(terms::Random& random, const std::vector<prove::diff::SetCell>& inputs, int run, uint32_t count) {
  Stimuli stimuli{{.inputs = RandomInputs(random, inputs, run), .words = {}, .slow = 1}};
  prove::diff::SetCell pulse = stimuli.front().inputs[random.Next() % inputs.size()];
  for (uint32_t i = 0; i < 2 * count; ++i) {
    pulse.value ^= 1;
    stimuli.push_back({.inputs = {pulse}, .words = {}, .slow = 1});
  }
  return stimuli;
}

}  // namespace plcxx::review::diff
