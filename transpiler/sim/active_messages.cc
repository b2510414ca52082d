#include "transpiler/sim/active_messages.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace plcxx::sim {

std::vector<uint32_t> ActiveMessages(const ir::Program& program, Engine& engine) {
  std::vector<uint32_t> numbers;
  for (const ir::MessageBits& stretch : program.message_bits) {
    ir::Place byte{.type = ir::Type::kI8, .space = stretch.space};
    for (uint32_t first = 0; first < stretch.count; first += 8) {
      byte.offset = stretch.offset + first / 8;
      const uint64_t bits = engine.Read(byte);
      for (uint32_t bit = 0; bit < 8 && first + bit < stretch.count; ++bit) {
        if ((bits >> bit & 1) != 0) numbers.push_back(stretch.first_number + first + bit);
      }
    }
  }
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
