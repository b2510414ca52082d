// What a program keeps: its address spaces, its state instances, and the host's store of retentive memory.
//
// Total: an access out of bounds reads 0 and writes nothing. Not its job: who wrote what (write_recorder.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/sim/forced_bytes.h"
#include "transpiler/sim/instances.h"
#include "transpiler/sim/place_access.h"

namespace plcxx::sim {

class Memory {
 public:
  /// `program` must outlive it.
  explicit Memory(const ir::Program& program);

  /// As it is at power-on, before init; what is forced stays, and the host's store does.
  void Clear();

  /// Of an indexed place `index` says which element; of others it is 0.
  uint64_t Get(const PlaceAccess& access, uint64_t index) const;
  void Set(const PlaceAccess& access, uint64_t index, uint64_t value);
  /// The place keeps `value` until it is released, whoever writes.
  void Force(const PlaceAccess& access, uint64_t value);
  void Release(const PlaceAccess& access);
  void SendText(std::string_view text);

  /// The host takes the retentive spaces into its store, or puts back what is there.
  void StoreRetentive();
  void LoadRetentive();

  ForcedBytes& SpaceAt(uint32_t index) { return spaces_[index]; }
  const std::vector<ForcedBytes>& spaces() const { return spaces_; }
  Instances& instances() { return instances_; }
  const Instances& instances() const { return instances_; }

  /// Host-visible spaces in order, then the fields of all instances.
  std::vector<uint8_t> Snapshot() const;

  /// Everything that decides the future, at the end of a part.
  struct Saved {
    std::vector<ForcedBytes> spaces;
    Instances instances;
    std::optional<std::vector<uint8_t>> stored;
  };
  Saved Save() const { return {.spaces = spaces_, .instances = instances_, .stored = stored_}; }
  void Restore(const Saved& saved);
  void Exchange(Saved& other);
  /// Whether both go on alike, and look alike to the host.
  bool IsAt(const Saved& other) const;

 private:
  const ir::Program& program_;
  std::vector<ForcedBytes> spaces_;  // by SpaceId
  Instances instances_;
  std::optional<std::vector<uint8_t>> stored_;  // the host's store: all retentive spaces in order
};

}  // namespace plcxx::sim
