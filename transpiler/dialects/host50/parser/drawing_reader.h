// Drawings: what stands in the brackets becomes instructions, in the order of evaluation (specification 3.6).
#pragma once

#include <optional>
#include <vector>

#include "transpiler/dialects/host50/parser/drawing.h"
#include "transpiler/dialects/host50/parser/instruction_reader.h"
#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class DrawingReader : private StatementReader {
 public:
  DrawingReader(Parsing& parsing, InstructionReader& instructions)
      : StatementReader(parsing), instructions_(instructions) {}

  /// The rows from line `first` on; gives the line after the last one.
  uint32_t ReadDrawing(const Body& body, uint32_t first, std::vector<source::Range>& comments);

 private:
  void ReadElement(const DrawnElement& element, Instruction& instruction);
  void ReadContactOrCoil(const DrawnElement& element, Instruction& instruction);
  void ReadDrawnBlock(Instruction& instruction);
  void AddRowComments(const Drawing& drawing, const std::vector<std::vector<source::Range>>& above,
                      std::vector<Instruction>& instructions);
  void AddElements(const std::optional<Wiring>& wiring, const std::vector<Instruction>& instructions);

  InstructionReader& instructions_;
};

}  // namespace plcxx::host50
