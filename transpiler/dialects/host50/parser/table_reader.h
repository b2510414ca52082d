// TITLE, SYMBOLS, ALARMS, MCODES (specification 8, 9).
#pragma once

#include <set>
#include <span>
#include <string>
#include <string_view>

#include "transpiler/dialects/host50/parser/parts.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"
#include "transpiler/dialects/host50/parser/symbol_reader.h"

namespace plcxx::host50 {

class TableReader : private StatementReader {
 public:
  TableReader(Parsing& parsing, SymbolReader& symbols) : StatementReader(parsing), symbols_(symbols) {}

  void ReadTables(std::span<const TablePart> tables);

 private:
  void ReadTitleRow(const Line& line);
  void ReadAlarmRow(const Line& line);
  void ReadMCodeRow(const Line& line);
  /// The string that ends a row.
  std::string ReadLastString(std::string_view what);

  SymbolReader& symbols_;
  std::set<uint32_t> alarms_, mcodes_;
  std::set<TitleKey> title_keys_;
};

}  // namespace plcxx::host50
