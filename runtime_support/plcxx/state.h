// The storage of a program's State: tags into the retentive block, clearing, message tables.
//
// Generated headers include it. Not its job: what is stored where; the generated header says that.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "plcxx/tags.h"

namespace plcxx {

/// Tag of one bit of the retentive block.
struct RetentiveBit {
  uint16_t byte;
  uint8_t bit;
};

/// A text that the operator sees: message or menu entry, UTF-8.
struct DisplayText {
  uint16_t number;
  uint8_t colour;
  const char* text;
};

/// Sets every element to its zero value.
template <class T, size_t kCount>
inline void Clear(T (&array)[kCount]) noexcept {
  for (T& element : array) element = T{};  // at most one round for each element
}

/// Sets the elements from `first` on to a table of values; what would lie beyond the array is left out.
template <class T, size_t kSize, size_t kCount>
inline void Place(T (&array)[kSize], size_t first, const T (&values)[kCount]) noexcept {
  for (size_t i = 0; i < kCount && first + i < kSize; ++i) {  // at most one round for each element
    array[first + i] = values[i];
  }
}

/// A place that the other part of the program uses, too, where the fast part runs from an interrupt: this access is
/// made once, where it stands, and never repeated from a register or left out.
template <class T>
[[gnu::always_inline]] constexpr inline volatile T& Once(T& place) noexcept {
  return place;
}

}  // namespace plcxx
