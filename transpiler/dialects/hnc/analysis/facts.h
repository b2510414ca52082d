// What is known of a whole program before it is lowered (specification 6.4 to 6.6): which functions which part
// reaches, which objects a pointer may refer to, what a call may change. Without regard to the order of statements.
//
// In: the tree. Out: facts; nothing is reported here.
#pragma once

#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "transpiler/dialects/hnc/analysis/effects.h"
#include "transpiler/dialects/hnc/analysis/objects.h"
#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

/// Bits of a set of parts (4.1).
inline constexpr uint8_t kPartInit = 1, kPartFast = 2, kPartSlow = 4;

/// One call of set_mst_func whose arguments are in order (7.3).
struct Registration {
  ExprId call;
  uint32_t channel = 0;
  uint32_t kind = 0;    // index into kHandlerKinds
  FunctionId function;  // none: removes
};
inline constexpr std::string_view kHandlerKinds = "MSTBE";

class Facts {
 public:
  Facts(const Unit& unit, const Objects& objects);

  const Effects& effects() const { return effects_; }

  /// Objects that an lvalue may be in; more than its own where it is reached through a pointer.
  ObjectSet ObjectsOf(ExprId lvalue) const;
  /// Objects that the value of a pointer expression may refer to.
  ObjectSet TargetsOf(ExprId pointer) const;
  const ObjectSet& TargetsOf(VariableId pointer) const { return targets_[pointer.index]; }
  const ObjectSet& ResultTargets(FunctionId function) const { return result_targets_[function.index]; }

  /// The place of an lvalue, or what a pointer refers to, when constants tell it.
  std::optional<StaticAddress> AddressOf(ExprId lvalue) const;
  std::optional<StaticAddress> PointeeOf(ExprId pointer) const;
  /// The bit-field that an lvalue is; null: it is none.
  const Member* BitFieldOf(ExprId lvalue) const;
  /// The bytes of an lvalue that is a whole integer at a constant place. Not of a bit-field, which shares its bytes
  /// with others, nor of a real number that a union has there.
  std::optional<Cell> IntegerCellOf(ExprId lvalue) const;

  /// Which parts reach the function; 0: none.
  uint8_t PartsOf(FunctionId function) const { return parts_[function.index]; }
  const std::vector<FunctionId>& CalleesOf(FunctionId function) const { return callees_[function.index]; }
  /// Objects that a call of the function may change, its callees included.
  const ObjectSet& WritesOf(FunctionId function) const { return writes_[function.index]; }
  /// Objects that the expression itself stores into, calls included; parts of it are not looked at.
  ObjectSet WritesOf(const Expr& expr) const;

  /// Whether the expression itself, calls included, may store into bytes of the cell.
  bool MayChange(const Expr& expr, const Cell& cell) const;

  const std::vector<Registration>& registrations() const { return registrations_; }
  /// Whether the variable has bytes in memory: its address is taken, or it is no scalar.
  bool IsInMemory(VariableId variable) const { return in_memory_[variable.index]; }

 private:
  void FindRegistrations();
  void FindCallees();
  void Reach(FunctionId from, uint8_t part);
  void FindMemory();
  void FindTargets();
  void FindWrites();
  void FindStores();
  /// The cell of a store at a constant place.
  std::optional<Cell> CellOfStore(const Expr& store) const;
  ObjectSet SystemWrites(const Expr& call) const;
  std::optional<int64_t> ConstantOf(ExprId id) const;
  std::optional<StaticAddress> Moved(const std::optional<StaticAddress>& base, ExprId index, TypeId element,
                                     int64_t sign) const;

  const Unit& unit_;
  const Objects& objects_;
  Effects effects_;
  std::vector<ObjectSet> targets_;         // by VariableId
  std::vector<ObjectSet> result_targets_;  // by FunctionId
  std::vector<ObjectSet> writes_;          // by FunctionId
  /// What a call may change, finer: single cells, and objects of which any byte may be meant.
  struct Stores {
    std::set<Cell> cells;
    ObjectSet objects;
    bool Add(const Stores& other);
  };
  std::vector<Stores> stores_;  // by FunctionId
  std::vector<std::vector<FunctionId>> callees_;
  std::vector<uint8_t> parts_;
  std::vector<bool> in_memory_;
  std::vector<Registration> registrations_;
};

}  // namespace plcxx::hnc
