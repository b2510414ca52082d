// What pointers reach: reads and writes of objects, and what must not be of them.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "transpiler/prove/verify/llvm_ir/execution.h"

namespace plcxx::prove::verify::llvm_ir {

class ObjectMemory : private ExecutionPart {
 public:
  explicit ObjectMemory(Execution& execution)
      : ExecutionPart(execution), initial_(run_.state_bytes + run_.further_slots) {}

  terms::TermId ReadSlot(uint32_t slot) { return ReadSlot(slots_, slot); }
  terms::TermId ReadSlot(const Slots& slots, uint32_t slot);
  terms::TermId Load(const std::vector<Target>& targets, uint64_t at, uint32_t bytes);
  void Store(const std::vector<Target>& targets, uint64_t at, terms::TermId value);
  uint32_t NewLocal(uint64_t bytes, uint64_t align);
  /// A local whose life begins or ends has no value.
  void ForgetLocals(const std::vector<Target>& targets);
  /// memcpy leaves open what it does with two places that overlap, unless they are one.
  void RequireApart(const std::vector<Target>& to, const std::vector<Target>& from, uint64_t bytes);
  void RequireAligned(const std::vector<Target>& targets, uint64_t align,
                      const char* text = "an access at an address that is not aligned");

 private:
  /// The offsets in an object at which an access of `bytes` bytes can be.
  struct Reach {
    uint64_t low = 0, high = 0, step = 1;
    bool none = false, beyond = false;  // beyond: it may be elsewhere, too
  };

  terms::TermId LoadFrom(terms::TermId when, uint32_t object, terms::TermId offset, uint32_t bytes);
  terms::TermId LoadAt(const Object& object, uint64_t offset, uint32_t bytes);
  void StoreTo(terms::TermId when, uint32_t object, terms::TermId offset, terms::TermId value);
  void StoreAt(terms::TermId when, const Object& object, uint64_t offset, terms::TermId value);
  terms::TermId AsStored(const Object& object, uint64_t offset, terms::TermId loaded);
  Reach ReachOf(const Object& object, terms::TermId offset, uint32_t bytes);
  terms::TermId IsBeyond(const Reach& reach, terms::TermId offset);

  std::vector<terms::TermId> initial_;                        // by slot
  std::unordered_map<uint32_t, terms::TermId> stored_words_;  // in locals, by first slot: whatever was stored last
};

}  // namespace plcxx::prove::verify::llvm_ir
