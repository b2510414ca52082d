// Programs of TECHNOL whose compiled code has to be followed through waits and decimal digits: proved.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/verify/run_verify.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;

std::string Verified(const std::string& program) { return Verify("magazine.plc", program, "--routine slow"); }

constexpr const char* kProved = "magazine: what was asked for is proved equal to the program";

/// The jump back is taken once at most: the second round waits where the first one did not, for the same input. No term
/// says so, neither of the program nor of the code; who knows it needs no invariant of the loop.
TEST(Waits, AJumpBackEndsAtTheNextWait) {
  EXPECT_THAT(Verified("          DATA\n"
                       "BITS:     DFM AT_POCKET,FORWARD,FAILED,,,,,\n"
                       "STEPS:    DS 2\n"
                       "POCKET:   DS 2\n"
                       "          DATA_END\n"
                       "          MODULE_MAIN\n"
                       "          MECH_BEGIN TURN\n"
                       "          FL   1,FORWARD\n"
                       "NEXT:     LDR  AT_POCKET\n"
                       "          TEX1 -,150,TOO_LATE\n"
                       "          LDR  AT_POCKET\n"
                       "          TEX0 -,150,TOO_LATE\n"
                       "          CALL MOVED\n"
                       "          LOD  STEPS\n"
                       "          SU   CNST.1\n"
                       "          STO  STEPS\n"
                       "          NE   CNST.0\n"
                       "          JL1  NEXT\n"
                       "          FL   0,FORWARD\n"
                       "          JUM  DONE\n"
                       "TOO_LATE: FL   0,FORWARD\n"
                       "          FL   1,FAILED\n"
                       "DONE:     MECH_END TURN\n"
                       "          MODULE_MAIN_END\n"
                       "MOVED:    LOD  POCKET\n"
                       "          AD   CNST.1\n"
                       "          GT   CNST.20\n"
                       "          JL0  KEEP\n"
                       "          LOD  CNST.1\n"
                       "KEEP:     STO  POCKET\n"
                       "          RET\n"
                       "          STOP\n"),
              HasSubstr(kProved));
}

/// Eight decimal digits, written as four bytes to where an index says: of four conditions on it one holds.
TEST(Decimals, EightDigitsAreWrittenAtAnIndex) {
  EXPECT_THAT(Verified("          DATA\n"
                       "TABLE:    DS 40\n"
                       "USED:     DS 4\n"
                       "LEFT:     DS 4\n"
                       "AT:       DS 2\n"
                       "          DATA_END\n"
                       "          MODULE_MAIN\n"
                       "          LOD  AT\n"
                       "          MOV  BX,CX\n"
                       "          LOD  LEFT\n"
                       "          BIN\n"
                       "          SU   USED\n"
                       "          BCD\n"
                       "          STO  DWRD.TABLE[BX]\n"
                       "          MODULE_MAIN_END\n"
                       "          STOP\n"),
              HasSubstr(kProved));
}

}  // namespace
}  // namespace plcxx::driver
