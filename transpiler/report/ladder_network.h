// A bit's expression as a network of contacts. Only ladder_*.cc include this.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "transpiler/report/ladder.h"
#include "transpiler/report/ladder_text.h"

namespace plcxx::report {

enum class Sense : uint8_t { kPlain, kInverted };

class NetworkBuilder {
 public:
  /// `before` is called with a rung that has to stand before the one that is being built.
  NetworkBuilder(const ProgramInput& input, const CrossReference& uses, const ValueText& text,
                 std::function<void(Rung)> before)
      : program_(*input.program), uses_(uses), text_(text), before_(std::move(before)) {}

  /// A new statement: auxiliary bits are numbered from 1 again.
  void Restart() { next_auxiliary_ = 1; }
  /// A bit where it is used, at the left end of a rung.
  Element Network(ir::ValueId value);
  /// What a local bit stands for.
  Element Definition(ir::ValueId value);
  /// The place as a contact, coil, ... of `shape`.
  Element OfPlace(Shape shape, ir::PlaceId place, ir::ValueId index) const;
  Element OfLocal(Shape shape, ir::ValueId value) const;
  /// The box of a step, call or text; what feeds it is not a part of it.
  Element Box(ir::InstId id) const;
  /// What feeds the box of an instruction: its first operand when that is a bit, else always 1.
  Element Feed(ir::InstId id);

 private:
  /// May an element stand here that needs everything to its left for its input?
  enum class Position : uint8_t { kAtRail, kInside };

  Element Of(ir::ValueId value, Sense sense, Position position);
  Element OfDefinition(ir::ValueId value, Sense sense, Position position);
  Element OfPure(ir::ValueId value, Sense sense, Position position);
  Element Chain(Shape shape, ir::ValueId a, ir::ValueId b, Sense sense, Position position);
  Element Either(ir::ValueId a, ir::ValueId b, Sense sense, Position position);
  Element Choice(const ir::Inst& inst, Sense sense, Position position);
  Element Rooted(ir::InstId id, Sense sense, Position position);
  Element Condition(ir::ValueId value, Sense sense, Position position);
  bool IsContact(ir::ValueId value) const;
  bool NeedsRail(ir::ValueId value) const;

  const ir::Program& program_;
  const CrossReference& uses_;
  const ValueText& text_;
  std::function<void(Rung)> before_;
  uint32_t next_auxiliary_ = 1;
};

}  // namespace plcxx::report
