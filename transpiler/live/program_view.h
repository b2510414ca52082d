// The program as the page draws it: rows of source and ladder, fetched as they come into sight.
//
// In: the report's rows. Out: an outline with the height of each row, rows as JSON, and the values on which the power
// flow depends. All that the program's author wrote is text in it, never markup. Not its job: values (state_view.h).
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "transpiler/live/session.h"
#include "transpiler/report/rows.h"

namespace plcxx::live {

class ProgramView {
 public:
  /// The session outlives it.
  explicit ProgramView(const Session& session);

  /// What the page has to know once: names, signals, steps that there are, height of each row.
  nlohmann::ordered_json Outline() const;
  /// Rows [begin, end), as far as there are.
  nlohmann::ordered_json Rows(size_t begin, size_t end) const;
  size_t rows() const { return rows_.rows.size(); }
  /// The bits on which power flow depends, by their numbers in the rows.
  const std::vector<ir::ValueId>& power() const { return power_; }

 private:
  uint32_t PowerOf(ir::ValueId value);
  nlohmann::ordered_json Drawn(const std::vector<report::LadderItem>& items) const;

  const Session& session_;
  report::Rows rows_;
  std::vector<ir::ValueId> power_;
  std::vector<uint32_t> power_of_;  // by ValueId
};

}  // namespace plcxx::live
