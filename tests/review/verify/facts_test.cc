// Facts that decisions rest on, in every language (ir/facts.h): they hold, and verify shows it; one that does not hold
// fails whoever executes it with its statement, and verify lists it with a state.
#include "tests/review/verify/facts_bench.h"

namespace plcxx::driver {
namespace {

const std::vector<FactsCase>& Cases() {
  static const std::vector<FactsCase> cases = {
      {"nc110", "a.plc", "$\nC1I(10)=I0A3\n", {"RESULT"}},
      {"host50", "a.il", "SLOW\nNETWORK\nLDI %I0\nPOSA 3, %W0, 800\nEND_SLOW\n", {"RESULT"}},
      {"prostep",
       "a.plc",
       ":MOD PM 9\n:JU FM 15\n: DB 10\n: IB 100\n:T OB 4\n:A I 110.0\n:JC KON\n:= O 0.0\nKON :A I 20.1\n:= O 0.1\n"
       ":END PM 9\n"
       ":MOD PM 0\n:A I 20.1\n:S F 251.0\n:END PM 0\n",
       {"INDEX", "LOOP", "REGISTER"}},
      {"technol",
       "a.plc",
       "        DATA\nN: DFM A,B\nT: DS 300\n        DATA_END\n        MODULE_MAIN\n        MOV BH,0\n"
       "        MOV BL,BYTE.LABEL_MEM\n        MOV AL,T[BX]\n        LDR A\n        JL1 DAL\n        WR B\nDAL:\n"
       "        MODULE_MAIN_END\n        STOP\n",
       {"INDEX", "REGISTER"}},
  };
  return cases;
}

class FactsTest : public ::testing::TestWithParam<size_t> {
 protected:
  const FactsCase& one() const { return Cases()[GetParam()]; }
};

TEST_P(FactsTest, HoldAndAreProved) { ExpectHold(one()); }
TEST_P(FactsTest, AFalseOneIsFound) { ExpectFalseOnesAreFound(one()); }
TEST_P(FactsTest, AreOnlyThereWhereTheyAreAskedFor) { ExpectOnlyWhereAskedFor(one()); }

INSTANTIATE_TEST_SUITE_P(All, FactsTest, ::testing::Range(size_t{0}, Cases().size()),
                         [](const auto& index) { return std::string(Cases()[index.param].dialect); });

TEST(FactsOption, HasTwoValues) {
  const Workplace workplace;
  workplace.Write("a.plc", "$\nU4A0=I0A3\n");
  const Ran wrong = workplace.Run("print cpp a.plc --set facts=doubted");
  EXPECT_EQ(wrong.code, 2) << wrong;
  EXPECT_THAT(wrong.errors, ::testing::HasSubstr("expected trusted or checked"));
}

}  // namespace
}  // namespace plcxx::driver
