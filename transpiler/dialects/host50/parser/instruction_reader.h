// One instruction: its mnemonic, its operands and pins (specification 3.3 to 3.5, 6).
#pragma once

#include <map>
#include <string_view>
#include <vector>

#include "transpiler/dialects/host50/parser/expression_reader.h"
#include "transpiler/dialects/host50/parser/operand_reader.h"
#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"
#include "transpiler/dialects/host50/parser/symbol_reader.h"

namespace plcxx::host50 {

/// Where an instruction is written.
enum class Setting : uint8_t { kList, kDrawing };

class InstructionReader : private StatementReader {
 public:
  InstructionReader(Parsing& parsing, const Parts& parts, SymbolReader& symbols)
      : StatementReader(parsing), operands_(parsing, parts, symbols), expressions_(parsing, symbols, operands_) {}
  InstructionReader(const InstructionReader&) = delete;
  InstructionReader& operator=(const InstructionReader&) = delete;

  /// The mnemonic at the cursor and what follows it.
  void ReadStatement(Instruction& instruction);
  /// What stands after the mnemonic, to the end of the statement.
  void ReadOperands(Instruction& instruction, Setting setting);

 private:
  void ReadPins(Instruction& instruction, Setting setting);
  void ReadPin(const Instruction& instruction, std::vector<Pin>& pins);
  /// TONS and the like have their unit in their name.
  bool UnitIsNamed(const Instruction& instruction) const;
  /// E501: a timer belongs to one kind and one unit.
  void CheckTimer(const Instruction& instruction);
  void FaultOfUnknownInstruction(const Token& token);
  /// Where the text of an instruction's mnemonic or, in a drawing, its name in the table is.
  std::string_view MnemonicOf(const Instruction& instruction, Setting setting) const;

  OperandReader operands_;
  ExpressionReader expressions_;
  struct TimerUse {
    Op op{};
    TimerUnit unit{};
    source::Range range;
  };
  std::map<uint16_t, TimerUse> timers_;
};

}  // namespace plcxx::host50
