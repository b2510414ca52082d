// What a program calls its places and instances, found without going through the program each time: a report asks for
// every documented name, a comparison for every cell.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "transpiler/ir/program.h"

namespace plcxx::ir {

/// Of a program that lives longer, and is not changed meanwhile. Each table is made when it is first asked, so that one
/// question costs one table; who has many keeps the index. One thread at a time.
class NameIndex {
 public:
  explicit NameIndex(const Program& program) : program_(&program) {}

  const Program& program() const { return *program_; }
  /// The first row of the documentation with these symbols, all of them; none: nullptr.
  const Documentation* WithSymbols(std::string_view symbols) const;
  const Documentation* WithSymbolsOfAnyCase(std::string_view symbols) const;
  /// The first row one of whose symbols has the same first characters, of which so many count.
  const Documentation* WithSymbol(std::string_view symbol, size_t significant) const;
  const Documentation* WithAddress(std::string_view address) const;
  /// The last instance of the kind with this name.
  StateId State(StateKind kind, std::string_view name) const;
  /// All with the name, in their order.
  std::vector<const Symbol*> Symbols(std::string_view name) const;
  std::vector<const Place*> Places(std::string_view name) const;
  std::vector<const Place*> PlacesOfAnyCase(std::string_view name) const;
  /// The first place with this address; none: nullptr.
  const Place* PlaceAt(std::string_view address) const;

 private:
  using Entry = std::pair<std::string_view, uint32_t>;  // a name, and the number of what has it
  enum class Case : uint8_t { kCounts, kAny };
  /// Ascending by name, those of one name by number.
  using Table = std::optional<std::vector<Entry>>;

  template <class Elements, class Element>
  static const std::vector<Entry>& Made(Table& table, Case which, const Elements& elements,
                                        std::string Element::* name);

  const Program* program_;
  mutable Table symbols_, folded_symbols_, single_symbols_, addresses_, states_, data_, places_, folded_places_,
      places_at_;
};

}  // namespace plcxx::ir
