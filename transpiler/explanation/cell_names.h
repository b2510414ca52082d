// What a person calls the cells of a program: the places that have them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "transpiler/ir/program.h"
#include "transpiler/symbolic/execute/cells.h"

namespace plcxx::explanation {

class CellNames {
 public:
  /// Both outlive the object.
  CellNames(const ir::Program& program, const execute::Cells& cells);

  /// The bit, or the field, that is exactly this cell.
  const ir::Place* ExactPlace(execute::CellId cell) const { return At(exact_, cell); }
  /// The smallest byte or word that has it.
  const ir::Place* Word(execute::CellId cell) const { return At(words_, cell); }

  /// "U4A8 (COOLANT: coolant pump)": the address, and what else the source has for it.
  std::string NameOf(const ir::Place& place) const;

 private:
  const ir::Place* At(const std::vector<uint32_t>& places, execute::CellId cell) const {
    const uint32_t place = places[cell.index];
    return place == kNone ? nullptr : &program_.places[ir::PlaceId(place)];
  }

  static constexpr uint32_t kNone = ~uint32_t{0};
  const ir::Program& program_;
  std::vector<uint32_t> exact_, words_;  // by cell: number of the place
};

}  // namespace plcxx::explanation
