// The spaces of a prostep program in the IR: I, O, F, D in up to three parts by retention, the latches of the direct
// outputs, and what registers and scheduler need.
//
// Used by the lowering and by those who name locations without a syntax tree (locate, stub).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "transpiler/dialects/prostep/machine/machine.h"
#include "transpiler/ir/program.h"

namespace plcxx::prostep {

enum class SpaceKey : uint8_t { kI, kO, kF, kDBefore, kDKept, kDBehind, kLatches, kSystem, kRegisters, kCount };

/// A byte of I, O, F or D in the IR.
struct Cell {
  ir::SpaceId space;
  uint32_t offset = 0;
  uint32_t left = 0;  // bytes from here to the end of the space
};

/// Knows the spaces of one program.
class Memory {
 public:
  /// Adds the spaces to an empty program; bytes `first` to `last` of D are retentive.
  Memory(ir::Program& program, uint32_t first_retentive, uint32_t last_retentive);
  /// Finds the spaces of a program that was lowered.
  explicit Memory(const ir::Program& program);

  /// None when the program has no such space (D in one part).
  ir::SpaceId operator[](SpaceKey key) const { return spaces_[static_cast<size_t>(key)]; }
  /// `space` is I, O, F or D, `address` inside it.
  Cell At(Space space, uint32_t address) const;
  /// The parts of D in the order of their addresses, with the address of the first byte.
  struct Part {
    ir::SpaceId space;
    uint32_t first = 0;
    uint32_t bytes = 0;
  };
  std::array<Part, 3> DataParts() const;

 private:
  std::array<ir::SpaceId, static_cast<size_t>(SpaceKey::kCount)> spaces_;
  std::array<Part, 3> parts_{};
};

/// "IB 20", "I 20.1", "DD 8": an address as the manual writes it; a double word by the letter and D.
std::string AddressText(Space space, uint32_t address, ir::Type type, uint8_t bit);
/// The same as a name in generated code: "IB20", "I20_1", "DD8".
std::string NameText(Space space, uint32_t address, ir::Type type, uint8_t bit);

}  // namespace plcxx::prostep
