// What `plcxx print tokens` and `plcxx print syntax` print alike in every dialect: one line for each token or node,
// with its place, indented as the tree is, and expressions in prefix form.
//
// In: the pieces of a line, and the operands of an expression, as the dialect spells them. Not its job: names.
#pragma once

#include <string>
#include <string_view>

#include "transpiler/source/source.h"
#include "transpiler/support/text_writer.h"

namespace plcxx::dialects {

/// "12:5", line and column.
std::string PlaceText(const source::SourceManager& sources, source::Offset offset);

/// One token a line: "12:5 kind text". Name(kind) is the dialect's; `text_of` gives what is written there, with its
/// blank in front, or nothing.
template <class Tokens, class TextOf>
std::string TokenLines(const source::SourceManager& sources, const Tokens& tokens, const TextOf& text_of) {
  std::string text;
  for (const auto& token : tokens) {
    text += PlaceText(sources, token.range.begin) + " " + std::string(Name(token.kind)) + text_of(token) + "\n";
  }
  return text;
}

template <class Tokens>
std::string TokenLines(const source::SourceManager& sources, const Tokens& tokens) {
  return TokenLines(sources, tokens,
                    [&sources](const auto& token) { return " " + std::string(sources.Text(token.range)); });
}

/// "(+ 1 (* 2 3))": an operation and its operands; none of those that are not valid.
template <class Operands, class TextOf>
std::string PrefixForm(std::string_view name, const Operands& operands, const TextOf& text_of) {
  std::string text = "(" + std::string(name);
  for (const auto& operand : operands) text += " " + text_of(operand);
  return text + ")";
}

/// The lines of a tree; a dialect's printer is one.
class SyntaxLines {
 protected:
  explicit SyntaxLines(const source::SourceManager& sources) : sources_(sources) {}

  /// "12:5 pieces", where the node begins.
  template <class... Pieces>
  void Node(source::Range range, const Pieces&... pieces) {
    writer_.Line(PlaceText(sources_, range.begin), " ", pieces...);
  }

  const source::SourceManager& sources_;
  support::TextWriter writer_;
};

}  // namespace plcxx::dialects
