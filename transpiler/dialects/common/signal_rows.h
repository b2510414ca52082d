// The tables of predefined signals (signals.csv of a dialect): lines of comma separated values below a heading.
//
// Not its job: what the columns mean.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace plcxx::dialects {

/// The next field of a line, which is taken away. Quotes around it are removed; within them '""' is a quote.
std::string TakeField(std::string_view& line);

/// Calls `read(line)` for each line that is not empty, the first one left out.
template <class Read>
void ForEachSignalRow(std::string_view table, Read&& read) {
  bool is_heading = true;
  while (!table.empty()) {
    const std::string_view line = table.substr(0, table.find('\n'));
    table.remove_prefix(std::min(line.size() + 1, table.size()));
    if (!line.empty() && !is_heading) read(line);
    is_heading = false;
  }
}

}  // namespace plcxx::dialects
