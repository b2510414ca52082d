#include "transpiler/dialects/technol/lowering/documentation.h"

#include <map>
#include <utility>

#include "transpiler/dialects/technol/parser/names.h"
#include "transpiler/dialects/technol/syntax/raised_errors.h"

namespace plcxx::technol {

std::string Documentation::CommentOf(const Symbol& symbol) const {
  for (uint32_t i = 0; i < symbol.comments.count; ++i) {
    const Comment& comment = tree_.comments[symbol.comments.first + i];
    if (comment.place != CommentPlace::kTrailing) continue;
    std::string_view text = sources_.Text(comment.range);
    const size_t begin = text.find_first_not_of(" \t;*-=");
    return begin == std::string_view::npos ? "" : std::string(text.substr(begin));
  }
  // The comment of a byte with names for its bits is about each of them.
  if (symbol.kind == SymbolKind::kBit && symbol.byte.valid()) return CommentOf(tree_.symbols[symbol.byte]);
  return {};
}

void Documentation::Add() {
  AddSymbols();
  AddErrors();
}

void Documentation::AddSymbols() {
  for (const Symbol& symbol : tree_.symbols) {
    const bool named = symbol.origin == SymbolOrigin::kSource || symbol.uses > 0;
    std::string address = AddressOfSymbol(symbol);
    if (!named || address.empty()) continue;
    ir::Documentation row{
        .address = std::move(address), .symbols = symbol.name, .predefined = {}, .meaning = {}, .help = {}};
    if (symbol.origin == SymbolOrigin::kSource) {
      row.meaning = CommentOf(symbol);
    } else {
      row.predefined = symbol.name;
      row.meaning = symbol.meaning;
    }
    program_.documentation.push_back(std::move(row));
  }
}

void Documentation::AddErrors() {
  std::map<std::pair<uint32_t, uint32_t>, std::string> errors;
  for (const dialects::RaisedError& error : RaisedErrors(tree_)) {
    const source::Position place = sources_.Locate(error.range.begin);
    const std::string_view path = sources_.Get(place.file).path;
    std::string& places = errors[{error.main, error.sub}];
    places += (places.empty() ? "" : ", ") + std::string(path.substr(path.find_last_of("/\\") + 1)) + ":" +
              std::to_string(place.line);
  }
  for (const auto& [numbers, places] : errors) {
    program_.documentation.push_back(
        {.address = "ESET " + std::to_string(numbers.first) + "," + std::to_string(numbers.second),
         .symbols = {},
         .predefined = {},
         .meaning = places,
         .help = {}});
  }
}

}  // namespace plcxx::technol
