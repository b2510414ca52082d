// Names that only the product writes into the text that Clang reads (set_up.cc, filter_tokens.cc).
#pragma once

#include <string_view>

namespace plcxx::hnc {

inline constexpr std::string_view kProductPrefix = "__plcxx_";
inline constexpr std::string_view kCliName = "__plcxx_cli";
inline constexpr std::string_view kStiName = "__plcxx_sti";
inline constexpr std::string_view kPoisonName = "__plcxx_poison";
/// In front of the name of a variable or function of the headers: its declaration whether or not it is included.
inline constexpr std::string_view kExpectedPrefix = "__plcxx_of_";

}  // namespace plcxx::hnc
