// A list that most of its owners do not have: it takes the room of a pointer where it is empty.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace plcxx::support {

/// Copied with its items, like a std::vector.
template <typename T>
class RareList {
 public:
  RareList() = default;
  RareList(const RareList& other) : items_(CopyOf(other)) {}
  RareList(RareList&&) noexcept = default;
  RareList& operator=(const RareList& other) {
    if (this != &other) items_ = CopyOf(other);
    return *this;
  }
  RareList& operator=(RareList&&) noexcept = default;
  ~RareList() = default;

  bool empty() const { return size() == 0; }
  size_t size() const { return items_ ? items_->size() : 0; }
  void push_back(T item) {
    if (!items_) items_ = std::make_unique<std::vector<T>>();
    items_->push_back(std::move(item));
  }
  const T& operator[](size_t at) const { return (*items_)[at]; }
  T& operator[](size_t at) { return (*items_)[at]; }
  const T& front() const { return items_->front(); }
  const T* begin() const { return items_ ? items_->data() : nullptr; }
  const T* end() const { return begin() + size(); }
  T* begin() { return items_ ? items_->data() : nullptr; }
  T* end() { return begin() + size(); }

 private:
  static std::unique_ptr<std::vector<T>> CopyOf(const RareList& other) {
    return other.items_ ? std::make_unique<std::vector<T>>(*other.items_) : nullptr;
  }

  std::unique_ptr<std::vector<T>> items_;
};

}  // namespace plcxx::support
