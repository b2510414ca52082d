#include "transpiler/lsp/names.h"

#include <algorithm>

#include "transpiler/source/unsaved.h"

namespace plcxx::lsp {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

bool Contains(source::Range range, source::Offset at) { return range.begin <= at && at < range.end; }
bool IsEmpty(source::Range range) { return range.begin == range.end; }

bool MayName(TokenRole role) {
  switch (role) {
    case TokenRole::kName:
    case TokenRole::kMember:
    case TokenRole::kAddress:
    case TokenRole::kFunction:
      return true;
    case TokenRole::kComment:
    case TokenRole::kKeyword:
    case TokenRole::kMnemonic:
    case TokenRole::kNumber:
    case TokenRole::kText:
    case TokenRole::kOperator:
      return false;
  }
  return false;
}

}  // namespace

Bits BitsOf(const ir::Place& place) {
  if (place.is_field()) return {Bits::Of::kInstance, place.state.index, place.field, place.field + uint64_t{1}};
  const uint64_t first = uint64_t{place.offset} * 8 + (place.bit == ir::kNoBit ? 0 : place.bit);
  const uint64_t count = place.type == ir::Type::kBit ? 1 : uint64_t{ir::Bytes(place.type)} * 8;
  return {Bits::Of::kSpace, place.space.index, first, first + count};
}

bool Overlap(const Bits& a, const Bits& b) {
  return a.of == b.of && a.number == b.number && a.first < b.last && b.first < a.last;
}

Names::Names(Analysis& analysis, const Analysis& meaning)
    : analysis_(analysis), meaning_(meaning), editing_(dialects::EditingOf(*analysis.compilation().dialect)) {
  const uint32_t files = analysis_.sources().size();
  ReadDefinitions();
  diag::Engine unused;
  dialects::Request request = analysis_.MakeRequest();
  request.diagnostics = &unused;
  for (uint32_t i = 0; i < files; ++i) tokens_.push_back(editing_.tokens(request, source::FileId(i)));
  for (uint32_t i = 0; i < definitions_.size(); ++i) by_key_[editing_.key(definitions_[i].name)].push_back(i);
}

/// The dialect reads the files that sources include again: what it found there has its place in the first copy.
source::Range Names::InFirstCopy(source::Range range) const {
  const source::FileId file = analysis_.sources().FileAt(range.begin);
  if (!file.valid() || range.begin == 0) return {};
  const source::File& copy = analysis_.sources().Get(file);
  for (uint32_t i = 0; i < file.index; ++i) {
    const source::File& first = analysis_.sources().Get(source::FileId(i));
    if (first.path != copy.path || first.text.size() != copy.text.size()) continue;
    return {range.begin - copy.base + first.base, range.end - copy.base + first.base};
  }
  return range;
}

void Names::ReadDefinitions() {
  const source::UnsavedScope scope(analysis_.unsaved());
  diag::Engine unused;
  dialects::Request request = analysis_.MakeRequest();
  request.diagnostics = &unused;
  request.kept = analysis_.kept();
  definitions_ = editing_.definitions(request);
  for (Definition& definition : definitions_) {
    definition.name_range = InFirstCopy(definition.name_range);
    definition.range = InFirstCopy(definition.range);
    if (!IsEmpty(definition.scope)) definition.scope = InFirstCopy(definition.scope);
  }
}

const EditorToken* Names::TokenAt(source::FileId file, source::Offset at) const {
  const std::vector<EditorToken>& tokens = TokensOf(file);
  const auto next =
      std::ranges::upper_bound(tokens, at, {}, [](const EditorToken& token) { return token.range.begin; });
  if (next == tokens.begin()) return nullptr;
  const EditorToken& token = *std::prev(next);
  if (at < token.range.end) {
    // Between "(" and a word the word is meant; between a word and ")" the word, too.
    if (MayName(token.role) || at != token.range.begin || std::prev(next) == tokens.begin()) return &token;
    const EditorToken& before = *std::prev(next, 2);
    return before.range.end == at && MayName(before.role) ? &before : &token;
  }
  return at == token.range.end ? &token : nullptr;
}

