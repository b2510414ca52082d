// A drawn ladder (specification 3.6): rows of characters to cells, cells to nets, nets to an order of evaluation.
//
//   |--[ %I0 ]--+--( %Q0 )        elements 0, 1, 2; the net right of 0 and 1 feeds 2:
//   |--[ %Q0 ]--+                 order 0, 1, 2; inputs rail, rail, {0, 1}
//
// In: rows as ranges of a source; then, for each element, what the parser made of its contents. Out: the wiring. The
// errors E601 to E608 are reported here. Not its job: what stands in the brackets.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/dialects/host50/machine/machine.h"
#include "transpiler/source/source.h"

namespace plcxx::host50 {

struct DrawnElement {
  char bracket = '[';  // the opening one
  uint32_t row = 0;
  source::Range range;     // with its brackets
  source::Range contents;  // without them
};

enum class CellKind : uint8_t { kRail, kWire, kJunction, kLink, kElement };

/// What occupies the display columns [begin, end) of a row.
struct DrawnCell {
  CellKind kind{};
  uint32_t begin = 0, end = 0;
  uint32_t element = 0;  // kElement: its index
  source::Range range;
};

struct DrawnRow {
  std::vector<DrawnCell> cells;  // from left to right; none: the row breaks vertical links
  source::Range comment;         // from ';' on; empty where there is none
};

struct Drawing {
  std::vector<DrawnRow> rows;
  std::vector<DrawnElement> elements;  // by row, then column
  std::optional<uint32_t> rail;        // its column
  uint32_t rows_with_cells = 0;
  bool readable = true;  // no E601 or E602: its connections can be checked
  bool faulty = false;   // an error was reported
};

/// Reads one row: E601, E602, E606.
void AddRow(const source::File& file, source::Range row, Drawing& drawing, diag::Engine& diagnostics);

/// What the parser found in the brackets of an element.
struct ElementMeaning {
  std::optional<Op> op;  // none: unknown
  bool faulty = false;   // an error was reported for it; Connect sets it, too
};

struct ElementInput {
  bool from_rail = false;
  std::vector<uint32_t> sources;  // the elements whose right ends are on its net
};

struct Wiring {
  std::vector<uint32_t> order;       // of evaluation (rule 8)
  std::vector<ElementInput> inputs;  // by element
};

/// E603 to E605, E608. None when the drawing has errors.
std::optional<Wiring> Connect(Drawing& drawing, std::span<ElementMeaning> meanings, diag::Engine& diagnostics);

}  // namespace plcxx::host50
