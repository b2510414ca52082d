// What `plcxx print tokens` and `plcxx print syntax` print alike in every dialect.
#pragma once

#include <string>
#include <string_view>

#include "transpiler/source/source.h"

namespace plcxx::dialects {

/// "12:5", line and column.
std::string PlaceText(const source::SourceManager& sources, source::Offset offset);

/// One token a line: "12:5 kind text". Name(kind) is the dialect's.
template <class Tokens>
std::string TokenLines(const source::SourceManager& sources, const Tokens& tokens) {
  std::string text;
  for (const auto& token : tokens) {
    text += PlaceText(sources, token.range.begin) + " " + std::string(Name(token.kind)) + " " +
            std::string(sources.Text(token.range)) + "\n";
  }
  return text;
}

}  // namespace plcxx::dialects
