// Typed ids and the stores they index: ids, not pointers, so that a program is a handful of vectors
// that can be copied, compared and printed in order.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <vector>

#include "transpiler/support/check.h"

namespace plcxx::support {

/// An index of one kind; ids of different kinds (different Tag) do not mix. Default is "none".
template <class Tag>
struct Id {
  static constexpr uint32_t kNone = 0xFFFFFFFF;
  uint32_t index = kNone;

  constexpr Id() = default;
  constexpr explicit Id(uint32_t i) : index(i) {}
  constexpr bool valid() const { return index != kNone; }
  constexpr auto operator<=>(const Id&) const = default;
};

/// A vector indexed by one kind of id.
template <class IdType, class T>
class Store {
 public:
  IdType Add(T item) {
    items_.push_back(std::move(item));
    return IdType(static_cast<uint32_t>(items_.size() - 1));
  }
  T& operator[](IdType id) {
    PLCXX_CHECK(id.index < items_.size());
    return items_[id.index];
  }
  const T& operator[](IdType id) const {
    PLCXX_CHECK(id.index < items_.size());
    return items_[id.index];
  }
  uint32_t size() const { return static_cast<uint32_t>(items_.size()); }
  bool empty() const { return items_.empty(); }
  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  void Reserve(size_t n) { items_.reserve(n); }

 private:
  std::vector<T> items_;
};

}  // namespace plcxx::support

template <class Tag>
struct std::hash<plcxx::support::Id<Tag>> {
  size_t operator()(plcxx::support::Id<Tag> id) const { return id.index; }
};
