#include "transpiler/passes/enter_switches.h"

#include <gtest/gtest.h>

#include "tests/passes/passes_testing.h"
#include "transpiler/passes/structure.h"

namespace plcxx::passes {
namespace {

std::string Entered(std::string_view body) {
  ir::Program program = ReadFast(body);
  EXPECT_TRUE(ir::Verify(program, ir::Stage::kLowered).empty());
  Structure(program);
  EnterSwitches(program);
  return Body(program);
}

TEST(EnterSwitches, WaitsAreCasesThatRunOn) {
  EXPECT_EQ(Entered(R"(%0 = load slice
switch %0 {
  case 1 {
    jump L1
  }
  case 2 {
    jump L2
  }
  default {
  }
}
stmt s1
%0 = load a
store b %0
label L1
stmt s2
%0 = load c
jump L9 if %0
label L2
stmt s3
%0 = load b
store c %0
label L9
)"),
            R"(%0 = load slice
block @1 {
  switch %0 {
    default falls_through {
      stmt s1
      %0 = load a
      store b %0
    }
    case 1 falls_through {
      stmt s2
      %0 = load c
      exit @1 if %0
    }
    case 2 {
      stmt s3
      %0 = load b
      store c %0
    }
  }
}
)");
}

TEST(EnterSwitches, ABlockThatOthersLeaveStaysAndSoDoItsCases) {
  EXPECT_EQ(Entered(R"(%0 = load slice
switch %0 {
  case 1 {
    jump L1
  }
  case 2 {
    jump L2
  }
  default {
  }
}
stmt s1
%0 = load a
jump L2 if %0
label L1
stmt s2
%0 = load c
store b %0
label L2
stmt s3
)"),
            R"(%0 = load slice
block @1 {
  switch %0 {
    default falls_through {
      stmt s1
      %0 = load a
      exit @1 if %0
    }
    case 1 {
      stmt s2
      %0 = load c
      store b %0
    }
    case 2 {
      exit @1
    }
  }
}
stmt s3
)");
}

constexpr std::string_view kBehindAStatement = R"(stmt s0
%0 = load slice
switch %0 {
  case 1 {
    jump L1
  }
}
stmt s1
label L1
stmt s2
)";

TEST(EnterSwitches, OneOfAStatementStays) {
  ir::Program program = ReadFast(kBehindAStatement);
  Structure(program);
  const std::string before = Body(program);
  EnterSwitches(program);
  EXPECT_EQ(Body(program), before);
}

}  // namespace
}  // namespace plcxx::passes
