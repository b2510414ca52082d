#include "transpiler/dialects/prostep/lowering/documentation.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "transpiler/dialects/prostep/lowering/cells.h"
#include "transpiler/dialects/prostep/lowering/instances.h"
#include "transpiler/dialects/prostep/machine/signals.h"

namespace plcxx::prostep {

namespace {

struct Entry {
  std::tuple<uint32_t, uint32_t, uint32_t, uint32_t> order;  // space, byte, width, bit
  ir::Documentation documentation;
};

void AddWord(std::string& to, std::string_view word, std::string_view between) {
  if (word.empty()) return;
  if (!to.empty()) to += between;
  to += word;
}

}  // namespace

std::string Documentation::DeclaredComment(uint32_t address, uint32_t bytes) const {
  for (const DataDeclaration& declared : tree_.data) {
    if (declared.address != address || declared.bytes != bytes) continue;
    for (uint32_t i = 0; i < declared.comments.count; ++i) {
      const Comment& comment = tree_.comments[declared.comments.first + i];
      if (comment.place != CommentPlace::kTrailing) continue;
      std::string_view text = sources_.Text(comment.range);
      const size_t begin = text.find_first_not_of(" \t;*");
      return begin == std::string_view::npos ? "" : std::string(text.substr(begin));
    }
  }
  return {};
}

void Documentation::Add() {
  AddCells();
  AddInstances();
}

void Documentation::AddCells() {
  std::vector<Entry> entries;
  for (const auto& [key, id] : cells_.places()) {
    const ir::Place& place = program_.places[id];
    const auto space = static_cast<Space>(key >> 24);
    const uint32_t address = key >> 8 & 0xFFFF, bytes = ir::Bytes(place.type);
    const bool is_bit = place.type == ir::Type::kBit;
    const auto width = static_cast<uint8_t>(is_bit ? 1 : 8 * bytes);
    const uint8_t bit = is_bit ? place.bit : uint8_t{0};
    ir::Documentation row{.address = place.address, .symbols = {}, .predefined = {}, .meaning = {}, .help = {}};
    for (const Signal& signal : SignalsAt(space, address, bit, width)) {
      AddWord(row.predefined, signal.name, ", ");
      AddWord(row.meaning, signal.meaning, "; ");
    }
    if (row.meaning.empty() && space == Space::kD) row.meaning = DeclaredComment(address, bytes);
    entries.push_back({{static_cast<uint32_t>(space), address, width, bit}, std::move(row)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.order < b.order; });
  for (Entry& entry : entries) program_.documentation.push_back(std::move(entry.documentation));
}

void Documentation::AddInstances() {
  const auto add = [&](const auto& states, std::string_view letter) {
    for (uint32_t number = 0; number < states.size(); ++number) {
      if (!states[number].valid()) continue;
      program_.documentation.push_back({.address = std::string(letter) + " " + std::to_string(number),
                                        .symbols = {},
                                        .predefined = {},
                                        .meaning = {},
                                        .help = {}});
    }
  };
  add(instances_.timers(), "T");
  add(instances_.counters(), "C");
}

}  // namespace plcxx::prostep
