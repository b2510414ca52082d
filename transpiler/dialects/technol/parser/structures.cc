#include <algorithm>

#include "transpiler/dialects/technol/machine/signals.h"
#include "transpiler/dialects/technol/parser/internal.h"

namespace plcxx::technol {

void Parser::OpenStructure(const Statement& statement) {
  const Token& name = statement.first();
  if (CurrentUnit().valid()) {
    context_.Report(statement.range, diag::TechnolStrayLine, context_.sources.Text(statement.range),
                    "stands outside modules and mechanisms");
  }
  ExpectEnd(statement, 2);
  TakeComments(statement);
  structure_ = {.name = std::string(name.text), .range = name.range};
  const SymbolId known = context_.names.Find(name.text);
  // The same once more is decided when it is complete: a file that is included twice, the control's own structures.
  const bool again = known.valid() && context_.names[known].kind == SymbolKind::kStructure;
  if (again) {
    structure_->symbol = known;
  } else {
    structure_->symbol = context_.Define(name, {.kind = SymbolKind::kStructure});
    if (structure_->symbol.valid()) context_.names[structure_->symbol].faulty = true;  // until its end
  }
}

/// A line between STRUC and ENDS.
void Parser::TakeField(const Statement& statement) {
  std::span<const Token> words = statement.words;
  const Token* name = statement.label;
  const auto upper = [&words](size_t i) {
    return i < words.size() && words[i].kind == TokenKind::kWord ? Upper(words[i].text) : std::string();
  };
  if (upper(1) == "ENDS") return CloseStructure(statement);
  static constexpr std::string_view kDirectives[] = {"DB", "DW", "DD", "DB?", "DW?", "DD?"};
  const auto is_directive = [](const std::string& word) {
    return std::ranges::find(kDirectives, word) != std::end(kDirectives);
  };
  size_t directive = 0;
  if (!is_directive(upper(0)) && is_directive(upper(1)) && name == nullptr) {
    name = words.data();
    directive = 1;
  } else if (!is_directive(upper(0))) {
    const std::string first = upper(0);
    const bool ends = first == "DATA" || first == "DATA_END" || first == "START" || first == "STOP" ||
                      first == "MECH_BEGIN" || first.starts_with("MODULE_") || first.starts_with("PRIPRAVNE_") ||
                      first.starts_with("ZAVERECNE_");
    if (ends) {
      context_.Report(statement.range, diag::TechnolEndsMissing, structure_->name);
      FinishStructure();
      Statement again = statement;
      return TakeStatement(again);
    }
    context_.Report(statement.range, diag::TechnolSyntax,
                    "'" + std::string(words.empty() ? name->text : words[0].text) + "'",
                    "a field (DB, DW or DD) or '" + structure_->name + " ENDS'");
    return;
  }

  const Token& word = words[directive];
  const std::string keyword = upper(directive);
  StructureField field{.offset = static_cast<uint32_t>(structure_->initial.size())};
  field.width = keyword[1] == 'B' ? 8 : keyword[1] == 'W' ? 16 : 32;
  std::vector<Token> values;
  if (keyword.ends_with('?')) {
    context_.Report(word.range, diag::TechnolRepaired, word.text, keyword.substr(0, 2) + " ?");
    values.push_back({.kind = TokenKind::kWord, .text = word.text.substr(2), .range = word.range});
  }
  values.insert(values.end(), words.begin() + static_cast<std::ptrdiff_t>(directive) + 1, words.end());
  TokenReader reader(values);
  std::vector<uint8_t> bytes;
  if (reader.AtEnd()) {
    context_.Report(word.range, diag::TechnolOperandMissing, keyword, "a value or '?'");
  } else if (ReadValues(reader, field.width, 0, bytes) && !reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), word.text);
  }
  if (structure_->initial.size() + bytes.size() > kUserBytes) {
    context_.Report(statement.range, diag::TechnolDataTooLarge, structure_->name);
    return;
  }
  field.bytes = static_cast<uint32_t>(bytes.size());
  structure_->initial.insert(structure_->initial.end(), bytes.begin(), bytes.end());
  structure_->fields.push_back(field);
  if (name != nullptr) DefineField(*name, field);
  if (statement.comment != nullptr) AddComment(*statement.comment, CommentPlace::kTrailing);
  TakeComments();
}

