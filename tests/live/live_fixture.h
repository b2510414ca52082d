// A program of nc110 from text, in a session as `plcxx live` makes it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "transpiler/compilation/compilation.h"
#include "transpiler/live/session.h"
#include "transpiler/live/wishes.h"

namespace plcxx::live {

/// U4A8 is on from I0A3 to I0A4; W3K0 counts periods in the fast part; T5 is a timer of U4A8; T0 ... are kept.
inline constexpr const char* kLamp = R"(W3K0=[W3K0+1]
$
U4A8=I0A3*/I0A4+U4A8*/I0A4
U4A9=U4A8*/I0A5
W2K2=[W3K0]
)";

struct LiveBench {
  explicit LiveBench(const std::string& text = kLamp) {
    request.sources = {"lamp.plc"};
    request.texts = {{"lamp.plc", text}};
    request.dialect = "nc110";
    compilation = compilation::Compile(request);
    EXPECT_TRUE(compilation.ok());
    input.program = &compilation.program;
    input.sources = compilation.sources.get();
    input.files = compilation.files;
    session = std::make_unique<Session>(compilation, input);
  }

  uint64_t Value(const std::string& name) {
    return session->timeline().machine().Read(*compilation.dialect->locate(ir::NameIndex(compilation.program), name));
  }
  void Periods(int count) {
    for (int i = 0; i < count; ++i) EXPECT_EQ(session->Step(StepKind::kPeriod), "");
  }
  ir::StatementId Statement(const std::string& subject) const {
    for (uint32_t i = 0; i < compilation.program.statements.size(); ++i) {
      if (compilation.program.statements[ir::StatementId(i)].subject == subject) return ir::StatementId(i);
    }
    ADD_FAILURE() << subject;
    return {};
  }

  compilation::CompilationRequest request;
  compilation::Compilation compilation;
  report::ProgramInput input;
  std::unique_ptr<Session> session;
};

}  // namespace plcxx::live
