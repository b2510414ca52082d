// What the control of dialect hnc has: register areas with their views, and the functions that it supplies.
//
// Data only; machine.def and functions.def hold the rows. headers.h makes the text of the headers from the same rows.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "transpiler/dialects/hnc/machine/control_names.h"
#include "transpiler/ir/op.h"

namespace plcxx::hnc {

struct AreaRow {
  Area area;
  std::string_view name;   // "X"
  uint32_t bytes;          // 5.1
  std::string_view basic;  // C type of the basic view
  bool table;              // F, G
};

/// In the order of `Area`.
std::span<const AreaRow> Areas();
const AreaRow& RowOf(Area area);

struct ViewRow {
  std::string_view suffix;  // "_ui"; empty: the basic view
  std::string_view type;    // C type of an element; empty: the area's basic one
};

/// The six views with a suffix.
std::span<const ViewRow> Views();

/// A variable of the system header, "R_ui": its area and the C type of its elements (of a table: what they point to).
struct SystemName {
  Area area;
  std::string_view type;
};
/// None when it is no view of an area.
std::optional<SystemName> FindSystemName(std::string_view name);

/// How a call of a function is lowered.
enum class FunctionForm : uint8_t {
  kControl,   // axes, handwheels, set_mst_func: lowering/system_calls.h
  kAbsolute,  // one operation of an integer
  kRotation,  // one operation of an integer and a count
  kReal,      // one operation of a double
  kMemory,    // of bytes behind pointers
  kCritical,  // a statement of the tree; in an expression it does nothing
};

enum class FunctionWrites : uint8_t {
  kNothing,
  kAxisRegisters,  // G
  kTarget,         // what its first argument points to
};

struct FunctionRow {
  SystemFunction function;
  std::string_view name;       // "set_axis_home"
  std::string_view headers;    // after which it is known, with blanks in between
  std::string_view prototype;  // "void set_axis_home(int, int);"
  FunctionForm form;
  /// Of kAbsolute, kRotation and kReal: the result follows from the arguments alone, and nothing is written.
  std::optional<ir::OpKind> operation;
  FunctionWrites writes;
};

std::span<const FunctionRow> SystemFunctions();
const FunctionRow& RowOf(SystemFunction function);
const FunctionRow* FindSystemFunction(std::string_view name);
/// Is the function known after this header?
bool IsDeclaredBy(const FunctionRow& row, std::string_view header);

}  // namespace plcxx::hnc
