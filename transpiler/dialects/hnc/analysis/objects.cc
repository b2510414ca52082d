#include "transpiler/dialects/hnc/analysis/objects.h"

#include <algorithm>

#include "transpiler/dialects/hnc/machine/machine.h"

namespace plcxx::hnc {

bool ObjectSet::Add(ObjectId object) {
  const auto at = std::ranges::lower_bound(objects, object);
  if (at != objects.end() && *at == object) return false;
  objects.insert(at, object);
  return true;
}

bool ObjectSet::Add(const ObjectSet& other) {
  bool grown = false;
  for (const ObjectId object : other.objects) grown = Add(object) || grown;
  return grown;
}

bool ObjectSet::Has(ObjectId object) const { return std::ranges::binary_search(objects, object); }

Objects::Objects(const Unit& unit) {
  for (const AreaRow& row : Areas()) {
    objects_.Add({.kind = ObjectKind::kArea,
                  .name = std::string(row.name),
                  .size = row.bytes,
                  .index = static_cast<uint32_t>(row.area)});
  }
  of_variable_.resize(unit.variables.size());
  for (uint32_t i = 0; i < unit.variables.size(); ++i) {
    const Variable& variable = unit.variables[VariableId(i)];
    if (variable.storage == Storage::kSystem || variable.storage == Storage::kUndefined) continue;
    std::string name = variable.name;
    if (variable.function.valid()) name = unit.functions[variable.function].name + "." + name;
    const uint32_t size = variable.type.valid() ? unit.types[variable.type].size : 0;
    of_variable_[i] = objects_.Add({.kind = ObjectKind::kVariable, .name = std::move(name), .size = size, .index = i});
  }
  first_string_ = objects_.size();
  for (uint32_t i = 0; i < unit.strings.size(); ++i) {
    objects_.Add({.kind = ObjectKind::kString,
                  .name = "string",
                  .size = static_cast<uint32_t>(unit.strings[i].size()),
                  .index = i});
  }
  first_result_ = objects_.size();
  for (uint32_t i = 0; i < unit.functions.size(); ++i) {
    const Function& function = unit.functions[FunctionId(i)];
    const uint32_t size = function.result.valid() ? unit.types[function.result].size : 0;
    objects_.Add({.kind = ObjectKind::kResult, .name = function.name + ".result", .size = size, .index = i});
  }
}

}  // namespace plcxx::hnc
