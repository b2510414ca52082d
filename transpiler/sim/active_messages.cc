#include "transpiler/sim/active_messages.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

namespace plcxx::sim {

namespace {

constexpr uint32_t kByteBits = 8;

/// Observed in each period of each run: eight bytes at once, and nothing is done for a bit that is 0.
void AddNumbersOf(const ir::Program& program, Engine& engine, const ir::MessageBits& stretch,
                  std::vector<uint32_t>& numbers) {
  const bool is_little = program.spaces[stretch.space].order == ir::ByteOrder::kLittle;
  for (uint32_t first = 0; first < stretch.count;) {
    const uint32_t left = stretch.count - first;
    const ir::Type type = is_little && left >= kByteBits * ir::Bytes(ir::Type::kI64) ? ir::Type::kI64 : ir::Type::kI8;
    const uint32_t offset = stretch.offset + first / kByteBits;
    uint64_t bits = engine.Read({.type = type, .space = stretch.space, .offset = offset});
    if (left < kByteBits) bits &= (uint64_t{1} << left) - 1;
    for (; bits != 0; bits &= bits - 1) {
      numbers.push_back(stretch.first_number + first + static_cast<uint32_t>(std::countr_zero(bits)));
    }
    first += kByteBits * ir::Bytes(type);
  }
}

}  // namespace

std::vector<uint32_t> ActiveMessages(const ir::Program& program, Engine& engine) {
  std::vector<uint32_t> numbers;
  for (const ir::MessageBits& stretch : program.message_bits) AddNumbersOf(program, engine, stretch, numbers);
  for (const ir::MessageWord& word : program.message_words) {
    const auto number = static_cast<uint32_t>(engine.Read(program.places[word.place]));
    if (number != 0) numbers.push_back(number);
  }
  std::ranges::sort(numbers);
  const auto repeated = std::ranges::unique(numbers);
  numbers.erase(repeated.begin(), repeated.end());
  return numbers;
}

void MessageTracker::Observe(Engine& engine) {
  std::vector<uint32_t> now = ActiveMessages(program_, engine);
  std::ranges::set_difference(now, active_, std::back_inserter(entered_));
  active_ = std::move(now);
}

std::vector<uint32_t> MessageTracker::TakeEntered() { return std::exchange(entered_, {}); }

}  // namespace plcxx::sim
