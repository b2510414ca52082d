// The parts of write_code.cc: the text of one routine, of its values, and of its places.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "transpiler/fleet/layout.h"
#include "transpiler/fleet/local_bytes.h"
#include "transpiler/fleet/same_everywhere.h"
#include "transpiler/fleet/write_code.h"
#include "transpiler/ir/program.h"

namespace plcxx::fleet {

/// "v12"
std::string ValueName(ir::ValueId id);
/// The bits of a number, "32".
std::string WidthText(ir::Type type);
/// "In<uint32_t>(v12)"
std::string RowsOf(const ir::Program& program, ir::ValueId id);

/// Loads and stores.
class PlaceWriter {
 public:
  PlaceWriter(const ir::Program& program, const Layout& layout) : program_(program), layout_(layout) {}
  /// An expression; an index is that of the lanes of `mask`.
  std::string Load(ir::PlaceId place, ir::ValueId index, const std::string& mask) const;
  /// The place is not indexed.
  std::string Load(ir::PlaceId place) const { return Load(place, ir::ValueId(), {}); }
  /// A statement, of the expression `value`.
  std::string Store(ir::PlaceId place, ir::ValueId index, const std::string& value, const std::string& mask) const;
  /// A statement, of a number of C++; the place is a scalar.
  std::string StoreScalar(ir::PlaceId place, const std::string& value) const;
  bool IsScalar(ir::PlaceId place) const;
  /// Whether it takes a loop over the lanes.
  bool IsPerLane(ir::PlaceId place) const;

 private:
  std::string LoadFixed(const sim::PlaceAccess& access, ir::Type type) const;
  std::string Element(const sim::PlaceAccess& access) const;
  /// "Planes<8>, Planes<16>", least significant first.
  std::string Bytes(const sim::PlaceAccess& access) const;

  const ir::Program& program_;
  const Layout& layout_;
};

/// The body of one routine, in pieces that a compiler can hold.
class RoutineWriter {
 public:
  RoutineWriter(const ir::Program& program, const Layout& layout, const LocalBytes& locals, const SameEverywhere& same,
                ir::RoutineId routine)
      : program_(program), layout_(layout), locals_(locals), same_(same), places_(program, layout), routine_(routine) {}
  std::string Write();
  const Share& share() const { return share_; }
  /// The locals that `callee` and what it calls use become 0 in the lanes of `mask`.
  std::string ClearLocals(ir::RoutineId callee, const std::string& mask) const;

 private:
  /// A mask of the code around what is being written; an Exit takes lanes out of all those up to its target.
  struct Context {
    std::string mask;
    ir::InstId owner;      // a Block or Loop; none for other regions
    bool is_body = false;  // of a Loop: a Repeat leaves this one, an Exit the one outside, too
  };

  void WriteTop(ir::RegionId region);
  void WriteRegion(ir::RegionId region);
  void WriteInst(ir::InstId id);
  void WritePure(ir::InstId id, const ir::Inst& inst);
  void WriteStep(ir::InstId id, const ir::Inst& inst);
  /// The value of an instruction that is the same everywhere, as a number of C++.
  std::string Scalar(ir::ValueId id) const;
  void WriteStore(const ir::Inst& inst);
  void StoreInto(ir::PlaceId place, ir::ValueId value);
  void WriteIf(const ir::Inst& inst);
  void WriteSwitch(const ir::Inst& inst);
  void WriteScalarSwitch(const ir::Inst& inst);
  void WriteLoop(ir::InstId id, const ir::Inst& inst);
  void WriteBlock(ir::InstId id, const ir::Inst& inst);
  void WriteExit(const ir::Inst& inst);
  void WriteRepeat(const ir::Inst& inst);
  void WriteCall(ir::InstId id, const ir::Inst& inst);
  void WriteHostCall(ir::InstId id, const ir::Inst& inst);
  void WriteUpdateText(const ir::Inst& inst);

  /// A region under a mask of its own, left out when no lane reaches it.
  void WriteGuarded(const std::string& lanes, ir::RegionId region);
  /// The lanes of `lanes` leave every context up to that of `target`.
  void Leave(const std::string& lanes, ir::InstId target, bool repeats);
  std::string NewName(const char* prefix) { return prefix + std::to_string(names_++); }
  const std::string& Mask() const { return contexts_.back().mask; }
  /// Stretches of planes: the first one, and how many.
  std::vector<std::pair<uint32_t, uint32_t>> PlanesOf(const std::set<LocalByte>& bytes) const;
  std::vector<uint32_t> ScalarsOf(const std::set<LocalByte>& bytes) const;
  void EndPiece();

  const ir::Program& program_;
  const Layout& layout_;
  const LocalBytes& locals_;
  const SameEverywhere& same_;
  PlaceWriter places_;
  ir::RoutineId routine_;
  std::string out_;    // of the piece that is being written
  std::string text_;   // pieces that are complete
  std::string calls_;  // of the pieces, in order
  uint32_t pieces_ = 0, names_ = 0;
  std::vector<Context> contexts_;
  std::map<uint32_t, std::string> repeats_of_;  // of a loop with a budget: the lanes that come again
  Share share_;
};

/// Whether the program counts it as an operation, and as which.
void Count(Share& share, bool is_per_lane);

}  // namespace plcxx::fleet
