#include "transpiler/ir/name_index.h"

#include <algorithm>
#include <functional>
#include <span>

#include "transpiler/ir/symbol_names.h"

namespace plcxx::ir {
namespace {

using Entry = std::pair<std::string_view, uint32_t>;

constexpr char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

struct WithoutCase {
  bool operator()(std::string_view a, std::string_view b) const {
    return std::ranges::lexicographical_compare(a, b, {}, Upper, Upper);
  }
};

template <class Less>
std::span<const Entry> Equal(const std::vector<Entry>& table, std::string_view name, Less less) {
  return std::ranges::equal_range(table, name, less, &Entry::first);
}

template <class Store, class Id>
auto Elements(std::span<const Entry> found, const Store& store) {
  std::vector<decltype(&store[Id(0)])> elements;
  elements.reserve(found.size());
  for (const auto& [name, number] : found) elements.push_back(&store[Id(number)]);
  return elements;
}

const Documentation* First(std::span<const Entry> found, const Program& program) {
  return found.empty() ? nullptr : &program.documentation[found.front().second];
}

}  // namespace

template <class Elements, class Element>
const std::vector<NameIndex::Entry>& NameIndex::Made(Table& table, Case which, const Elements& elements,
                                                     std::string Element::* name) {
  if (table) return *table;
  table.emplace();
  for (const Element& element : elements) table->emplace_back(element.*name, table->size());
  if (which == Case::kCounts) {
    std::ranges::sort(*table);
  } else {
    std::ranges::stable_sort(*table, WithoutCase(), &Entry::first);  // filled in the order of the numbers
  }
  return *table;
}

const Documentation* NameIndex::WithSymbols(std::string_view symbols) const {
  const auto& table = Made(symbols_, Case::kCounts, program_->documentation, &Documentation::symbols);
  return First(Equal(table, symbols, std::less<>()), *program_);
}

const Documentation* NameIndex::WithSymbolsOfAnyCase(std::string_view symbols) const {
  const auto& table = Made(folded_symbols_, Case::kAny, program_->documentation, &Documentation::symbols);
  return First(Equal(table, symbols, WithoutCase()), *program_);
}

const Documentation* NameIndex::WithSymbol(std::string_view symbol, size_t significant) const {
  if (!single_symbols_) {
    single_symbols_.emplace();
    for (uint32_t i = 0; i < program_->documentation.size(); ++i) {
      ForEachSymbolName(program_->documentation[i],
                        [&](std::string_view name) { single_symbols_->emplace_back(name, i); });
    }
    std::ranges::sort(*single_symbols_);
  }
  // The names that agree stand together, for they begin alike; which of their rows is the first, all of them say.
  symbol = symbol.substr(0, significant);
  const Documentation* first = nullptr;
  for (auto at = std::ranges::lower_bound(*single_symbols_, symbol, {}, &Entry::first); at != single_symbols_->end();
       ++at) {
    if (at->first.substr(0, significant) != symbol) break;
    const Documentation* const row = &program_->documentation[at->second];
    if (first == nullptr || row < first) first = row;
  }
  return first;
}

const Documentation* NameIndex::WithAddress(std::string_view address) const {
  const auto& table = Made(addresses_, Case::kCounts, program_->documentation, &Documentation::address);
  return First(Equal(table, address, std::less<>()), *program_);
}

StateId NameIndex::State(StateKind kind, std::string_view name) const {
  const auto& table = Made(states_, Case::kCounts, program_->states, &StateInstance::name);
  StateId last;
  for (const auto& [unused, number] : Equal(table, name, std::less<>())) {
    if (program_->states[StateId(number)].kind == kind) last = StateId(number);
  }
  return last;
}

std::vector<const Symbol*> NameIndex::Symbols(std::string_view name) const {
  const auto& table = Made(data_, Case::kCounts, program_->symbols, &Symbol::name);
  return Elements<std::vector<Symbol>, uint32_t>(Equal(table, name, std::less<>()), program_->symbols);
}

std::vector<const Place*> NameIndex::Places(std::string_view name) const {
  const auto& table = Made(places_, Case::kCounts, program_->places, &Place::name);
  return Elements<support::Store<PlaceId, Place>, PlaceId>(Equal(table, name, std::less<>()), program_->places);
}

std::vector<const Place*> NameIndex::PlacesOfAnyCase(std::string_view name) const {
  const auto& table = Made(folded_places_, Case::kAny, program_->places, &Place::name);
  return Elements<support::Store<PlaceId, Place>, PlaceId>(Equal(table, name, WithoutCase()), program_->places);
}

const Place* NameIndex::PlaceAt(std::string_view address) const {
  const auto& table = Made(places_at_, Case::kCounts, program_->places, &Place::address);
  const std::span<const Entry> found = Equal(table, address, std::less<>());
  return found.empty() ? nullptr : &program_->places[PlaceId(found.front().second)];
}

}  // namespace plcxx::ir
