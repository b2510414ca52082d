// Elements of a rung as a project spells them, and a rung in one line for people.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace plcxx::classicladder {

struct ElementText {
  std::string_view type, joined, variable, index;  // "1", "0", "50/3", "200/9" or nothing
};
/// "1-0-50/3" or "1-0-50/3[200/9]".
std::optional<ElementText> SplitElement(std::string_view text);

/// Rows of elements, `1-0-30/2 , 9-0-0/0 , 50-0-60/1`, as "%X2.A (%Q1)": rows with `;` between them, wires and free
/// places left out, `+` where the row is joined with the one above it. A sequential page as "page 0". Lines that these
/// refer to: an expression as "%W3[%W9]>=5", a step as "S1: %X2, initial", a transition as "T1: S1, S2 -> S3", its
/// condition as "C1: %I1".
std::string StatementText(std::string_view source);

}  // namespace plcxx::classicladder
