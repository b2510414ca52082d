#include "transpiler/dialects/nc110/control/documentation.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "transpiler/dialects/nc110/analysis/accesses.h"
#include "transpiler/dialects/nc110/machine/machine.h"
#include "transpiler/dialects/nc110/machine/signals.h"

namespace plcxx::nc110 {
namespace {

/// As an entry's place in the list; I and U of one bit stand together.
uint64_t SymbolOrder(const Operand& operand) {
  const auto kind = static_cast<uint64_t>(operand.kind);
  if (!IsMemory(operand)) {
    const bool timer = operand.kind < OperandKind::kCounterInput, shot = operand.kind == OperandKind::kOneShot;
    const uint64_t group = timer ? 0 : shot ? 2 : 1;
    return uint64_t{1} << 40 | group << 36 | static_cast<uint64_t>(operand.number) << 16 | kind;
  }
  const uint64_t index = operand.kind == OperandKind::kWord ? 0 : 1 + uint64_t{operand.index};
  return static_cast<uint64_t>(operand.package) << 32 | uint64_t{ByteOf(operand)} << 16 | index << 8 | kind;
}

std::string_view CommentText(std::string_view comment) {
  if (comment.starts_with(';')) comment.remove_prefix(1);
  return Trim(comment);
}

}  // namespace

std::vector<ir::Documentation> Document(const Program& tree, const Settings& settings,
                                        const source::SourceManager& sources, const HelpTexts& help) {
  std::vector<std::pair<uint64_t, Operand>> used;
  std::vector<bool> known(1u << 19);
  const auto add = [&](const Operand& operand) {
    if (operand.kind == OperandKind::kNone) return;
    // 4 bits of kind, 2 of package, 8 of number and 5 of index tell all operands apart.
    const uint32_t key = static_cast<uint32_t>(operand.kind) << 15 | static_cast<uint32_t>(operand.package) << 13 |
                         static_cast<uint32_t>(operand.number & 0xFF) << 5 | (operand.index & 0x1Fu);
    if (known[key]) return;
    known[key] = true;
    used.emplace_back(SymbolOrder(operand), operand);
  };
  for (const Symbol& symbol : tree.symbols) add(symbol.operand);
  ForEachAccess(tree, [&](const Access& access) { add(access.operand); });
  std::sort(used.begin(), used.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  std::multimap<uint64_t, const Symbol*> symbols;  // equal keys keep the order of definition
  for (const Symbol& symbol : tree.symbols) symbols.emplace(SymbolOrder(AsBit(symbol.operand)), &symbol);

  std::vector<ir::Documentation> entries;
  entries.reserve(used.size());
  for (const auto& [order, operand] : used) {
    ir::Documentation entry{.address = ToText(operand), .symbols = {}, .predefined = {}, .meaning = {}, .help = {}};
    std::string_view comment;
    const auto [first, last] = symbols.equal_range(SymbolOrder(AsBit(operand)));
    for (auto at = first; at != last; ++at) {
      if (!entry.symbols.empty()) entry.symbols += ", ";
      entry.symbols += at->second->name;
      if (comment.empty()) comment = CommentText(sources.Text(at->second->comment));
    }
    entry.predefined = PredefinedName(operand, settings.processes);
    entry.meaning = Meaning(operand, settings.processes);
    if (entry.meaning.empty()) entry.meaning = comment;
    if (const HelpEntry* described = help.Find(operand)) {
      entry.help = described->text;
      if (entry.predefined.empty()) entry.predefined = described->name;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace plcxx::nc110
