// Numbers and times as plant.yaml and panel.yaml write them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace plcxx::plant {

/// -12, 0x1F. None: it is none, or does not fit.
std::optional<int64_t> WholeNumber(std::string_view text);

/// In thousandths: "1.25" is 1250. At most three decimals, at most a thousand million.
std::optional<int64_t> Thousandths(std::string_view text);

inline constexpr uint64_t kMaxTimeMs = 3'600'000;
/// "300 ms", "300ms", "1.5 s", "2 min"; a number alone is milliseconds. At most an hour.
std::optional<uint64_t> Milliseconds(std::string_view text);

}  // namespace plcxx::plant
