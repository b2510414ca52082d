// JUnit XML of a test run, as build servers read it. Same run, same bytes: no date, no duration.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace plcxx::driver {

enum class TestOutcome : uint8_t { kPassed, kFailed, kUnusable };

struct TestCase {
  std::string name;   // "turret.yaml"
  std::string group;  // its directory
  TestOutcome outcome = TestOutcome::kPassed;
  std::string text;  // why it did not pass; its first line is the message
};

std::string JunitXml(std::span<const TestCase> cases);

}  // namespace plcxx::driver
