// A condition over locations that the plant reads: "HYDPMP and not (STOP or W2K0 >= 5)".
//
// In: a text in the words of `plcxx prove`, without times and lists. Out: whether it holds for values of the locations.
// A location alone holds when it is not 0. Not its job: what a location is.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/yaml/place.h"

namespace plcxx::plant {

/// Locations by number, each once.
class LocationNames {
 public:
  uint32_t Add(const yaml::MarkedText& name);
  const std::vector<yaml::MarkedText>& all() const { return names_; }

 private:
  std::vector<yaml::MarkedText> names_;
};

enum class ConditionKind : uint8_t { kNumber, kRead, kNot, kAnd, kOr, kEqual, kLess };
struct ConditionNode {
  ConditionKind kind{};
  int64_t number = 0;              // of kNumber
  uint32_t read = 0;               // of kRead
  uint32_t first = 0, second = 0;  // nodes
};

class Condition {
 public:
  /// Or what is wrong with the text.
  static std::variant<Condition, std::string> Parse(const yaml::MarkedText& text, LocationNames& reads);
  static Condition Always() { return Condition({{.kind = ConditionKind::kNumber, .number = 1}}); }
  static Condition Never() { return Condition({{.kind = ConditionKind::kNumber, .number = 0}}); }
  static Condition Not(Condition condition);

  bool Holds(std::span<const int64_t> reads) const {
    return ValueOf(static_cast<uint32_t>(nodes_.size()) - 1, reads) != 0;
  }

 private:
  explicit Condition(std::vector<ConditionNode> nodes) : nodes_(std::move(nodes)) {}
  int64_t ValueOf(uint32_t node, std::span<const int64_t> reads) const;

  std::vector<ConditionNode> nodes_;  // the last one is the whole; children come before their parents
};

}  // namespace plcxx::plant
