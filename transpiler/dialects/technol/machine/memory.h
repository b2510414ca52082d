// The spaces of a technol program in the IR: one for each area of 5.1, activation bits, what the scheduler and the
// waiting points keep, registers.
//
// Used by the lowering and by those who name locations without a syntax tree (locate, stub).
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "transpiler/dialects/technol/machine/machine.h"
#include "transpiler/ir/program.h"

namespace plcxx::technol {

/// The areas come first, in their order.
enum class SpaceKey : uint8_t {
#define TECHNOL_AREA(Key, ...) k##Key,
#include "transpiler/dialects/technol/machine/machine.def"
  kUser,
  kMechanisms,  // activation bits
  kSteps,       // steps and automatic timers
  kRegisters,   // of those that call subprograms, and of these
  kCount
};
constexpr SpaceKey KeyOf(Area area) { return static_cast<SpaceKey>(area); }

/// Knows the spaces of one program.
class Memory {
 public:
  struct Sizes {
    uint32_t user = 0;        // bytes
    uint32_t mechanisms = 0;  // bytes, one for each
    uint32_t steps = 0;       // bytes
  };
  /// Adds the spaces to an empty program.
  Memory(ir::Program& program, const Sizes& sizes);
  /// Finds the spaces of a program that was lowered.
  explicit Memory(const ir::Program& program);

  /// None when the program has no such space (no data, no mechanisms).
  ir::SpaceId operator[](SpaceKey key) const { return spaces_[static_cast<size_t>(key)]; }
  ir::SpaceId operator[](Area area) const { return (*this)[KeyOf(area)]; }

 private:
  std::array<ir::SpaceId, static_cast<size_t>(SpaceKey::kCount)> spaces_;
};

/// "IN+3.5", "LABEL_MEM+40:16": where a bit or cell lies, and how wide it is, for maps and documentation. A width of 0
/// is that of what has no width of its own.
std::string BitAddress(Area area, uint32_t offset, uint8_t bit);
std::string CellAddress(Area area, uint32_t offset, uint32_t width);

}  // namespace plcxx::technol
