#include "transpiler/dialects/host50/lowering/documentation.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "transpiler/dialects/host50/lowering/cells.h"
#include "transpiler/dialects/host50/lowering/names.h"
#include "transpiler/dialects/host50/machine/signals.h"

namespace plcxx::host50 {

void Documentation::Add() {
  std::vector<Address> used = cells_.used();
  for (const Symbol& symbol : tree_.symbols) used.push_back(symbol.address);
  const auto order = [](const Address& address) { return std::tuple(address.area, address.number, address.attribute); };
  std::ranges::sort(used, {}, order);
  const auto repeated = std::ranges::unique(used);
  used.erase(repeated.begin(), repeated.end());

  std::unordered_map<uint32_t, std::string_view> comments;
  for (const Symbol& symbol : tree_.symbols) comments.emplace(KeyOf(symbol.address), symbol.comment);
  for (const Address& address : used) {
    ir::Documentation entry{.address = NameOf(address), .symbols = {}, .predefined = {}, .meaning = {}, .help = {}};
    const std::string name = names_.Spelled(address);
    if (name != entry.address) entry.symbols = name;
    for (const Signal& signal : SignalsAt(address)) {
      entry.predefined += (entry.predefined.empty() ? "" : ", ") + signal.name;
      if (entry.meaning.empty()) entry.meaning = signal.meaning;
    }
    if (entry.predefined == entry.symbols) entry.predefined.clear();
    for (const Alarm& alarm : tree_.alarms) {
      if (address.area == Area::kQ && address.number == kFirstAlarm + alarm.index && !alarm.text.empty()) {
        entry.meaning = alarm.text;
      }
    }
    const auto comment = comments.find(KeyOf(WithoutAttribute(address)));
    if (comment != comments.end() && !comment->second.empty()) entry.meaning = comment->second;
    // What the code does not call by its symbol is explained by it.
    if (!entry.symbols.empty() && !IsAscii(entry.symbols)) {
      entry.meaning = entry.symbols + (entry.meaning.empty() ? "" : ": " + entry.meaning);
    }
    program_.documentation.push_back(std::move(entry));
  }
}

}  // namespace plcxx::host50
