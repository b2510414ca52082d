// What became of one scenario, as build servers list it.
#pragma once

#include <cstdint>
#include <string>

namespace plcxx::scenarios {

enum class TestOutcome : uint8_t { kPassed, kFailed, kUnusable };

struct TestCase {
  std::string name;   // "turret.yaml"
  std::string group;  // its directory
  TestOutcome outcome = TestOutcome::kPassed;
  std::string text;  // why it did not pass; its first line is the message
};

}  // namespace plcxx::scenarios
