#include "transpiler/dialects/hnc/lowering/system_functions.h"

#include <algorithm>
#include <iterator>

namespace plcxx::hnc {

namespace {

consteval SystemParameter Axis(std::string_view name) { return {name, ir::Type::kI16, kAxes}; }
consteval SystemParameter Wheel(std::string_view name) { return {name, ir::Type::kI16, kHandwheels}; }
consteval SystemParameter Int(std::string_view name) { return {name, ir::Type::kI16, 0}; }
consteval SystemParameter Long(std::string_view name) { return {name, ir::Type::kI32, 0}; }

constexpr SystemSignature kSignatures[] = {
#define HNC_SYSTEM_FUNCTION(name, host, comment, result, outside, ...) \
  {SystemFunction::k##name, SystemRoutine::k##name, host, comment, SystemResult::k##result, outside, {{__VA_ARGS__}}},
#include "transpiler/dialects/hnc/lowering/system_functions.def"
};

}  // namespace

const SystemSignature* SignatureOf(SystemFunction function) {
  const auto* const row = std::ranges::find(kSignatures, function, &SystemSignature::function);
  return row == std::end(kSignatures) ? nullptr : row;
}

}  // namespace plcxx::hnc
