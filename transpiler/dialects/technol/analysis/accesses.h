// Who reads and writes which bit and byte of memory, and which mechanism's bit: for the warnings of 10.3.
#pragma once

#include <map>
#include <tuple>
#include <vector>

#include "transpiler/dialects/technol/syntax/syntax.h"

namespace plcxx::technol {

enum class AccessKind : uint8_t { kRead, kCoil, kSet, kClear, kStore };  // WR; FL with 1 and with 0; everything else
constexpr bool Writes(AccessKind kind) { return kind != AccessKind::kRead; }

/// One access of an instruction to memory or to an activation bit.
struct MemoryAccess {
  InstructionId at;
  AccessKind kind = AccessKind::kRead;
  const Operand* operand = nullptr;
};

/// In source order; an operand that is read and written gives two.
std::vector<MemoryAccess> AccessesOf(const Program& program);

/// Does the access touch a bit (`bit` 0 to 7) or any bit (`bits` = 8) of these bytes? An indexed one may touch its area
/// from its first byte on, and what lies before by a negative index.
bool Touches(const Operand& operand, Area area, uint32_t offset, uint32_t bytes, uint8_t bit);

/// The same of many accesses at once: what is asked costs its own bytes, however many accesses there are.
class TouchedMemory {
 public:
  void Add(const Operand& operand);
  bool Holds(Area area, uint32_t offset, uint32_t bytes, uint8_t bit) const;

 private:
  struct Bytes {
    std::vector<uint8_t> bits;  // of each byte up to the last one that is touched
    bool anywhere = false;      // by an index
  };
  std::map<Area, Bytes> areas_;
};

}  // namespace plcxx::technol
