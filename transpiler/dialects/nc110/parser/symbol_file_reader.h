// Symbol files: "* remark", then one "name = operand" per line (specification 9.1).
#pragma once

#include <string_view>

#include "transpiler/dialects/nc110/parser/item_reader.h"
#include "transpiler/dialects/nc110/parser/operand_reader.h"

namespace plcxx::nc110 {

class SymbolFileReader : private ItemReader {
 public:
  SymbolFileReader(Parsing& parsing, OperandReader& operands) : ItemReader(parsing), operands_(operands) {}

  /// `is_late`: a file with statements has been read.
  void ParseSymbolFile(source::FileId file, bool is_late);

 private:
  void ParseSymbolLine(std::string_view line, source::Offset begin, HomoglyphReader& homoglyphs);

  OperandReader& operands_;
};

}  // namespace plcxx::nc110
