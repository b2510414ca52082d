// Messages about a statement: the first fault alone is reported, and hides what is no fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "transpiler/dialects/common/fault_reporter.h"

namespace plcxx::dialects {
namespace {

class Statements : private FaultReporter {
 public:
  Statements() : FaultReporter(engine_, failed_, &faulty_) {}

  using FaultReporter::Fault;
  using FaultReporter::Report;
  using FaultReporter::Warn;

  void Begin() { failed_ = false; }
  bool failed() const { return failed_; }
  bool faulty() const { return faulty_; }
  const diag::Engine& engine() const { return engine_; }

 private:
  diag::Engine engine_;
  bool failed_ = false, faulty_ = false;
};

TEST(CommonFaultReporter, OneFaultForEachStatement) {
  Statements statements;
  statements.Fault({1, 2}, diag::Nc110NoStatements);
  statements.Fault({2, 3}, diag::Nc110TooDeep).notes.push_back({{1, 2}, "of a fault that is not reported"});
  EXPECT_TRUE(statements.failed());
  statements.Begin();
  EXPECT_TRUE(statements.Fault({3, 4}, diag::Nc110TooDeep).notes.empty());
  ASSERT_EQ(statements.engine().all().size(), 2U);
  EXPECT_EQ(statements.engine().all()[0].range, (source::Range{1, 2}));
  EXPECT_EQ(statements.engine().all()[1].range, (source::Range{3, 4}));
}

TEST(CommonFaultReporter, AFaultHidesWarningsOfItsStatement) {
  Statements statements;
  statements.Warn({1, 2}, diag::Nc110SecondCycleMark);
  EXPECT_FALSE(statements.failed());
  EXPECT_FALSE(statements.faulty());
  statements.Fault({2, 3}, diag::Nc110TooDeep);
  statements.Warn({3, 4}, diag::Nc110SecondCycleMark);
  EXPECT_EQ(statements.engine().all().size(), 2U);
  EXPECT_TRUE(statements.faulty());
}

TEST(CommonFaultReporter, WhatIsOfNoStatementIsReportedBesideAFault) {
  Statements statements;
  statements.Report({1, 2}, diag::Nc110TooDeep);
  EXPECT_FALSE(statements.failed());
  EXPECT_TRUE(statements.faulty());
  statements.Fault({2, 3}, diag::Nc110TooDeep);
  statements.Report({3, 4}, diag::Nc110TooDeep);
  EXPECT_EQ(statements.engine().all().size(), 3U);
}

}  // namespace
}  // namespace plcxx::dialects
