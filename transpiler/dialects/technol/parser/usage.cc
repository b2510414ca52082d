#include "transpiler/dialects/technol/parser/usage.h"

#include <algorithm>
#include <set>

#include "transpiler/dialects/technol/parser/macros.h"

namespace plcxx::technol {

void WarnOfUnused(ParsingContext& context, std::span<const source::FileId> sources) {
  if (context.diagnostics.HasErrors()) return;  // its use may be in a statement that was not understood
  Program& program = context.program;
  std::set<std::pair<Area, uint32_t>> used_bytes;  // as a whole, by whichever of their names
  for (const Symbol& symbol : program.symbols) {
    if (symbol.kind == SymbolKind::kCell && symbol.uses > 0) used_bytes.emplace(symbol.area, symbol.offset);
  }
  std::set<SymbolId> carriers;  // bytes one of whose bits is used
  for (const Symbol& symbol : program.symbols) {
    if (symbol.kind == SymbolKind::kBit && symbol.byte.valid()) carriers.insert(symbol.byte);
  }
  for (uint32_t i = 0; i < program.symbols.size(); ++i) {
    const Symbol& symbol = program.symbols[SymbolId(i)];
    if (symbol.origin != SymbolOrigin::kSource || symbol.uses > 0 || symbol.faulty) continue;
    std::string_view kind;
    switch (symbol.kind) {
      case SymbolKind::kCell:
        if (!carriers.contains(SymbolId(i))) kind = "cell";
        break;
      case SymbolKind::kBit:
        if (!used_bytes.contains({symbol.area, symbol.offset})) kind = "bit";
        break;
      case SymbolKind::kConstant:
        if (std::ranges::find(sources, context.sources.FileAt(symbol.range.begin)) != sources.end()) kind = "constant";
        break;
      case SymbolKind::kLabel:
        kind = "label";
        break;
      case SymbolKind::kField:
      case SymbolKind::kStructure:
      case SymbolKind::kMacro:
      case SymbolKind::kMechanism:
        break;
    }
    if (kind.empty()) continue;
    context.BeginStatement(0, {});
    if (symbol.kind == SymbolKind::kBit) {
      context.Report(symbol.range, diag::TechnolUnusedBit, WrittenName(symbol.name));
    } else {
      context.Report(symbol.range, diag::TechnolUnused, kind, WrittenName(symbol.name));
    }
  }
}

}  // namespace plcxx::technol
