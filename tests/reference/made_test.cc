// Whatever a grammar, a table of options or a scenario offers, some random program has.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "tests/reference/made.h"

namespace plcxx::reference {
namespace {

class Made : public testing::TestWithParam<ReferenceDialect> {};

TEST_P(Made, HasEverything) {
  const std::string dialect(GetParam().name);
  const std::vector<NeverMade> never = ReadNeverMade();
  // What is rare needs more programs than what is common.
  std::vector<MadeRow> rows = CountMade(GetParam(), 1000);
  const auto is_excepted = [&](const MadeRow& row) {
    return std::ranges::any_of(never, [&](const NeverMade& known) {
      return known.dialect == dialect && known.group == row.group && known.name == row.name;
    });
  };
  if (std::ranges::any_of(rows, [&](const MadeRow& row) { return row.count == 0 && !is_excepted(row); })) {
    rows = CountMade(GetParam(), 3000);
  }
  for (const MadeRow& row : rows) {
    const bool excepted = is_excepted(row);
    std::printf("%-8s %-7s %-24s %8ju%s\n", dialect.c_str(), row.group.c_str(), row.name.c_str(), uintmax_t{row.count},
                excepted ? "  never made, with a reason" : "");
    EXPECT_NE(row.count != 0, excepted) << dialect << " " << row.group << " " << row.name
                                        << (excepted ? ": is made; its row in never_made.txt is wrong"
                                                     : ": no random program has it");
  }
}

TEST(NeverMade, EveryExceptionHasAReason) {
  for (const NeverMade& row : ReadNeverMade()) EXPECT_FALSE(row.reason.empty()) << row.dialect << " " << row.name;
}

INSTANTIATE_TEST_SUITE_P(Dialects, Made, testing::ValuesIn(ReferenceDialects().begin(), ReferenceDialects().end()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace plcxx::reference
