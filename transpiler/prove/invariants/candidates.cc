#include "transpiler/prove/invariants/candidates.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "transpiler/ir/constants.h"
#include "transpiler/ir/op.h"
#include "transpiler/support/low_bits.h"

namespace plcxx::prove::invariants {
namespace {

constexpr uint8_t kAlwaysZero = 1, kAlwaysOne = 8;    // of a bit with itself
constexpr uint8_t kAlike = 1 | 8, kOpposite = 2 | 4;  // of two bits
constexpr size_t kMostValues = 12;                    // of a byte or field that is said to take few
constexpr size_t kMostWhile = 3;                      // of those, while a bit is set or not
constexpr uint64_t kMostNumbered = 255;    // by which steps and states are counted; a time takes many more values
constexpr size_t kMostLimits = 6;          // that a number is guessed to stay below
constexpr size_t kMostLimitsWhile = 16;    // of one number
constexpr size_t kMostConstants = 100;     // of a program that limits are guessed from
constexpr size_t kMostInSteps = 48;        // numbers that may be steps, or are counted in them
constexpr size_t kMostLimitsInSteps = 24;  // of one number

}  // namespace

Candidates::Candidates(const machine::Version& version, std::span<const execute::CellId> cells,
                       const std::function<bool(execute::CellId)>& is_state) {
  const std::set<execute::CellId> interesting(cells.begin(), cells.end());
  std::set<uint32_t> bytes_taken;
  for (const execute::CellId id : interesting) {
    const execute::Cell cell = execute::CellAt(*version.program, version.cells, id);
    if (cell.kind == execute::CellKind::kCalls) continue;
    const uint8_t width = execute::CellWidth(*version.program, cell);
    if (cell.kind == execute::CellKind::kField && width > 1) {
      numbers_.push_back({.cells = {id}, .width = width, .values = {}});
      continue;
    }
    if (bits_.size() < kMostBits) bits_.push_back(id);
    if (cell.kind != execute::CellKind::kBit || !bytes_taken.insert(id.index - cell.bit).second) continue;
    std::vector<execute::CellId> byte;
    for (uint32_t bit = 8; bit-- > 0;) byte.emplace_back(id.index - cell.bit + bit);
    if (std::ranges::all_of(byte, is_state)) numbers_.push_back({.cells = std::move(byte), .values = {}});
  }
  AddWords(version, interesting, is_state);
  seen_pairs_.assign(bits_.size() * bits_.size(), 0);
  for (SeenNumber& number : numbers_) {
    number.greatest_ones.assign(bits_.size(), 0);
    number.greatest_zeros.assign(bits_.size(), 0);
  }
}

void Candidates::AddWords(const machine::Version& version, const std::set<execute::CellId>& interesting,
                          const std::function<bool(execute::CellId)>& is_state) {
  std::set<execute::CellId> taken;  // a word at each of them
  for (const ir::Place& place : version.program->places) {
    const bool is_word = !place.is_field() && !place.indexed && ir::Bytes(place.type) > 1 &&
                         place.type <= ir::Type::kI64 && execute::IsInside(*version.program, place);
    if (!is_word) continue;
    std::vector<execute::CellId> cells = execute::CellsOf(*version.program, version.cells, place);
    const bool is_of_interest =
        std::ranges::any_of(cells, [&](execute::CellId cell) { return interesting.contains(cell); });
    if (!is_of_interest || !std::ranges::all_of(cells, is_state) || !taken.insert(cells.front()).second) continue;
    std::ranges::reverse(cells);
    numbers_.push_back(
        {.cells = std::move(cells), .width = static_cast<uint8_t>(8 * ir::Bytes(place.type)), .values = {}});
  }
}

void Candidates::AddState(const CellValues& state) {
  std::bitset<kMostBits> ones, zeros;
  for (size_t i = 0; i < bits_.size(); ++i) ((state(bits_[i]) & 1) != 0 ? ones : zeros).set(i);
  for (size_t i = 0; i < bits_.size(); ++i) {
    for (size_t j = i; j < bits_.size(); ++j)
      seen_pairs_[i * bits_.size() + j] |= static_cast<uint8_t>(1U << ((ones[i] ? 2 : 0) + (ones[j] ? 1 : 0)));
  }
  for (SeenNumber& number : numbers_) {
    const uint64_t value = NumberOf(number.cells, state);
    number.greatest = std::max(number.greatest, value);
    for (size_t i = 0; i < bits_.size(); ++i) {
      uint64_t& greatest = (ones[i] ? number.greatest_ones : number.greatest_zeros)[i];
      greatest = std::max(greatest, value);
    }
    auto seen = std::ranges::find(number.values, value, &SeenValue::value);
    if (seen == number.values.end()) {
      if (number.values.size() > kMostValues) continue;
      seen = number.values.insert(seen, {.value = value, .ones = {}, .zeros = {}});
    }
    seen->ones |= ones;
    seen->zeros |= zeros;
  }
  AddSteps(state);
}

void Candidates::AddSteps(const CellValues& state) {
  const size_t count = std::min(numbers_.size(), kMostInSteps);
  std::vector<uint64_t> values;
  for (size_t i = 0; i < count; ++i) values.push_back(NumberOf(numbers_[i].cells, state));
  for (size_t i = 0; i < count; ++i) {
    SeenNumber& step = numbers_[i];
    if (step.values.size() > kMostValues) continue;
    const size_t at = std::ranges::find(step.values, values[i], &SeenValue::value) - step.values.begin();
    step.greatest_of.resize(std::max(step.greatest_of.size(), at + 1), std::vector<uint64_t>(count));
    for (size_t j = 0; j < count; ++j) step.greatest_of[at][j] = std::max(step.greatest_of[at][j], values[j]);
  }
}

void Candidates::AddConstantsOf(const ir::Program& program) {
  // A term may have them bit by bit only.
  std::set<uint64_t> constants;
  ir::ForEachNumber(program, [&constants](uint64_t number) { constants.insert(number); });
  // In a large program most of them belong to something else.
  if (constants.size() > kMostConstants) return;
  for (const uint64_t constant : constants) AddNeighbours(program_limits_, constant);
}

void Candidates::AddBits(std::vector<Invariant>& guesses) const {
  for (size_t i = 0; i < bits_.size(); ++i) {
    const uint8_t own = seen_pairs_[i * bits_.size() + i];
    if (own == kAlwaysZero || own == kAlwaysOne) {
      guesses.push_back({.cells = {bits_[i]}, .values = {own == kAlwaysZero ? uint64_t{0} : uint64_t{1}}});
      continue;
    }
    bool is_said = false;  // that it is the same as another one, or the opposite
    for (size_t j = i + 1; j < bits_.size(); ++j) {
      const uint8_t other = seen_pairs_[j * bits_.size() + j];
      if (other == kAlwaysZero || other == kAlwaysOne) continue;
      const uint8_t both = seen_pairs_[i * bits_.size() + j];
      // Asked alone, before all others; a chain of them says it of all that are alike.
      if ((both == kAlike || both == kOpposite) && !std::exchange(is_said, true)) {
        guesses.push_back({.cells = {bits_[i], bits_[j]},
                           .values = both == kAlike ? std::vector<uint64_t>{0, 3} : std::vector<uint64_t>{1, 2}});
      }
      for (uint64_t combination = 0; combination < 4; ++combination) {
        if ((both >> combination & 1) != 0) continue;
        guesses.push_back({.cells = {bits_[i], bits_[j]}, .values = {combination}, .kind = Invariant::Kind::kNoneOf});
      }
    }
  }
}

void Candidates::AddLimits(const SeenNumber& number, std::vector<Invariant>& guesses) const {
  const uint64_t most = support::LowBits(number.width);
  std::set<uint64_t> nearest;
  for (const std::set<uint64_t>* limits : {&limits_, &program_limits_}) {
    size_t count = 0;
    for (auto limit = limits->lower_bound(number.greatest);
         limit != limits->end() && *limit < most && count < kMostLimits; ++limit, ++count) {
      nearest.insert(*limit);
    }
  }
  for (const uint64_t limit : nearest)
    guesses.push_back({.cells = number.cells, .values = {limit}, .kind = Invariant::Kind::kAtMost});
}

void Candidates::AddLimitsWhile(const SeenNumber& number, std::vector<Invariant>& guesses) const {
  size_t count = 0;
  for (size_t bit = 0; bit < bits_.size(); ++bit) {
    if (std::ranges::find(number.cells, bits_[bit]) != number.cells.end()) continue;
    const uint8_t own = seen_pairs_[bit * bits_.size() + bit];
    if (own != (kAlwaysZero | kAlwaysOne)) continue;
    for (const bool is_set : {true, false}) {
      const uint64_t greatest = (is_set ? number.greatest_ones : number.greatest_zeros)[bit];
      // The bounds of small ones are among their values.
      if (greatest >= number.greatest || greatest <= kMostWhile) continue;
      std::optional<uint64_t> nearest;
      for (const std::set<uint64_t>* const limits : {&limits_, &program_limits_}) {
        const auto limit = limits->lower_bound(greatest);
        if (limit != limits->end() && *limit < number.greatest) nearest = std::min(nearest.value_or(*limit), *limit);
      }
      if (!nearest || ++count > kMostLimitsWhile) continue;
      guesses.push_back({.cells = number.cells,
                         .values = {*nearest},
                         .kind = Invariant::Kind::kAtMost,
                         .while_cells = {bits_[bit]},
                         .while_value = is_set ? 1U : 0U});
    }
  }
}

void Candidates::AddLimitsInSteps(std::vector<Invariant>& guesses) const {
  const auto overlap = [](const SeenNumber& a, const SeenNumber& b) {
    return std::ranges::find_first_of(a.cells, b.cells) != a.cells.end();
  };
  for (size_t j = 0; j < std::min(numbers_.size(), kMostInSteps); ++j) {
    const SeenNumber& number = numbers_[j];
    size_t count = 0;
    for (const SeenNumber& step : numbers_) {
      // Of two values one is a bit's.
      const bool is_step = step.values.size() > 2 && step.values.size() <= kMostValues && !step.greatest_of.empty();
      if (!is_step || overlap(step, number)) continue;
      for (size_t at = 0; at < step.greatest_of.size() && count < kMostLimitsInSteps; ++at) {
        const uint64_t greatest = step.greatest_of[at][j];
        if (greatest >= number.greatest) continue;
        std::optional<uint64_t> nearest;
        for (const std::set<uint64_t>* const limits : {&limits_, &program_limits_}) {
          const auto limit = limits->lower_bound(greatest);
          if (limit != limits->end() && *limit < number.greatest) nearest = std::min(nearest.value_or(*limit), *limit);
        }
        if (!nearest) continue;
        ++count;
        guesses.push_back({.cells = number.cells,
                           .values = {*nearest},
                           .kind = Invariant::Kind::kAtMost,
                           .while_cells = step.cells,
                           .while_value = step.values[at].value});
      }
    }
  }
}

void Candidates::AddWhile(const SeenNumber& number, std::vector<Invariant>& guesses) const {
  if (number.values.size() < 2) return;
  for (size_t bit = 0; bit < bits_.size(); ++bit) {
    if (std::ranges::find(number.cells, bits_[bit]) != number.cells.end()) continue;
    for (const bool is_set : {true, false}) {
      std::vector<uint64_t> values;
      for (const SeenValue& seen : number.values) {
        if ((is_set ? seen.ones : seen.zeros)[bit]) values.push_back(seen.value);
      }
      // With none the bit never has that value, with all nothing is said.
      if (values.empty() || values.size() > kMostWhile || values.size() == number.values.size()) continue;
      guesses.push_back({.cells = number.cells,
                         .values = std::move(values),
                         .while_cells = {bits_[bit]},
                         .while_value = is_set ? 1U : 0U});
    }
  }
}

std::vector<Invariant> Candidates::Make() const {
  std::vector<Invariant> guesses;
  AddBits(guesses);
  for (const SeenNumber& number : numbers_) {
    AddLimits(number, guesses);
    AddLimitsWhile(number, guesses);
    if (number.values.size() > kMostValues || number.greatest > kMostNumbered) continue;
    AddWhile(number, guesses);
    std::set<uint64_t> values;
    for (const SeenValue& seen : number.values) values.insert(seen.value);
    guesses.push_back({.cells = number.cells, .values = {values.begin(), values.end()}});
  }
  AddLimitsInSteps(guesses);
  return guesses;
}

}  // namespace plcxx::prove::invariants
