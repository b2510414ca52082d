#include "transpiler/dialects/technol/parser/symbol_table.h"

#include <algorithm>

#include "transpiler/dialects/technol/source/lexer.h"
#include "transpiler/support/check.h"

namespace plcxx::technol {

std::string SymbolTable::Fold(std::string_view name) const {
  return rule_ == CaseRule::kSensitive ? std::string(name) : Upper(name);
}

SymbolId SymbolTable::Find(std::string_view name) const {
  const auto found = ids_.find(Fold(name));
  return found == ids_.end() ? SymbolId() : found->second;
}

SymbolId SymbolTable::Add(Symbol symbol, uint32_t when) {
  const std::string key = Fold(symbol.name);
  const SymbolId id = symbols_.Add(std::move(symbol));
  PLCXX_CHECK(ids_.emplace(key, id).second);
  defined_.push_back(when);
  return id;
}

void SymbolTable::Assign(SymbolId constant, int64_t value, uint32_t when) {
  Symbol& symbol = symbols_[constant];
  auto& values = assigned_[constant];
  if (values.empty()) values.emplace_back(defined_[constant.index], symbol.value);
  values.emplace_back(when, value);
  symbol.value = value;
}

int64_t SymbolTable::ValueAt(SymbolId symbol, uint32_t when) const {
  const auto found = assigned_.find(symbol);
  if (found == assigned_.end()) return symbols_[symbol].value;
  const auto behind = std::ranges::upper_bound(found->second, when, {}, &std::pair<uint32_t, int64_t>::first);
  return behind == found->second.begin() ? behind->second : std::prev(behind)->second;
}

std::string_view KindText(const Symbol& symbol) {
  switch (symbol.kind) {
    case SymbolKind::kCell:
      return "a cell";
    case SymbolKind::kBit:
      return "a bit";
    case SymbolKind::kMechanism:
      return "a mechanism";
    case SymbolKind::kConstant:
      return "a constant";
    case SymbolKind::kField:
      return "a field, which is a constant";
    case SymbolKind::kStructure:
      return "a structure";
    case SymbolKind::kLabel:
      return "a label";
    case SymbolKind::kMacro:
      return "a macro";
  }
  return "";
}

}  // namespace plcxx::technol
