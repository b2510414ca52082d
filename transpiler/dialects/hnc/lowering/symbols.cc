#include "transpiler/dialects/hnc/lowering/symbols.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "transpiler/dialects/hnc/lowering/memory.h"
#include "transpiler/dialects/hnc/lowering/statement_writer.h"
#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {

void Symbols::AddSymbol(const std::string& name, TypeId type_id, uint32_t offset,
                        const std::vector<ir::Symbol::Index>& indices) {
  const Type& type = TypeAt(type_id);
  switch (type.kind) {
    case TypeKind::kInteger:
    case TypeKind::kReal:
      program_.symbols.push_back({.name = name,
                                  .type = IrType(type_id),
                                  .space = memory_.data(),
                                  .offset = offset,
                                  .bit = ir::kNoBit,
                                  .indices = indices,
                                  .has_sign = type.kind == TypeKind::kInteger && type.is_signed});
      return;
    case TypeKind::kArray: {
      std::vector<ir::Symbol::Index> inner = indices;
      inner.push_back({.count = type.count, .stride = TypeAt(type.element).size});
      AddSymbol(name + "[]", type.element, offset, inner);
      return;
    }
    case TypeKind::kRecord:
      for (const Member& member : unit_.records[type.record].members) {
        const std::string inner = member.name.empty() ? name : name + "." + member.name;
        if (!member.is_bit_field) AddSymbol(inner, member.type, offset + member.offset, indices);
        // A bit-field is one symbol for each bit, the lowest first: what several symbols name is one number. Others
        // have none.
        for (uint32_t i = 0; i < member.bit_width && !member.name.empty(); ++i) {
          const uint32_t bit = member.bit_offset + i;
          program_.symbols.push_back({.name = inner,
                                      .type = ir::Type::kBit,
                                      .space = memory_.data(),
                                      .offset = offset + member.offset + bit / 8,
                                      .bit = static_cast<uint8_t>(bit % 8),
                                      .indices = indices,
                                      .has_sign = TypeAt(member.type).is_signed});
        }
      }
      return;
    case TypeKind::kVoid:
    case TypeKind::kPointer:
    case TypeKind::kFunction:
      return;
  }
}

void Symbols::Add() {
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (!memory_.IsData(ObjectId(i))) continue;
    AddSymbol(object.name, unit_.variables[VariableId(object.index)].type, memory_.BeginOf(ObjectId(i)), {});
  }
}

/// Type, initial value and the comment of a variable.
std::string Symbols::MeaningOf(const Variable& variable) const {
  std::string text = TypeAt(variable.type).text;
  if (variable.initialised && variable.initial.size() == 1 && variable.initial.front().value.valid()) {
    const Expr& value = ExprAt(variable.initial.front().value);
    if (value.constant && IsInteger(TypeAt(value.type))) text += " = " + std::to_string(value.constant->integer);
  }
  const std::string comment = CommentOf(variable.range);
  return comment.empty() ? text : text + "; " + comment;
}

/// What is said of the name at `name`: behind it on its line, else directly above that line. In one line.
std::string Symbols::CommentOf(source::Range name) const {
  if (name.begin == 0) return {};  // of the product
  std::vector<source::Range> lines;
  if (const Comment* behind = CommentBehind(unit_, sources_, name.end)) {
    AddCommentLines(sources_.Text(behind->range), behind->range.begin, lines);
  } else {
    AddLinesAbove(name, lines);
  }
  std::string text;
  for (const source::Range& line : lines) {
    constexpr std::string_view kDecoration = " \t-=*";
    const std::string_view words = sources_.Text(line);
    const size_t first = words.find_first_not_of(kDecoration);
    if (first == std::string_view::npos) continue;
    if (!text.empty()) text += ' ';
    text += words.substr(first, words.find_last_not_of(kDecoration) + 1 - first);
  }
  return text;
}

/// Comments are about one name when nothing else is declared below them: they are short, no empty line follows, and
/// the line has no second name.
void Symbols::AddLinesAbove(source::Range name, std::vector<source::Range>& lines) const {
  constexpr size_t kMostLines = 3;
  const source::Position position = sources_.Locate(name.begin);
  const std::string_view line = sources_.Line(position.file, position.line);
  if (line.find(',') != std::string_view::npos) return;
  const source::File& file = sources_.Get(position.file);
  const auto indent = static_cast<source::Offset>(std::ranges::find_if_not(line, IsBlank) - line.begin());
  const std::vector<const Comment*> above =
      CommentsBefore(unit_, sources_, file.base + file.line_starts[position.line - 1] + indent);
  uint32_t next = position.line;
  size_t first = above.size();
  for (; first > 0 && sources_.Locate(above[first - 1]->range.end).line + 1 >= next; --first) {
    next = sources_.Locate(above[first - 1]->range.begin).line;
  }
  std::vector<source::Range> found;
  for (; first < above.size(); ++first) {
    AddCommentLines(sources_.Text(above[first]->range), above[first]->range.begin, found);
  }
  if (found.size() <= kMostLines) lines.insert(lines.end(), found.begin(), found.end());
}

void Symbols::Document() {
  std::map<std::pair<uint32_t, uint32_t>, ir::Documentation> cells;  // by space and byte
  std::map<std::string_view, source::Range> macros;                  // names that the program gives to cells
  for (const Macro& macro : unit_.macros) {
    if (!macro.is_system && !macro.has_parameters) macros.emplace(macro.name, macro.range);
  }
  for (const ir::Place& place : program_.places) {
    const bool memory = !place.is_field() && (memory_.IsOfArea(place.space) || place.space == memory_.data());
    if (!memory || place.address.empty()) continue;  // an indexed place has no address
    ir::Documentation& known = cells[{place.space.index, place.offset}];
    if (!known.address.empty()) continue;
    known.address = place.address;
    known.symbols = place.space == memory_.data() ? place.address : place.name;
    if (const auto macro = macros.find(place.name); place.space != memory_.data() && macro != macros.end())
      known.meaning = CommentOf(macro->second);
  }
  for (uint32_t i = 0; i < objects_.size(); ++i) {
    const Object& object = objects_[ObjectId(i)];
    if (!memory_.IsData(ObjectId(i))) continue;
    const Variable& variable = unit_.variables[VariableId(object.index)];
    ir::Documentation& known = cells[{memory_.data().index, memory_.BeginOf(ObjectId(i))}];
    if (known.address.empty()) known.address = object.name;
    known.symbols = object.name;
    known.meaning = MeaningOf(variable);
  }
  for (auto& [place, known] : cells) program_.documentation.push_back(std::move(known));
}

}  // namespace plcxx::hnc
