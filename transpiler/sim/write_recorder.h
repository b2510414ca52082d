// Notes who writes what, while it is asked to.
#pragma once

#include <cstdint>
#include <memory>

#include "transpiler/sim/last_writes.h"
#include "transpiler/sim/memory.h"

namespace plcxx::sim {

class WriteRecorder {
 public:
  /// Costs time, so it is off at first.
  void Begin();
  bool is_on() const { return writes_ != nullptr; }
  /// None: it is off.
  LastWrites* writes() const { return writes_.get(); }

  /// After `write`, whose value is what `memory` holds now; nothing for an element out of bounds.
  void Note(const Memory& memory, const PlaceAccess& access, uint64_t index, LastWrite write);
  /// After an operation on an instance: all of its fields that are shown.
  void NoteFields(const Memory& memory, uint32_t instance, LastWrite write);

 private:
  void NoteField(const Memory& memory, uint32_t instance, uint8_t field, LastWrite write);

  std::unique_ptr<LastWrites> writes_;
};

}  // namespace plcxx::sim
