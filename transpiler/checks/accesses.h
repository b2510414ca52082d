// Who reads, writes and drives what, in program order: the view of a program that the checks share.
//
// In: a structured program before its slow part is cut into slices. Out: one list for each fast and slow routine.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::checks {

enum class AccessKind : uint8_t {
  kRead,    // load of a place
  kWrite,   // store to a place
  kDrive,   // a step that takes the instance's input: the statement that runs a timer, counter, one-shot
  kTouch,   // any other operation on an instance (reset, expiry)
  kLoopEnd  // not an access: what was written in the loop may have been read at the start of its next round
};

/// Where an access stands: a chain of (branch, arm) from the top of the routine.
struct Arm {
  uint32_t parent = 0;  // index into PartAccesses::arms; 0 is the top
  ir::InstId branch;
  uint32_t number = 0;  // which of the branch's regions
};

struct Access {
  AccessKind kind{};
  ir::PlaceId place;  // of kRead and kWrite
  ir::StateId state;  // of kDrive and kTouch; of a read or write of a field
  source::Range range;
  uint32_t arm = 0;   // 0: executed in every run of the routine
  ir::OpKind step{};  // of kDrive and kTouch
  ir::StatementId statement;
};

struct PartAccesses {
  ir::RoutineKind part{};
  uint32_t slices = 1;
  std::vector<Arm> arms{Arm{}};
  std::vector<Access> accesses;

  /// Can at most one of the two arms be executed in one run?
  bool Exclusive(uint32_t left, uint32_t right) const;
  /// Is `arm` executed whenever `inner` is: the same arm or one around it?
  bool Encloses(uint32_t arm, uint32_t inner) const;
};

/// The fast and slow routines of the program, in its order.
std::vector<PartAccesses> CollectAccesses(const ir::Program& program);

/// The bits that a memory place covers, as [first, last) in a numbering of all bits of all spaces; empty for a field.
struct BitSpan {
  uint32_t first = 0, last = 0;
};
class BitNumbering {
 public:
  explicit BitNumbering(const ir::Program& program);
  uint32_t count() const { return count_; }
  BitSpan Of(const ir::Place& place) const;

 private:
  std::vector<uint32_t> base_;    // by SpaceId
  std::vector<uint32_t> fields_;  // by StateId
  uint32_t count_ = 0;
};

/// A value for each bit of a numbering, Value() at first. A control has tens of thousands of bits and a small program
/// touches a few: memory is taken for the groups of bits that are asked for, and only these are gone through.
template <class Value>
class ByBit {
 public:
  explicit ByBit(const BitNumbering& numbering) : groups_((numbering.count() + kGroup - 1) / kGroup) {}

  Value& operator[](uint32_t bit) {
    std::unique_ptr<std::array<Value, kGroup>>& group = groups_[bit / kGroup];
    if (group == nullptr) group = std::make_unique<std::array<Value, kGroup>>();
    return (*group)[bit % kGroup];
  }

  /// Calls visit(value) for all that were ever asked for, and for some beside them.
  template <class Visit>
  void ForTouched(Visit&& visit) {
    for (const auto& group : groups_) {
      if (group == nullptr) continue;
      for (Value& value : *group) visit(value);
    }
  }

 private:
  static constexpr uint32_t kGroup = 64;

  std::vector<std::unique_ptr<std::array<Value, kGroup>>> groups_;
};

}  // namespace plcxx::checks
