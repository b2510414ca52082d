// What the rewritten sources call (mutate/): one mutant of them all is active, the one that PLCXX_MUTANT names.
//
// An operation of the sources, `a < b`, has become a call, `Less(17, 18, a, b)`, which computes what it did before
// unless mutant 17 or 18 is active. At() marks its mutant as reached, in a file that is shared with child processes
// when PLCXX_MUTANTS_REACHED names one. In constant evaluation nothing is mutated.
#pragma once

#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

namespace plcxx::mutants {

constexpr unsigned kMost = 1U << 18;  // more than the ids of all folders

inline unsigned char* MarkedBytes() noexcept {
  const char* const path = getenv("PLCXX_MUTANTS_REACHED");
  const int file = path == nullptr ? -1 : open(path, O_RDWR | O_CREAT, 0666);
  const bool shared = file >= 0 && ftruncate(file, kMost) == 0;
  void* const bytes = mmap(nullptr, kMost, PROT_READ | PROT_WRITE, shared ? MAP_SHARED : MAP_PRIVATE | MAP_ANONYMOUS,
                           shared ? file : -1, 0);
  if (bytes == MAP_FAILED) abort();
  return static_cast<unsigned char*>(bytes);
}

inline unsigned ActiveMutant() noexcept {
  const char* const text = getenv("PLCXX_MUTANT");
  return text == nullptr ? 0 : static_cast<unsigned>(atoi(text));
}

// Both are asked before main by initializers of tables, therefore not plain variables.
inline bool IsActive(unsigned id) noexcept {
  static unsigned char* const reached = MarkedBytes();
  static const unsigned active = ActiveMutant();
  reached[id] = 1;
  return id == active;
}

constexpr bool At(unsigned id) noexcept { return __builtin_is_constant_evaluated() ? false : IsActive(id); }

template <class A, class B>
constexpr bool Less(unsigned bound, unsigned negated, A a, B b) noexcept {
  return At(bound) ? a <= b : At(negated) ? a >= b : a < b;
}
template <class A, class B>
constexpr bool LessOrEqual(unsigned bound, unsigned negated, A a, B b) noexcept {
  return At(bound) ? a < b : At(negated) ? a > b : a <= b;
}
template <class A, class B>
constexpr bool Greater(unsigned bound, unsigned negated, A a, B b) noexcept {
  return At(bound) ? a >= b : At(negated) ? a <= b : a > b;
}
template <class A, class B>
constexpr bool GreaterOrEqual(unsigned bound, unsigned negated, A a, B b) noexcept {
  return At(bound) ? a > b : At(negated) ? a < b : a >= b;
}
template <class A, class B>
constexpr bool Equal(unsigned id, A a, B b) noexcept {
  return At(id) != (a == b);
}
template <class A, class B>
constexpr bool Unequal(unsigned id, A a, B b) noexcept {
  return At(id) != (a != b);
}
template <class A, class B>
constexpr auto Plus(unsigned id, A a, B b) noexcept {
  return At(id) ? a - b : a + b;
}
template <class A, class B>
constexpr auto Minus(unsigned id, A a, B b) noexcept {
  return At(id) ? a + b : a - b;
}
template <class A, class B>
constexpr auto Times(unsigned id, A a, B b) noexcept {
  return At(id) ? a + b : a * b;
}
template <class A, class B>
constexpr auto Divided(unsigned id, A a, B b) noexcept {
  return At(id) ? a * b : a / b;
}
template <class A, class B>
constexpr auto Remainder(unsigned id, A a, B b) noexcept {
  return At(id) ? a / b : a % b;
}
template <class A, class B>
constexpr auto BitAnd(unsigned id, A a, B b) noexcept {
  return At(id) ? a | b : a & b;
}
template <class A, class B>
constexpr auto BitOr(unsigned id, A a, B b) noexcept {
  return At(id) ? a & b : a | b;
}
template <class A, class B>
constexpr auto BitXor(unsigned id, A a, B b) noexcept {
  return At(id) ? a | b : a ^ b;
}
template <class A, class B>
constexpr auto ShiftLeft(unsigned id, A a, B b) noexcept {
  return At(id) ? a >> b : a << b;
}
template <class A, class B>
constexpr auto ShiftRight(unsigned id, A a, B b) noexcept {
  return At(id) ? a << b : a >> b;
}
template <class A>
constexpr auto Negative(unsigned id, A a) noexcept {
  return At(id) ? +a : -a;
}
template <class A>
constexpr auto Complement(unsigned id, A a) noexcept {
  return At(id) ? +a : ~a;
}
/// A number one more, and one less.
template <class A>
constexpr A Number(unsigned more, unsigned less, A a) noexcept {
  return At(more) ? static_cast<A>(a + 1) : At(less) ? static_cast<A>(a - 1) : a;
}
template <class A>
constexpr A Number(unsigned more, A a) noexcept {
  return At(more) ? static_cast<A>(a + 1) : a;
}

}  // namespace plcxx::mutants
