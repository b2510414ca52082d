// What single stores change: bits of a cell, words of the dispatcher. For warnings and for the lists of a report.
#pragma once

#include <optional>

#include "transpiler/dialects/hnc/analysis/facts.h"

namespace plcxx::hnc {

/// Which bits of a cell a store changes; all of them where constants do not tell.
struct ChangedBits {
  ObjectId object;
  int64_t offset = 0;
  uint32_t size = 0;  // bytes, 1 to 8
  uint64_t mask = 0;
};
/// None where the address is not constant.
std::optional<ChangedBits> ChangedBy(const Unit& unit, const Facts& facts, const Expr& store);

/// The word of G that an lvalue names for channel 0, and whether the channel is computed.
struct ModWord {
  int64_t word = 0;
  bool computed = false;
};
inline constexpr int64_t kFirstModWord = 170, kChannelWords = 20;  // of G; one word for M, S, T, B each (5.4)
std::optional<ModWord> WordOfG(const Unit& unit, const Objects& objects, const Facts& facts, ExprId lvalue);

}  // namespace plcxx::hnc
