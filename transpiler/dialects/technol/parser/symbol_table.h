// The names of a program: found without regard to case (unless option case says otherwise), each defined once.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "transpiler/dialects/technol/machine/options.h"
#include "transpiler/dialects/technol/machine/symbols.h"

namespace plcxx::technol {

class SymbolTable {
 public:
  SymbolTable(Symbols& symbols, CaseRule rule) : symbols_(symbols), rule_(rule) {}

  /// Not valid when nothing has this name.
  SymbolId Find(std::string_view name) const;
  /// The name is free. `when`: the number of the defining statement, 0 of predefined ones.
  SymbolId Add(Symbol symbol, uint32_t when);
  /// Another value of a constant defined by '=', from statement `when` on.
  void Assign(SymbolId constant, int64_t value, uint32_t when);
  /// The value of a constant or field in statement `when`.
  int64_t ValueAt(SymbolId symbol, uint32_t when) const;
  bool IsDefinedAt(SymbolId symbol, uint32_t when) const { return defined_[symbol.index] <= when; }
  std::string Fold(std::string_view name) const;

  Symbol& operator[](SymbolId id) { return symbols_[id]; }
  const Symbol& operator[](SymbolId id) const { return symbols_[id]; }

 private:
  Symbols& symbols_;
  CaseRule rule_;
  std::unordered_map<std::string, SymbolId> ids_;  // only asked, never walked through
  std::vector<uint32_t> defined_;                  // by symbol
  std::unordered_map<SymbolId, std::vector<std::pair<uint32_t, int64_t>>> assigned_;
};

/// "a constant", "a label": what a symbol is, for messages.
std::string_view KindText(const Symbol& symbol);

}  // namespace plcxx::technol
