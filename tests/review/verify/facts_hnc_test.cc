// Facts that decisions rest on, in C: of every kind that its ranges decide.
#include "tests/review/verify/facts_bench.h"

namespace plcxx::driver {
namespace {

const FactsCase& Case() {
  static const FactsCase one = {
      "hnc",
      "a.cld",
      "#include \"plc.h\"\nint table[8], n, m;\nlong w;\nunsigned u;\n"
      "void init() { plc1_time = 16; plc2_time = 16; }\n"
      "void plc1() {\n    int k, d;\n    for (k = 0; k < 8; k++) table[k] = k;\n    n = k > 8;\n"
      "    d = (m & 7) + 1;\n    u = 100 / d;\n    w = d;\n    n = d >> 1;\n}\nvoid plc2() { }\n",
      {"COMPARISON", "DIVISION", "INDEX", "LOOP", "SHIFT", "SIGN", "VARIABLE"}};
  return one;
}

TEST(FactsHnc, HoldAndAreProved) { ExpectHold(Case()); }
TEST(FactsHnc, AFalseOneIsFound) { ExpectFalseOnesAreFound(Case()); }
TEST(FactsHnc, AreOnlyThereWhereTheyAreAskedFor) { ExpectOnlyWhereAskedFor(Case()); }

}  // namespace
}  // namespace plcxx::driver
