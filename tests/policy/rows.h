// What a row of an instruction table costs: the sources of the dialect in which its enumerator is named.
//
// In: a table of tables and exceptions (rows.txt). Out: rows that are named in more than one source, where no exception
// allows it. A new mnemonic is its row and its lowering; what else has to know about it is a column of the row.
#pragma once

#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

Findings CheckRows(const std::string& root, const std::string& rows);

}  // namespace plcxx::policy
