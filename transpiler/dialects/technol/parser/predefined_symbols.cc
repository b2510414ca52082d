#include "transpiler/dialects/technol/parser/predefined_symbols.h"

#include "transpiler/dialects/technol/machine/signals.h"

namespace plcxx::technol {
namespace {

constexpr std::string_view kColumns = "a table with the columns address,name,width,direction,meaning";

Symbol SymbolOf(const Signal& signal, SymbolOrigin origin) {
  Symbol symbol{.origin = origin, .direction = signal.direction, .area = signal.area, .offset = signal.byte};
  symbol.name = signal.name;
  symbol.meaning = signal.meaning;
  symbol.bytes = (signal.width + 7) / 8;
  if (signal.width == 1) {
    symbol.kind = SymbolKind::kBit;
    symbol.width = 1;
    symbol.bit = signal.bit;
  } else if (origin == SymbolOrigin::kControl && IsField(signal)) {
    symbol.kind = SymbolKind::kField;
    symbol.value = signal.byte;
    symbol.width = FieldWidth(signal);
  } else {
    symbol.kind = SymbolKind::kCell;
    symbol.width =
        signal.width == 8 || signal.width == 16 || signal.width == 32 ? static_cast<uint8_t>(signal.width) : 0;
  }
  return symbol;
}

}  // namespace

void AddControlSymbols(SymbolTable& names) {
  for (const Signal& signal : Signals()) names.Add(SymbolOf(signal, SymbolOrigin::kControl), 0);
}

void AddSignalFile(dialects::Request& request, ParsingContext& context) {
  const std::string& path = context.settings.signals;
  if (path.empty()) return;
  const auto loaded = request.load(path);
  if (const auto* error = std::get_if<source::LoadError>(&loaded)) {
    context.diagnostics.Report({}, diag::CannotReadSource, path, error->detail.empty() ? "no such file" : error->detail,
                               source::RemedyOf(error->problem));
    return;
  }
  const source::FileId file = std::get<source::FileId>(loaded);
  const source::File& text = context.sources.Get(file);
  for (uint32_t i = 0; i < context.sources.LineCount(file); ++i) {
    const std::string_view row = TrimBlanks(context.sources.Line(file, i + 1));
    if (row.empty() || IsSignalHead(row)) continue;
    const source::Offset begin = text.base + text.line_starts[i];
    const source::Range range = {begin, begin + static_cast<source::Offset>(row.size())};
    const std::optional<Signal> signal = ReadSignal(row);
    if (!signal) {
      context.diagnostics.Report(range, diag::BadOptionValue, "signals", row, kColumns);
      continue;
    }
    Symbol symbol = SymbolOf(*signal, SymbolOrigin::kSignals);
    symbol.range = range;
    const SymbolId known = context.names.Find(symbol.name);
    if (!known.valid()) {
      context.names.Add(std::move(symbol), 0);
      continue;
    }
    const Symbol& other = context.names[known];
    const bool same = other.area == symbol.area && other.offset == symbol.offset && other.bit == symbol.bit &&
                      other.bytes == symbol.bytes;
    if (!same) context.diagnostics.Report(range, diag::TechnolPredefined, symbol.name);
  }
}

}  // namespace plcxx::technol
