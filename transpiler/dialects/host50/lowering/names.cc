#include "transpiler/dialects/host50/lowering/names.h"

namespace plcxx::host50 {

/// The first named one of an address names it; the program's own stand before the control's.
Names::Names(const Context& context) : Context(context) {
  for (uint32_t i = 0; i < tree_.symbols.size(); ++i) {
    const Symbol& symbol = tree_.symbols[SymbolId(i)];
    if (!symbol.name.empty()) symbols_.emplace(KeyOf(WithoutAttribute(symbol.address)), SymbolId(i));
  }
}

std::string Names::Spelled(const Address& address) const {
  const auto symbol = symbols_.find(KeyOf(WithoutAttribute(address)));
  if (symbol == symbols_.end()) return NameOf(address);
  const std::string attribute = NameOf(address).substr(NameOf(WithoutAttribute(address)).size());
  return tree_.symbols[symbol->second].name + attribute;
}

std::string Names::InCode(const Address& address) const {
  return host50::NameInCode(Spelled(address), address, ChannelsOf(program_));
}

}  // namespace plcxx::host50
