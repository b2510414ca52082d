#include "transpiler/dialects/classicladder/lowering/names.h"

#include <algorithm>
#include <string_view>

namespace plcxx::classicladder {

namespace {

bool FitsCode(std::string_view symbol) {
  return std::ranges::all_of(symbol, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

VariableKey KeyOf(const Address& address) { return {static_cast<uint32_t>(address.kind), address.number}; }

Names::Names(const Program& tree) {
  std::map<std::string_view, uint32_t> uses;
  for (const Symbol& symbol : tree.symbols) ++uses[symbol.name];
  for (const Symbol& symbol : tree.symbols) {
    if (uses[symbol.name] > 1 || !FitsCode(symbol.name) || AddressByName(symbol.name)) continue;
    const VariableInfo& info = Info(symbol.address.kind);
    for (const VariableInfo& each : Variables()) {
      const bool same = symbol.whole ? each.name == info.name : each.kind == info.kind;
      if (!same || (symbol.whole && each.attribute.empty())) continue;
      std::string name = symbol.name;
      if (symbol.whole) name += "." + std::string(each.attribute);
      symbols_.emplace(KeyOf({each.kind, symbol.address.number}), std::move(name));
    }
  }
}

std::string Names::Of(const Address& address) const {
  const auto symbol = symbols_.find(KeyOf(address));
  return symbol == symbols_.end() ? NameOf(address) : symbol->second;
}

}  // namespace plcxx::classicladder
