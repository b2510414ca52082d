#include "transpiler/dialects/technol/parser/structure_reader.h"

#include <algorithm>
#include <utility>

#include "transpiler/dialects/technol/machine/signals.h"
#include "transpiler/dialects/technol/parser/values.h"

namespace plcxx::technol {
namespace {

bool IsFieldDirective(const std::string& word) {
  constexpr std::string_view kDirectives[] = {"DB", "DW", "DD", "DB?", "DW?", "DD?"};
  return std::ranges::find(kDirectives, word) != std::end(kDirectives);
}

/// Data, units and STOP are in no structure.
bool BeginsSection(const std::string& word) {
  return word == "DATA" || word == "DATA_END" || word == "START" || word == "STOP" || word == "MECH_BEGIN" ||
         word.starts_with("MODULE_") || word.starts_with("PRIPRAVNE_") || word.starts_with("ZAVERECNE_");
}

/// Lines that stand where structures stand, and are in none.
bool IsDefinition(const std::string& first, const std::string& second) {
  return first == "EQUI" || first == "T_INCLUDE" || first == "INCLUDE" || second == "EQU" || second == "MACRO" ||
         second == "STRUC" || second == "STRUCT";
}

/// `ENDS` alone, `ENDS NAME`, `NAME NAME ENDS`, `NAME END`: the end is meant, and is not written as one.
bool IsMeantEnd(std::span<const Token> words) {
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string word = UpperWord(words, i);
    if (word == "ENDS" || word == "END" || word == "ENDSTRUC" || word == "ENDSTRUCT") return true;
  }
  return false;
}

}  // namespace

void StructureReader::OpenStructure(const Statement& statement) {
  const Token& name = statement.first();
  if (CurrentUnit().valid()) {
    context_.Report(statement.range, diag::TechnolStrayLine, context_.sources.Text(statement.range),
                    "stands outside modules and mechanisms");
  }
  ExpectEnd(statement, 2);
  comments_.TakeComments(statement);
  open_ = {.name = std::string(name.text), .range = name.range};
  const SymbolId known = context_.names.Find(name.text);
  // The same once more is decided when it is complete: a file that is included twice, the control's own structures.
  const bool again = known.valid() && context_.names[known].kind == SymbolKind::kStructure;
  if (again) {
    open_->symbol = known;
  } else {
    open_->symbol = context_.Define(name, {.kind = SymbolKind::kStructure});
    if (open_->symbol.valid()) context_.names[open_->symbol].faulty = true;  // until its end
  }
}

bool StructureReader::ReadLine(const Statement& statement) {
  const std::span<const Token> words = statement.words;
  const std::string first = UpperWord(words, 0), second = UpperWord(words, 1);
  if (second == "ENDS") {
    CloseStructure(statement);
  } else if (IsFieldDirective(first)) {
    ReadField(statement, statement.label, 0);
  } else if (IsFieldDirective(second) && statement.label == nullptr) {
    ReadField(statement, words.data(), 1);
  } else if (BeginsSection(first) || IsDefinition(first, second)) {
    LeaveOpenStructure(statement.range);
    return false;
  } else {
    ReportNoField(statement);
    if (IsMeantEnd(words)) FinishStructure();
  }
  return true;
}

/// One wrong line may be all that is wrong: what follows may be no part of the structure.
void StructureReader::ReportNoField(const Statement& statement) {
  if (std::exchange(open_->has_wrong_line, true)) return;
  const std::span<const Token> words = statement.words;
  context_.Report(statement.range, diag::TechnolSyntax,
                  "'" + std::string(words.empty() ? statement.label->text : words[0].text) + "'",
                  "a field (DB, DW or DD) or '" + open_->name + " ENDS'");
}

void StructureReader::ReadField(const Statement& statement, const Token* name, size_t directive) {
  const std::span<const Token> words = statement.words;
  const Token& word = words[directive];
  const std::string keyword = UpperWord(words, directive);
  StructureField field{.offset = static_cast<uint32_t>(open_->initial.size())};
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
  } else if (ReadValues(reader, field.width, bytes, context_) && !reader.AtEnd()) {
    context_.Report(reader.Here(), diag::TechnolSurplus, Shown(reader.Peek()), word.text);
  }
  if (open_->initial.size() + bytes.size() > kUserBytes) {
    context_.Report(statement.range, diag::TechnolDataTooLarge, open_->name);
    return;
  }
  field.bytes = static_cast<uint32_t>(bytes.size());
  open_->initial.insert(open_->initial.end(), bytes.begin(), bytes.end());
  open_->fields.push_back(field);
  if (name != nullptr) DefineField(*name, field);
  comments_.AddComment(statement, CommentPlace::kTrailing);
  comments_.TakeComments();
}

void StructureReader::DefineField(const Token& name, const StructureField& field) {
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

void StructureReader::CloseStructure(const Statement& statement) {
  const Token& name = statement.first();
  if (!open_) {
    context_.Report(statement.range, diag::TechnolEndsWithout, name.text);
    return;
  }
  ExpectEnd(statement, 2);
  if (context_.names.Fold(name.text) != context_.names.Fold(open_->name)) {
    context_.Report(statement.range, diag::TechnolEndsMismatch, name.text, open_->name)
        .notes.push_back({open_->range, "it was opened here"});
  }
  FinishStructure();
  comments_.TakeComments(statement);
}

void StructureReader::LeaveOpenStructure(source::Range place) {
  if (!open_) return;
  if (!open_->has_wrong_line) context_.Report(place, diag::TechnolEndsMissing, open_->name);
  FinishStructure();
}

const Structure* StructureReader::Find(SymbolId symbol) const {
  const auto found = structures_.find(symbol);
  return found == structures_.end() ? nullptr : &found->second;
}

void StructureReader::FinishStructure() {
  Structure structure = std::move(*open_);
  open_.reset();
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

void StructureReader::AddControlStructures() {
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
