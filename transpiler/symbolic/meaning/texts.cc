// Texts of the operator: NC110 7.5.
#include <string_view>

#include "transpiler/symbolic/meaning/rows.h"

namespace plcxx::meaning {
namespace {

Bit Equals(const TextInboxValues& inbox, std::string_view text) {
  // What is longer than the inbox equals nothing.
  if (text.size() > inbox.text.size()) return inbox.pending.Bit(false);
  Value equal = inbox.length == text.size();
  for (size_t i = 0; i < text.size(); ++i) equal = equal & (inbox.text[i] == static_cast<unsigned char>(text[i]));
  return equal;
}

}  // namespace

void UpdateText(TextFlagValues& flag, const TextInboxValues& inbox, std::string_view text) {
  const Value none = flag.left.Same(0);
  const Value arrived = Select(Equals(inbox, text), flag.left.Same(2), none);
  flag.left = Select(inbox.pending, arrived, Select(flag.left == 0, none, flag.left - 1));
  flag.flag = flag.left != 0;
}

void ClearText(TextInboxValues& inbox) {
  inbox.pending = inbox.pending.Bit(false);
  inbox.length = inbox.length.Same(0);
}

}  // namespace plcxx::meaning
