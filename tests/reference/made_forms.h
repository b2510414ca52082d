// Forms: each instruction of a dialect with each kind of operand in each place, each operator above each other one.
//
// What a dialect has follows from its machine tables (of nc110 from its grammar), what a program has from
// `print syntax`: there an operand is what it was resolved to, however it was written. Both in one notation, such as
// "ADDW 2 %TM.V" (host50), "MOV r16,WORD.[]" (technol), "FM AddLong 1 DW" (prostep), "and T.U" (nc110).
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>

namespace plcxx::reference {

using FormCounts = std::map<std::string, uint64_t>;

std::set<std::string> FormsOf(std::string_view dialect);
/// `syntax` is the text of `print syntax`. Counts what is no form of the dialect, too: it is not looked at.
void CountForms(std::string_view dialect, const std::string& syntax, FormCounts& counts);

}  // namespace plcxx::reference
