// The table of what a plant is made of (elements.def), as rows.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace plcxx::plant {

enum class ElementKind : uint8_t {
#define PLCXX_PLANT_ELEMENT(Id, Text, Meaning) k##Id,
#define PLCXX_PLANT_KEY(Id, Text, Shape, Meaning, Default)
#include "transpiler/plant/elements.def"
#undef PLCXX_PLANT_ELEMENT
#undef PLCXX_PLANT_KEY
};

/// What may be the value of a key.
enum class Shape : uint8_t {
  kCondition,  // of outputs: `HYDPMP and not STOP`
  kDrive,      // a location that the plant writes
  kDrives,     // one, or a list of them
  kValues,     // a map from locations that the plant writes to whole numbers
  kLevels,     // a map from locations that the plant writes to decimal numbers
  kAmount,     // a decimal number, not below 0, or a location that is read
  kTime,       // 300 ms, 1.5 s
  kCount,      // a whole number from 1
  kNumber,     // a whole number from 0
  kDecimal,    // a number with at most three decimals
  kPositive,   // likewise, above 0
  kBit,        // 0 or 1
  kEnd,        // retracted or extended
  kCoding      // binary, gray, bcd, one-hot
};

struct ElementRow {
  ElementKind kind;
  std::string_view text;
  std::string_view meaning;  // Markdown
};
struct ElementKeyRow {
  ElementKind element;
  std::string_view text;
  Shape shape;
  std::string_view meaning;      // Markdown
  std::string_view when_absent;  // Markdown
};
inline constexpr std::string_view kNeeded = "must be there";

std::span<const ElementRow> Elements();
std::string_view NameOf(ElementKind kind);
std::vector<const ElementKeyRow*> KeysOf(ElementKind kind);
/// The words that a shape allows; empty where others may be.
std::vector<std::string_view> WordsOf(Shape shape);

}  // namespace plcxx::plant
