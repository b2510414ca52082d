#include "transpiler/dialects/nc110/lowering/texts.h"

#include <string>
#include <string_view>
#include <utility>

#include "transpiler/dialects/common/statement_ids.h"

namespace plcxx::nc110 {
namespace {

/// "START 1" -> "TEXT_START_1"; texts that differ only in what a name cannot hold are told apart by a hash.
std::string NameOfText(std::string_view text) {
  std::string name = "TEXT_";
  bool exact = true;
  dialects::TextHash hash;
  for (const char c : text) {
    hash.Add(c);
    const bool safe = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
    exact = exact && safe;
    name.push_back(safe ? c : '_');
  }
  if (exact) return name;
  return dialects::NameInStatement(name, hash.value());
}

}  // namespace

void Texts::Update() {
  for (uint32_t i = 0; i < flags_.size(); ++i) {
    if (!flags_[i].valid()) continue;
    const std::string_view text = sources_.Text(tree_.literals[LiteralId(i)].range);
    const ir::TextId id = program_.texts.Add(std::string(text));
    builder_.UpdateText(program_.places[flags_[i]].state, program_.text_inbox, id);
  }
  if (program_.text_inbox.valid()) builder_.Step(ir::OpKind::kClearText, program_.text_inbox, {});
}

ir::PlaceId Texts::FlagOf(LiteralId literal) {
  ir::PlaceId& flag = flags_[literal.index];
  if (flag.valid()) return flag;
  if (!program_.text_inbox.valid()) {
    program_.text_inbox = program_.states.Add({.kind = ir::StateKind::kTextInbox, .name = "operator_text"});
  }
  std::string name = NameOfText(sources_.Text(tree_.literals[literal].range));
  const ir::StateId state = program_.states.Add({.kind = ir::StateKind::kTextFlag, .name = name});
  ir::Place place{.name = std::move(name), .type = ir::Type::kBit, .state = state};
  place.field = ir::FieldIndex(ir::StateKind::kTextFlag, "flag");
  flag = program_.places.Add(std::move(place));
  return flag;
}

}  // namespace plcxx::nc110
