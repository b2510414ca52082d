// Which program is in a machine: 64 bytes in the compiled code that `plcxx identify` finds again.
//
// In: what a program was made from. Out: a constant in C++, or the same fields found in the bytes of an object, a
// library, an executable or a firmware image. Layout of the 64 bytes:
//
//   0   8  "plcxx-id"
//   8   1  version of this layout, 1
//   9   3  version of plcxx: major, minor, patch
//   12  4  digest of the options
//   16 16  digest of the sources
//   32 16  digest of the generated C++, without this constant
//   48 16  name of the program in UTF-8, cut at a character's border, filled up with zeros
//
// Digests are the first bytes of a SHA-256. Not its job: what goes into a digest (driver/identity_of.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plcxx::identity {

inline constexpr size_t kBytes = 64;

struct Identity {
  std::string program;               // at most 16 bytes are kept
  std::array<uint8_t, 3> version{};  // of plcxx
  std::string options;               // 8 hexadecimal digits
  std::string sources, generated;    // 32 hexadecimal digits each
  bool operator==(const Identity&) const = default;
};

/// `digest`: 64 hexadecimal digits, or none where nothing computes them: then the field is zeros.
std::string FirstDigits(std::string_view digest, size_t digits);

/// Of plcxx: "0.9.1".
std::string VersionText(const Identity& identity);

std::array<uint8_t, kBytes> BytesOf(const Identity& identity);

/// Lines of C++17 that define the constant, kept by compiler and linker though nothing refers to it.
std::string ConstantText(const Identity& identity);

/// NAME_link.hpp: the same bytes where the machine's side of a link (plcxx/debug_link.h) can name them, in the
/// namespace NAME_link.
std::string LinkHeaderText(const Identity& identity, std::string_view file, std::string_view program_namespace);

/// All constants in `bytes`, each identity once, in their order. An Intel HEX file (lines that begin with ':') is
/// decoded before; of one that is damaged, the lines that are right.
std::vector<Identity> FindIdentities(std::string_view bytes);

}  // namespace plcxx::identity
