// Ladder rungs from the IR: contacts, coils, blocks, comparisons, and frames around what branches and loops own.
//
// In: a program and the names of its locals. Out: a list of items in program order, without a single coordinate
// (ladder_drawing.h has those). Everything that has an effect is in the list: what has no shape of its own in a ladder
// is a box with its text. Not its job: C++ names, comments of the source.
//
// A bit's expression becomes contacts in series and in parallel; what cannot stand in the middle of a network (a block
// that needs an input of its own) is a rung before it, with an auxiliary bit that a contact then reads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/report/cross_reference.h"

namespace plcxx::report {

enum class Shape : uint8_t {
  kWire,        // always 1
  kNever,       // always 0
  kContact,     // 1 when the bit is 1
  kNotContact,  // 1 when the bit is 0
  kCompare,     // 1 when the comparison of two words holds: name, title (the operator), lines[0] (the other word)
  kInvert,      // inverts what comes from the left: everything from the rail on
  kBox,         // a block or an operation: title, lines
  kSeries,
  kParallel,
  kCoil,   // assigns what comes from the left
  kSet,    // sets a bit when it is 1
  kReset,  // clears a bit when it is 1
  kTarget  // leads elsewhere: begins a frame, leaves one, goes round again
};

/// A piece of a network; kCoil, kSet, kReset and kTarget stand at its right end only, kBox and contacts anywhere.
struct Element {
  Shape shape{};
  std::string name;                // of the bit; of a box, the instance above it
  std::string address;             // below it; empty: none
  std::string title;               // of a box, comparison or target
  std::vector<std::string> lines;  // in the box
  uint32_t signal = kNoSignal;
  bool local = false;  // a value that is kept for a moment: drawn dashed
  bool rooted =
      false;  // its input is all that stands left of it, from the rail on; so is a series that begins with one
  std::vector<Element> parts;  // kSeries, kParallel
  /// The bit that decides whether a contact or box conducts, as the program computes it; none: the shape alone does.
  ir::ValueId value;
  bool inverted = false;  // it conducts where that bit is 0
};

struct Rung {
  Element network;
  std::vector<Element> outputs;  // in the order of their execution
};

enum class ItemKind : uint8_t {
  kStatement,  // what follows is this statement's, `statement`; also after frames that it owns
  kRung,
  kHead,     // opens a frame that its network leads to; `label` says what runs in it
  kSection,  // the frame goes on with another part: "ELSE"; it may have a network
  kEnd       // closes the frame
};

struct LadderItem {
  ItemKind kind{};
  Rung rung;                  // kRung; kHead and kSection may have one
  std::string label;          // kHead, kSection, kEnd
  uint32_t depth = 0;         // frames around it; of kHead, kSection and kEnd without their own one
  ir::StatementId statement;  // whose it is; none: the control's own
};

struct RoutineLadder {
  ir::RoutineId routine;
  std::vector<LadderItem> items;
};

/// All routines of the program in its order.
std::vector<RoutineLadder> MakeLadders(const ProgramInput& input, const CrossReference& uses);

}  // namespace plcxx::report
