// The objects that pointers and stores of a program can be about: register areas, variables, string literals
// (specification 6.5). A pointer value is an object and a byte offset in it.
//
// In: the tree. Out: numbers and sizes. Not its job: which objects a pointer may refer to (facts.h), where an object's
// bytes are (lowering).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/dialects/hnc/syntax/syntax.h"

namespace plcxx::hnc {

using ObjectId = support::Id<struct ObjectTag>;

enum class ObjectKind : uint8_t {
  kArea,
  kVariable,
  kString,
  kResult  // what a function gives back, when that is a record
};

struct Object {
  ObjectKind kind = ObjectKind::kVariable;
  std::string name;    // "R", "table", "swap.i"
  uint32_t size = 0;   // bytes
  uint32_t index = 0;  // the Area, VariableId, index into Unit::strings, FunctionId
};

/// A set of objects, ascending; or "cannot be told".
struct ObjectSet {
  std::vector<ObjectId> objects;
  /// Gives whether the set has grown.
  bool Add(ObjectId object);
  bool Add(const ObjectSet& other);
  bool Has(ObjectId object) const;
};

/// A place known at compile time.
struct StaticAddress {
  ObjectId object;
  int64_t offset = 0;  // bytes; may lie outside of the object
  bool operator==(const StaticAddress&) const = default;
};

/// A scalar at a constant place: what a fact is about.
struct Cell {
  ObjectId object;
  int64_t offset = 0;
  uint32_t size = 0;
  auto operator<=>(const Cell&) const = default;
  bool Overlaps(const Cell& other) const {
    return object == other.object && offset < other.offset + other.size && other.offset < offset + size;
  }
};

class Objects {
 public:
  explicit Objects(const Unit& unit);

  const Object& operator[](ObjectId id) const { return objects_[id]; }
  uint32_t size() const { return objects_.size(); }
  ObjectId OfArea(Area area) const { return ObjectId(static_cast<uint32_t>(area)); }
  /// None for the names of the system header.
  ObjectId OfVariable(VariableId variable) const { return of_variable_[variable.index]; }
  ObjectId OfString(uint32_t string) const { return ObjectId(first_string_ + string); }
  ObjectId OfResult(FunctionId function) const { return ObjectId(first_result_ + function.index); }
  bool IsArea(ObjectId id, Area area) const { return id == OfArea(area); }

 private:
  support::Store<ObjectId, Object> objects_;
  std::vector<ObjectId> of_variable_;  // by VariableId
  uint32_t first_string_ = 0, first_result_ = 0;
};

}  // namespace plcxx::hnc
