// Turns a routine's instructions into ladder items. Only ladder_*.cc include this.
//
// ladder_build.cc effects: rungs and their outputs; ladder_frames.cc what owns regions, and what leaves them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "transpiler/report/ladder.h"
#include "transpiler/report/ladder_network.h"

namespace plcxx::report {

class LadderBuilder {
 public:
  LadderBuilder(const ProgramInput& input, const CrossReference& uses, const ValueText& text)
      : program_(*input.program),
        text_(text),
        networks_(input, uses, text, [this](Rung rung) { Append(std::move(rung)); }) {}

  std::vector<LadderItem> Run(const ir::Routine& routine) {
    routine_ = &routine;
    for (const ir::RegionId region : {routine.prologue, routine.body, routine.epilogue}) Region(region);
    return std::move(items_);
  }

 private:
  void Region(ir::RegionId region);
  void Insts(const std::vector<ir::InstId>& insts, size_t begin, size_t end);
  void Inst(ir::InstId id);
  void Local(ir::InstId id);
  void Store(const ir::Inst& inst);
  ir::ValueId ConditionOfSet(const ir::Inst& store, Shape& shape) const;
  void If(const ir::Inst& inst);
  bool IsConditional(const ir::Inst& inst) const;
  void Conditional(const ir::Inst& inst);
  ir::InstId ChainedIf(ir::RegionId otherwise) const;
  /// The condition of a later arm; a box with text when it needs rungs before it, which would stand in another arm.
  Element Arm(ir::ValueId condition);
  void Switch(const ir::Inst& inst);
  bool IsChoiceOfSlices(const ir::Inst& inst) const;
  void Loop(ir::InstId id, const ir::Inst& inst);
  void Block(ir::InstId id, const ir::Inst& inst);
  void Exit(const ir::Inst& inst);
  void Repeat(const ir::Inst& inst);

  void Own(ir::StatementId statement);
  /// `driver`: the value that the network is; none: no other rung's outputs may join.
  void Append(Rung rung, ir::ValueId driver = {});
  void Output(ir::ValueId driver, Element output);
  void Always(Element output);
  Element Assignment(const std::string& target, const std::string& value, uint32_t signal) const;
  void Head(std::string label, Rung rung, ItemKind kind = ItemKind::kHead);
  void Section(std::string label) { Head(std::move(label), {}, ItemKind::kSection); }
  void End(std::string label = "");
  std::string NameOf(ir::InstId frame);

  const ir::Program& program_;
  const ValueText& text_;
  NetworkBuilder networks_;
  const ir::Routine* routine_ = nullptr;
  std::vector<LadderItem> items_;
  ir::StatementId statement_;
  uint32_t depth_ = 0;
  ir::ValueId driver_;              // of the rung that was appended last; none: nothing may join it
  std::vector<ir::InstId> frames_;  // blocks and loops around, for names
};

/// An output that leads elsewhere.
Element Target(std::string title);

}  // namespace plcxx::report
