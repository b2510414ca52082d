// The headers that the product supplies (specification 9.1 to 9.4, 6.11), as texts in our own words.
//
// The system header is made from machine.def and functions.def; the standard headers declare what 6.11 makes available
// and the types and macros that must exist so that a use is refused where it stands.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plcxx::hnc {

/// `abs` keeps the type of its argument (--set abs=long) or takes an int.
enum class AbsMeaning : uint8_t { kInt, kLong };

/// The names that give the system header, without the one of --set system-header. Any case.
bool IsSystemHeaderName(std::string_view name);

std::string SystemHeader(AbsMeaning abs);
/// A variable, macro or function of it.
bool IsNameOfSystemHeader(std::string_view name);
/// Declarations of all variables and functions of the headers with a prefix in front of their names: what they are,
/// whether or not a header is included.
std::string ExpectedDeclarations(std::string_view prefix);
/// None when there is no such standard header. Any case.
std::optional<std::string> StandardHeader(std::string_view name, AbsMeaning abs);

/// A name of which every use is refused, declared or not: the library functions of 6.11 that are not available.
enum class RefusedKind : uint8_t {
  kMemory,
  kInputOutput,
  kHardware,
  kNonLocalJump,
  kTime,
  kVariableArgument,
  kLibrary
};
std::optional<RefusedKind> RefusedFunction(std::string_view name);

}  // namespace plcxx::hnc
