#include "transpiler/plant/elements.h"

namespace plcxx::plant {
namespace {

constexpr ElementRow kElements[] = {
#define PLCXX_PLANT_ELEMENT(Id, Text, Meaning) {ElementKind::k##Id, Text, Meaning},
#define PLCXX_PLANT_KEY(Id, Text, ShapeOf, Meaning, Default)
#include "transpiler/plant/elements.def"
#undef PLCXX_PLANT_ELEMENT
#undef PLCXX_PLANT_KEY
};

constexpr ElementKeyRow kKeys[] = {
#define PLCXX_PLANT_ELEMENT(Id, Text, Meaning)
#define PLCXX_PLANT_KEY(Id, Text, ShapeOf, Meaning, Default) \
  {ElementKind::k##Id, Text, Shape::ShapeOf, Meaning, Default},
#include "transpiler/plant/elements.def"
#undef PLCXX_PLANT_ELEMENT
#undef PLCXX_PLANT_KEY
};

}  // namespace

std::span<const ElementRow> Elements() { return kElements; }

std::string_view NameOf(ElementKind kind) { return kElements[static_cast<size_t>(kind)].text; }

std::vector<const ElementKeyRow*> KeysOf(ElementKind kind) {
  std::vector<const ElementKeyRow*> rows;
  for (const ElementKeyRow& row : kKeys) {
    if (row.element == kind) rows.push_back(&row);
  }
  return rows;
}

std::vector<std::string_view> WordsOf(Shape shape) {
  switch (shape) {
    case Shape::kEnd:
      return {"retracted", "extended"};
    case Shape::kCoding:
      return {"binary", "gray", "bcd", "one-hot"};
    case Shape::kBit:
      return {"0", "1"};
    case Shape::kCondition:
    case Shape::kDrive:
    case Shape::kDrives:
    case Shape::kValues:
    case Shape::kLevels:
    case Shape::kAmount:
    case Shape::kTime:
    case Shape::kCount:
    case Shape::kNumber:
    case Shape::kDecimal:
    case Shape::kPositive:
      break;
  }
  return {};
}

}  // namespace plcxx::plant
