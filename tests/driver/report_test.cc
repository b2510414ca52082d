// plcxx report: tables by name, by address, by statement.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

struct Table {
  Table() {
    work.Write("names.sym", "*\nZERO=U4A0\nDELAY=T5I\nADONE=T5U\nUNUSED=W27K0\n");
    work.Write("main.plc", "$\n!DELAY(30)=I0A0*/!ZERO\n!ZERO=!ADONE+I0A1*/!ADONE\n");
  }
  Workplace work;
};

// covers: NC110-044
TEST(Report, SymbolsByNameWithReadsAndWrites) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --print-symbols");
  EXPECT_EQ(result.code, 0);
  EXPECT_EQ(result.out,
            "symbol            operand   reads  writes\n"
            "ADONE             T5U       2      0\n"
            "DELAY             T5I       0      1\n"
            "UNUSED            W27K0     0      0\n"
            "ZERO              U4A0      1      1\n");
}

// covers: NC110-227
TEST(Report, CrossReferenceNamesFilesAndLines) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --cross-reference");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("U4A0  ZERO"));
  EXPECT_THAT(result.out, HasSubstr("  written: main.plc:3\n  read:    main.plc:2\n"));
}

TEST(Report, CostsOfTheStatements) {
  const Table table;
  const auto result = table.work.Run("report names.sym main.plc --cost-listing");
  EXPECT_EQ(result.code, 0);
  EXPECT_THAT(result.out, HasSubstr("main.plc:2  !DELAY(30)=I0A0*/!ZERO\n"));
}

TEST(Report, NeedsATable) {
  const Table table;
  EXPECT_EQ(table.work.Run("report names.sym main.plc").code, 2);
}

}  // namespace
}  // namespace plcxx::driver
