// SYMBOLS, predefined names, and what addresses and names stand for (specification 2.5, 2.6, 8).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "transpiler/dialects/host50/machine/addresses.h"
#include "transpiler/dialects/host50/parser/statement_reader.h"

namespace plcxx::host50 {

class SymbolReader : private StatementReader {
 public:
  using StatementReader::StatementReader;

  struct Resolved {
    bool ok = false;
    Address address;
    SymbolId symbol;
  };

  void ReadSymbolRow(const Line& line);
  /// Names of the control's own signals that the program does not define itself.
  void AddPredefinedSymbols();
  /// An address or symbol at the cursor, which moves after it.
  Resolved ReadAddress();
  Resolved ResolveAddress(const Token& token);

 private:
  SymbolId SymbolNamed(std::string_view name);
  void FaultOfAddressNumber(const Token& token);
  std::string SymbolWithSign(const Token& token);
  bool IsAddressWithoutSign(std::string_view name) const;
  void FaultOfUnknownName(const Token& token, std::string_view name);
  Resolved ResolveName(const Token& token, std::string_view name, std::string_view attribute);
  std::string RangesText(Area area) const;

  std::map<std::string, SymbolId, std::less<>> names_;
  std::set<std::string, std::less<>> poisoned_names_;  // defined with a fault
  std::set<std::pair<Area, uint16_t>> named_addresses_;
  uint32_t near_searches_ = 0;
};

}  // namespace plcxx::host50
