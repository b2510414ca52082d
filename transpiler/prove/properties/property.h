// Properties of a machine, as a person writes them, and what they are as data.
//
// A property speaks about the state after each period of the control: a condition that always or never holds, one that
// holds a while after another one, or an output that can always still be moved. In a file each line is one property.
// The grammar is grammars/property.ebnf. Not its job: proving (check.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::prove::properties {

/// What a location of a property is, in cells of the program.
struct PropertyOperand {
  std::string text;  // as the property writes it
  std::vector<execute::CellId>
      cells;            // from the least significant bit, or one field; none: always 0, the program has no such
  uint8_t width = 1;    // of the value, 1 to 64 bits
  uint8_t low_bit = 0;  // of the cells; with a width of 1 it is one bit of a word
  bool is_bit = false;
  bool has_sign = false;  // its value is read as two's complement
};

enum class ConditionKind : uint8_t {
  kOperand,     // a bit
  kNumber,      // `low`
  kNot,         // of the child
  kAnd,         // of the children
  kOr,          // of the children
  kEqual,       // two children, values
  kLess,        // two children, values
  kRange,       // the child, a value, is in low..high
  kAtMostOne,   // of the children
  kExactlyOne,  // of the children
  kHeld         // the child has held in the last `periods` periods, the present one included
};

struct Condition {
  ConditionKind kind{};
  std::vector<uint32_t> children;  // indices of Property::conditions
  uint32_t operand = 0;            // of kOperand: index of Property::operands
  int64_t low = 0, high = 0;
  uint32_t periods = 0;
};

enum class PropertyKind : uint8_t {
  kAlways,  // `condition` holds after every period
  /// When `condition` holds after a period, `consequence` holds after that one or one of the `periods` - 1 after it:
  /// "set: ..., run: {slow: periods}" of a scenario is time enough.
  kResponse,
  /// From every state that can be reached, some inputs make operand 0 a 1 within `periods` periods, and some make it
  /// a 0.
  kNeverStuck
};

struct Property {
  PropertyKind kind{};
  std::string text;  // without comment
  uint32_t line = 0, column = 0;
  std::vector<Condition> conditions;
  std::vector<PropertyOperand> operands;
  uint32_t condition = 0, consequence = 0;
  uint32_t periods = 1;
};

/// How long the words of a property are.
struct PropertyTiming {
  uint32_t period_ms = 10;       // of one period
  uint32_t slow_periods = 1;     // periods until a slow pass is complete
  uint32_t fast_periods = 1;     // periods until a fast pass is complete
  uint32_t fast_per_period = 1;  // fast passes in one period
};

enum class PropertyFault : uint8_t {
  kSyntax,     // found, what was expected
  kLocation,   // the word that is no location
  kNotMemory,  // the location, what it is
  kBitNeeded,  // the location, what wants a bit
  kNoFit,      // the value, the location, what it takes
  kRange,      // low, high
  kTooLong,    // the duration, its periods, the most
  kNothing     // there is no property
};

struct PropertyError {
  uint32_t line = 0, column = 0, length = 1;  // 1-based, of the first line given; columns and length in bytes
  PropertyFault fault{};
  std::vector<std::string> words;  // as told above
};

/// A location that a property may name, or what it is instead: "a text input"; lower case.
using LocatedOperand = std::variant<PropertyOperand, std::string>;

struct PropertyContext {
  /// None: the word is no location.
  std::function<std::optional<LocatedOperand>(std::string_view word)> locate;
  /// None: the word is no number.
  std::function<std::optional<int64_t>(std::string_view word)> number;
  PropertyTiming timing;
};

/// The longest time that a property may speak about, in periods.
inline constexpr uint32_t kMostPropertyPeriods = 5000;
/// Of "is never stuck" without "within".
inline constexpr uint32_t kStuckPeriods = 10;

struct Properties {
  std::vector<Property> properties;
  std::vector<PropertyError> errors;  // one for each line at most
};

/// One property a line; "#" at the beginning of a line or after a blank begins a comment.
Properties ParseProperties(std::string_view text, const PropertyContext& context);

}  // namespace plcxx::prove::properties
