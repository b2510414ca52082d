// The system functions that move axes and read handwheels (specification 6.10, 8.2): parameters, results, and the
// function of the host that each is with --set sysfunc=host.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "transpiler/dialects/hnc/syntax/syntax.h"
#include "transpiler/ir/program.h"

namespace plcxx::hnc {

inline constexpr uint32_t kAxes = 16, kHandwheels = 4;

struct SystemParameter {
  std::string_view name;
  ir::Type type = ir::Type::kNone;
  uint32_t count = 0;  // of axes or handwheels, from 0; 0: any number
};

enum class SystemResult : uint8_t { kNone, kInt, kLong, kTruth };

/// Those that have a row here, for what is said of each of them.
enum class SystemRoutine : uint8_t {
#define HNC_SYSTEM_FUNCTION(name, ...) k##name,
#include "transpiler/dialects/hnc/lowering/system_functions.def"
};

struct SystemSignature {
  SystemFunction function;
  SystemRoutine routine;
  std::string_view host_name;
  std::string_view comment;
  SystemResult result;
  uint8_t outside;  // what it gives of a number that is none
  std::array<SystemParameter, 3> parameters;

  constexpr size_t count() const {
    size_t count = 0;
    while (count < parameters.size() && !parameters[count].name.empty()) ++count;
    return count;
  }
  constexpr ir::Type result_type() const {
    if (result == SystemResult::kNone) return ir::Type::kNone;
    return result == SystemResult::kLong ? ir::Type::kI32 : ir::Type::kI16;
  }
};

/// Null: it is a library function, or set_mst_func.
const SystemSignature* SignatureOf(SystemFunction function);

}  // namespace plcxx::hnc