void Parser::DefineField(const Token& name, const StructureField& field) {
  if (!context_.IsName(name)) return;
  const SymbolId known = context_.names.Find(name.text);
  if (known.valid() && context_.names[known].kind == SymbolKind::kField) {
    const Symbol& symbol = context_.names[known];
    if (symbol.value == field.offset && symbol.width == field.width) return;
    context_.Report(name.range, diag::TechnolFieldRedefined, name.text, symbol.value, int64_t{field.offset})
        .notes.push_back({symbol.range, "it is defined here"});
    return;
  }
  const bool faulty = context_.faulty;
  const SymbolId symbol = context_.Define(
      name, {.kind = SymbolKind::kField, .width = field.width, .bytes = field.bytes, .value = field.offset});
  if (symbol.valid()) context_.names[symbol].faulty = faulty;
}

/// name ENDS
void Parser::CloseStructure(const Statement& statement) {
  const Token& name = statement.first();
  if (!structure_) {
    context_.Report(statement.range, diag::TechnolEndsWithout, name.text);
    return;
  }
  ExpectEnd(statement, 2);
  if (context_.names.Fold(name.text) != context_.names.Fold(structure_->name)) {
    context_.Report(statement.range, diag::TechnolEndsMismatch, name.text, structure_->name)
        .notes.push_back({structure_->range, "it was opened here"});
  }
  FinishStructure();
  TakeComments(statement);
}

void Parser::FinishStructure() {
  Structure structure = std::move(*structure_);
  structure_.reset();
  if (!structure.symbol.valid()) return;
  const auto known = structures_.find(structure.symbol);
  Symbol& symbol = context_.names[structure.symbol];
  if (known == structures_.end()) {
    symbol.bytes = static_cast<uint32_t>(structure.initial.size());
    symbol.faulty = context_.faulty;
    structures_.emplace(structure.symbol, std::move(structure));
    return;
  }
  const bool same_place = symbol.range == structure.range || symbol.origin == SymbolOrigin::kControl;
  if (same_place && known->second.initial.size() == structure.initial.size()) return;
  const bool predefined = symbol.origin != SymbolOrigin::kSource;
  diag::Diagnostic& diagnostic = predefined
                                     ? context_.Report(structure.range, diag::TechnolPredefined, structure.name)
                                     : context_.Report(structure.range, diag::TechnolAlreadyDefined, structure.name);
  if (!predefined) diagnostic.notes.push_back({symbol.range, "it is defined here"});
}

/// TAB_TECHNOLS and SET_NCTABS (5.4, 5.5): their fields are those of the areas.
void Parser::AddControlStructures() {
  for (const auto& [area, name] :
       {std::pair(Area::kTabTechnol, "TAB_TECHNOLS"), std::pair(Area::kSetNctab, "SET_NCTABS")}) {
    Structure structure{.name = name};
    for (const Signal& signal : Signals()) {
      if (signal.area != area || signal.name == Name(area)) continue;
      const uint32_t bytes = signal.width / 8;
      StructureField field{.offset = signal.byte, .width = FieldWidth(signal), .bytes = bytes};
      structure.fields.push_back(field);
      structure.initial.resize(signal.byte + bytes);
    }
    structure.symbol = context_.names.Add({.kind = SymbolKind::kStructure,
                                           .origin = SymbolOrigin::kControl,
                                           .bytes = static_cast<uint32_t>(structure.initial.size()),
                                           .name = name},
                                          0);
    structures_.emplace(structure.symbol, std::move(structure));
  }
}

}  // namespace plcxx::technol
