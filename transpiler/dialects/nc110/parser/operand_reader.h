// Operands, symbols and constants where the program uses them (specification 2.4 to 2.6).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/open_blocks.h"

namespace plcxx::nc110 {

struct ConstantUse {
  uint32_t value = 0;
  bool well_formed = false;
  source::Range range;
  std::string_view text;
};

class OperandReader : private ItemReader {
 public:
  OperandReader(Parsing& parsing, OpenBlocks& open_blocks) : ItemReader(parsing), open_blocks_(open_blocks) {}

  /// At kOperand, kSymbol or kRun.
  OperandUse TakeOperand();
  Operand ReadOperand(std::string_view run, source::Range range);
  void FaultOfUnknown(std::string_view run, source::Range range);
  ConstantUse TakeConstant();
  void ReportMalformedNumber(const Token& token);
  /// Of what begins a statement, and so is assigned to.
  void ReportMalformedTarget(const Token& token);
  /// An expression has one more; too many are a hard fault.
  void CountOperand();
  void DefineSymbol(Symbol symbol);

 private:
  SymbolId FindSymbol(std::string_view name) const;
  void FaultOfUndefined(const Token& token, std::string_view name);

  OpenBlocks& open_blocks_;
  std::map<std::string, SymbolId, std::less<>> symbols_;  // by the first 10 characters
  std::set<std::string, std::less<>> undefined_;          // already reported
  bool table_full_reported_ = false;
};

}  // namespace plcxx::nc110
