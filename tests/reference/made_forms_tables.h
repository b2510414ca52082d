// The parts of made_forms.h, one pair a dialect.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/reference/made_forms.h"

namespace plcxx::reference::forms {

std::set<std::string> OfHost50();
void CountHost50(const std::string& line, FormCounts& counts);
std::set<std::string> OfNc110();
void CountNc110(const std::string& line, FormCounts& counts);
std::set<std::string> OfProstep();
void CountProstep(const std::string& line, FormCounts& counts);
std::set<std::string> OfTechnol();
void CountTechnol(const std::string& line, FormCounts& counts);

/// "a, b, c" -> its parts, without blanks around them; nothing inside brackets is cut.
std::vector<std::string> Parts(std::string_view text, char separator);

/// Of "(op x (op y z))" each operator with each kind of its operands: "op kind". A nested one is its operator.
/// Returns the kind of the whole.
using LeafKind = std::function<std::string(const std::string& leaf)>;
std::string CountPairs(const std::string& expression, const LeafKind& kind_of, FormCounts& counts);

}  // namespace plcxx::reference::forms
