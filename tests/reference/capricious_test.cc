// That a capricious control does what an obliging one does not, and the same again from its seed.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reference/capricious_control.h"
#include "tests/reference/reference_dialects.h"
#include "tests/reference/runs.h"
#include "tests/temporary_directory.h"

namespace plcxx::reference {
namespace {

/// A request, which an obliging control leaves busy (TECHNOL 8.1).
RandomProgram Requesting() {
  RandomProgram program;
  program.files = {{"a.plc",
                    {{"  DATA\n  DATA_END\n  MODULE_INIT\n  FL 1,REQ_CLOSE_ALL\n  MODULE_INIT_END\n  MODULE_MAIN\n"
                      "  MODULE_MAIN_END\n  STOP",
                      {},
                      ""}}}};
  program.steps = {"run: {slow: 60}", "expect: {REQ_CLOSE_ALL: 0}"};
  return program;
}

/// A variable of the control, which an obliging one always has (PROSTEP 6.9).
RandomProgram Reading() {
  RandomProgram program;
  program.files = {{"a.plc",
                    {{":MOD PM 0\n:L\n: K 1\n:T FB 250\n:END PM 0\n:MOD PM 1\n:JU FM 41\n: K 1\n: K 2\n: DB 3\n"
                      ":L DB 4\n:JU FM 9\n: DB 3\n:T DB 4\n:END PM 1",
                      {},
                      ""}}}};
  program.steps = {"run: {slow: 40}", "expect: {DB4: 0}"};
  return program;
}

Outcome RunOf(RandomProgram program, std::string_view dialect, std::optional<uint64_t> caprices) {
  const testing_support::TemporaryDirectory directory;
  program.caprices = caprices;
  return RunRandom(program, *FindReference(dialect), directory.path().string()).outcome;
}

TEST(CapriciousControl, EndsRequests) {
  EXPECT_EQ(RunOf(Requesting(), "technol", std::nullopt), Outcome::kDisagrees);
  EXPECT_EQ(RunOf(Requesting(), "technol", 1), Outcome::kAgrees);
}

TEST(CapriciousControl, GivesOtherValues) {
  EXPECT_EQ(RunOf(Reading(), "prostep", std::nullopt), Outcome::kAgrees);
  EXPECT_EQ(RunOf(Reading(), "prostep", 1), Outcome::kDisagrees);
}

}  // namespace
}  // namespace plcxx::reference