std::string_view Names::TextOf(const EditorToken& token) const { return analysis_.sources().Text(token.range); }

source::Range Names::NamePartOf(const EditorToken& token) const {
  return editing_.name_part(token.range, TextOf(token));
}

bool Names::IsVisible(const Definition& definition, source::Offset at) const {
  return IsEmpty(definition.scope) || Contains(definition.scope, at);
}

uint32_t Names::DefinitionOf(const EditorToken& token) const {
  const auto found = by_key_.find(editing_.key(TextOf(token)));
  if (found == by_key_.end()) return kNoDefinition;
  uint32_t best = kNoDefinition;
  bool best_is_field = false;
  source::Offset best_size = 0;
  for (const uint32_t index : found->second) {
    const Definition& definition = definitions_[index];
    if (definition.kind == DefinitionKind::kBlock) continue;
    if (definition.name_range == NamePartOf(token) || definition.name_range == token.range) return index;
    const bool is_field = definition.kind == DefinitionKind::kField;
    if (!IsVisible(definition, token.range.begin) || (token.role == TokenRole::kMember && !is_field)) continue;
    const source::Offset size =
        IsEmpty(definition.scope) ? ~source::Offset{0} : definition.scope.end - definition.scope.begin;
    const bool is_better =
        best == kNoDefinition || (best_is_field && !is_field) || (best_is_field == is_field && size < best_size);
    if (!is_better) continue;
    best = index;
    best_is_field = is_field;
    best_size = size;
  }
  return best;
}

std::optional<dialects::Location> Names::Locate(std::string_view text) const {
  if (text.empty() || program().spaces.empty()) return std::nullopt;
  return meaning_.compilation().dialect->locate(index_, text);
}

std::optional<Bits> Names::BitsOfText(std::string_view text) const {
  const auto [known, is_new] = bits_.try_emplace(std::string(text));
  if (!is_new) return known->second;
  const auto location = Locate(text);
  if (!location || location->text_input || location->absent) return std::nullopt;
  if (location->cell) {
    known->second = Bits{Bits::Of::kCell, *location->cell, 0, 1};
  } else {
    known->second = BitsOf(location->place);
  }
  return known->second;
}

Target Names::TargetOf(const EditorToken& token) const {
  if (!MayName(token.role)) return {};
  Target target;
  target.definition = DefinitionOf(token);
  if (target.definition == kNoDefinition) {
    if (token.role != TokenRole::kMember) target.bits = BitsOfText(TextOf(token));
  } else if (!definitions_[target.definition].address.empty()) {
    target.bits = BitsOfText(definitions_[target.definition].address);
  }
  return target;
}

std::vector<source::Range> Names::MentionsOf(const Target& target) const {
  std::vector<source::Range> mentions;
  for (const std::vector<EditorToken>& tokens : tokens_) {
    for (const EditorToken& token : tokens) {
      if (!MayName(token.role)) continue;
      const Target other = TargetOf(token);
      const bool same_name = target.definition != kNoDefinition && other.definition == target.definition;
      if (same_name || (target.bits && other.bits == target.bits)) mentions.push_back(NamePartOf(token));
    }
  }
  return mentions;
}

uint32_t Names::RoutineAt(source::Offset at) const {
  uint32_t best = kNoDefinition;
  for (uint32_t i = 0; i < definitions_.size(); ++i) {
    const Definition& definition = definitions_[i];
    if (definition.kind != DefinitionKind::kRoutine || !Contains(definition.range, at)) continue;
    const auto size = [&](uint32_t index) { return definitions_[index].range.end - definitions_[index].range.begin; };
    if (best == kNoDefinition || size(i) < size(best)) best = i;
  }
  return best;
}

}  // namespace plcxx::lsp
