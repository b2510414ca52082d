#include "transpiler/support/sha256.h"

#include <array>
#include <bit>
#include <cstdint>

namespace plcxx::support {
namespace {

constexpr size_t kBlockBytes = 64;
constexpr size_t kLengthBytes = 8;
constexpr size_t kRounds = 64;
constexpr size_t kWords = 8;
using Digest = std::array<uint32_t, kWords>;

constexpr bool IsPrime(uint32_t number) {
  for (uint32_t i = 2; i * i <= number; ++i) {
    if (number % i == 0) return false;
  }
  return number >= 2;
}

/// The first 32 bits behind the point of the square or cube root of a small number, as the standard defines its
/// constants: the greatest x with x^power <= number * 2^(32 * power), without the bits in front of the point.
constexpr uint32_t RootFraction(uint32_t number, int power) {
  __extension__ using Wide = unsigned __int128;
  constexpr int kFractionBits = 32;
  // Cubes of 36 bits are below 2^128.
  const Wide limit = static_cast<Wide>(number) << (kFractionBits * power);
  uint64_t root = 0;
  for (int bit = kFractionBits + 4; bit >= 0; --bit) {
    const uint64_t larger = root | (uint64_t{1} << bit);
    Wide raised = larger;
    for (int i = 1; i < power; ++i) raised *= larger;
    if (raised <= limit) root = larger;
  }
  return static_cast<uint32_t>(root);
}

template <size_t kCount>
constexpr std::array<uint32_t, kCount> Roots(int power) {
  std::array<uint32_t, kCount> roots{};
  uint32_t prime = 2;
  for (uint32_t& root : roots) {
    root = RootFraction(prime, power);
    for (++prime; !IsPrime(prime);) ++prime;
  }
  return roots;
}

constexpr Digest kStart = Roots<kWords>(2);
constexpr std::array<uint32_t, kRounds> kConstants = Roots<kRounds>(3);
static_assert(kStart[0] == 0x6A09E667 && kConstants[kRounds - 1] == 0xC67178F2);

uint32_t WordAt(std::string_view block, size_t at) {
  uint32_t word = 0;
  for (size_t i = 0; i < sizeof word; ++i) word = word << 8 | static_cast<unsigned char>(block[at + i]);
  return word;
}

void Mix(Digest& digest, std::string_view block) {
  std::array<uint32_t, kRounds> words{};
  constexpr size_t kGiven = 16;
  for (size_t i = 0; i < kGiven; ++i) words[i] = WordAt(block, i * sizeof(uint32_t));
  for (size_t i = kGiven; i < kRounds; ++i) {
    const uint32_t near = words[i - 2], far = words[i - 15];
    words[i] = words[i - 16] + (std::rotr(far, 7) ^ std::rotr(far, 18) ^ far >> 3) + words[i - 7] +
               (std::rotr(near, 17) ^ std::rotr(near, 19) ^ near >> 10);
  }
  auto [a, b, c, d, e, f, g, h] = digest;
  for (size_t i = 0; i < kRounds; ++i) {
    const uint32_t chosen = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
    const uint32_t first =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + chosen + kConstants[i] + words[i];
    const uint32_t second = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + majority;
    h = g;
    g = f;
    f = e;
    e = d + first;
    d = c;
    c = b;
    b = a;
    a = first + second;
  }
  const Digest mixed = {a, b, c, d, e, f, g, h};
  for (size_t i = 0; i < kWords; ++i) digest[i] += mixed[i];
}

}  // namespace

std::string Sha256(std::string_view bytes) {
  Digest digest = kStart;
  std::string_view rest = bytes;
  for (; rest.size() >= kBlockBytes; rest.remove_prefix(kBlockBytes)) Mix(digest, rest.substr(0, kBlockBytes));
  std::string end(rest);
  end += '\x80';
  while (end.size() % kBlockBytes != kBlockBytes - kLengthBytes) end += '\0';
  const uint64_t bits = uint64_t{8} * bytes.size();
  for (int shift = 56; shift >= 0; shift -= 8) end += static_cast<char>(bits >> shift & 0xFF);
  for (size_t at = 0; at < end.size(); at += kBlockBytes) Mix(digest, std::string_view(end).substr(at, kBlockBytes));
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const uint32_t word : digest) {
    for (int shift = 28; shift >= 0; shift -= 4) text += kDigits[word >> shift & 15];
  }
  return text;
}

}  // namespace plcxx::support
