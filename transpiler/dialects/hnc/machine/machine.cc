#include "transpiler/dialects/hnc/machine/machine.h"

#include <algorithm>

namespace plcxx::hnc {
namespace {

constexpr AreaRow kAreas[] = {
#define HNC_AREA(Name, Bytes, Basic, Table) {Area::k##Name, #Name, Bytes, Basic, Table},
#include "transpiler/dialects/hnc/machine/machine.def"
};

constexpr ViewRow kViews[] = {
#define HNC_VIEW(Suffix, Type) {Suffix, Type},
#include "transpiler/dialects/hnc/machine/machine.def"
};

using ir::OpKind;

constexpr FunctionRow kFunctions[] = {
#define HNC_FUNCTION(Name, Text, Headers, Prototype, Form, Operation, Writes) \
  {SystemFunction::k##Name, Text, Headers, Prototype, FunctionForm::k##Form, Operation, FunctionWrites::k##Writes},
#include "transpiler/dialects/hnc/machine/functions.def"
};

}  // namespace

std::span<const AreaRow> Areas() { return kAreas; }
const AreaRow& RowOf(Area area) { return kAreas[static_cast<size_t>(area)]; }
std::span<const ViewRow> Views() { return kViews; }
std::span<const FunctionRow> SystemFunctions() { return kFunctions; }
const FunctionRow& RowOf(SystemFunction function) { return kFunctions[static_cast<size_t>(function)]; }

std::optional<SystemName> FindSystemName(std::string_view name) {
  for (const AreaRow& area : kAreas) {
    if (!name.starts_with(area.name)) continue;
    const std::string_view suffix = name.substr(area.name.size());
    if (suffix.empty()) return SystemName{area.area, area.basic};
    const auto* const view = std::ranges::find(kViews, suffix, &ViewRow::suffix);
    if (view != std::end(kViews)) return SystemName{area.area, view->type};
  }
  return std::nullopt;
}

const FunctionRow* FindSystemFunction(std::string_view name) {
  const auto* const row = std::ranges::find(kFunctions, name, &FunctionRow::name);
  return row == std::end(kFunctions) ? nullptr : row;
}

bool IsDeclaredBy(const FunctionRow& row, std::string_view header) {
  std::string_view rest = row.headers;
  while (!rest.empty()) {
    const size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == header) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

}  // namespace plcxx::hnc
