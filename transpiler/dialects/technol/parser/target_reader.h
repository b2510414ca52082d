// Labels and mechanisms as operands (specification 6.4, 6.7).
#pragma once

#include <string>

#include "transpiler/dialects/technol/parser/operand_reader.h"

namespace plcxx::technol {

class TargetReader : private OperandReader {
 public:
  using OperandReader::OperandReader;

  void ReadJump();
  void ReadCall();
  void ReadMechanism();
  /// RET is in the subprogram area only.
  void CheckReturn();

 private:
  void CheckJumpTarget(LabelId label, source::Range range);
  bool HasTakenTheRest(UnitId unit) const;
  std::string UnitName(UnitId unit) const;
};

}  // namespace plcxx::technol
