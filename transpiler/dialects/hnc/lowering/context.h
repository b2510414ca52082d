// What every part of the lowering works on: the tree and what is known of it, the program that is made, and where in
// both it is.
//
// Each C function is a routine with the same name, parameters and locals. Scalar locals are places of a space of the
// routine's own, so that generated code has them as locals; arrays, structures and what has its address taken lie in
// memory, which recursion, being refused, permits. A pointer is an offset in bytes, and beside it the number of its
// object where it may refer to several (mapping.md).
#pragma once

#include <initializer_list>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "transpiler/dialects/common/builder.h"
#include "transpiler/dialects/hnc/analysis/facts.h"
#include "transpiler/dialects/hnc/lowering/values.h"
#include "transpiler/dialects/hnc/machine/options.h"
#include "transpiler/dialects/hnc/syntax/walk.h"

namespace plcxx::hnc {

/// The types of the tree and those that only the lowering needs.
class Types {
 public:
  explicit Types(const Unit& unit);
  const Type& operator[](TypeId id) const { return types_[id]; }
  TypeId Integer(uint8_t bits, bool is_signed);
  TypeId Double();

 private:
  support::Store<TypeId, Type> types_;
};

/// Where the offset of a pointer variable and the number of its object are; `object` none: it has one target.
struct PointerPlaces {
  ir::PlaceId offset, object;
};

/// What functions and their variables are in the program.
struct Placement {
  std::vector<ir::RoutineId> routines;                   // by FunctionId
  std::vector<ir::PlaceId> locals;                       // by VariableId: scalars that are named locals
  std::unordered_map<uint32_t, PointerPlaces> pointers;  // by VariableId: in memory and locals
  std::unordered_map<uint32_t, PointerPlaces> results;   // by FunctionId
};

/// The function that is being lowered.
struct Frame {
  FunctionId id;
  const Function* function = nullptr;
  ir::PlaceId result;
  std::optional<Bounds> bounds;               // of what it gave so far
  std::unordered_set<uint32_t> block_locals;  // by VariableId: scalars of blocks that no jump leads into
};

/// The statement that is being lowered: for run-time faults and for messages.
struct CurrentStatement {
  uint32_t id = 0;
  source::Range range;
};

/// Whether nothing is executed after a statement in its function, or in its arm of a switch: then a `return` or a
/// `break` needs no jump.
enum class Tail : uint8_t { kNone, kCase, kFunction };

/// One tree on its way to a program.
struct Translation {
  Translation(const Unit& tree, const Objects& all, const Facts& known, const Settings& options,
              const source::SourceManager& files, diag::Engine& engine)
      : unit(tree), objects(all), facts(known), settings(options), sources(files), diagnostics(engine) {
    program.insts.Reserve(tree.expressions.size() * size_t{2});  // hardly more; what is not used costs nothing
    program.statements.Reserve(tree.statements.size());
  }

  const Unit& unit;
  const Objects& objects;
  const Facts& facts;
  const Settings& settings;
  const source::SourceManager& sources;
  diag::Engine& diagnostics;
  ir::Program program;
  dialects::Builder builder{program};
  Types types{unit};
  Flow flow;
  CurrentStatement statement;
  Frame frame;
  Placement placement;
};

/// What a part of the lowering sees of it. Refers to the translation, and may be copied.
class Context {
 public:
  explicit Context(Translation& translation);

 protected:
  const Type& TypeAt(TypeId id) const { return types_[id]; }
  const Expr& ExprAt(ExprId id) const { return unit_.expressions[id]; }
  TypeId IntegerType(uint8_t bits, bool is_signed) const { return types_.Integer(bits, is_signed); }
  ir::Type IrType(TypeId id) const;
  /// What an address keeps of its object; 0 is none.
  static uint16_t NumberOf(ObjectId object) { return static_cast<uint16_t>(object.index + 1); }
  std::optional<int64_t> KnownInteger(const Value& value) const;
  /// Whether evaluating it does nothing but compute, and cannot fault.
  bool IsSimple(ExprId id) const;
  /// Whether evaluating it may change what another operand reads.
  bool HasEffects(ExprId id) const;
  ir::ValueId Word(uint32_t value) const { return builder_.Constant(ir::Type::kI16, value & 0xFFFF); }
  ir::ValueId Long(uint32_t value) const { return builder_.Constant(ir::Type::kI32, value); }
  ir::ValueId Pure(ir::OpKind op, std::initializer_list<ir::ValueId> operands) const {
    return builder_.Pure(op, operands);
  }

  const Unit& unit_;
  const Settings& settings_;
  const source::SourceManager& sources_;
  diag::Engine& diagnostics_;
  ir::Program& program_;
  dialects::Builder& builder_;
  const Objects& objects_;
  const Facts& facts_;
  Types& types_;
  Flow& flow_;  // what is known where instructions are added
  CurrentStatement& statement_;
  Frame& frame_;
  Placement& placement_;
  const TypeId int_, unsigned_, long_, unsigned_long_, double_;
};

}  // namespace plcxx::hnc
