// plcxx prove of one source and its properties, as a user runs it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {

/// `name` is of the source: its ending says the language.
inline Ran Prove(const Workplace& work, const std::string& name, std::string_view source, std::string_view properties,
                 const std::string& options = "") {
  work.Write(name, source);
  work.Write("m.prop", properties);
  return work.Run("prove " + name + " --property m.prop --counterexamples found --time 300s " + options);
}

/// The scenario of the first property fails in the simulator.
inline void ExpectShown(const Workplace& work) {
  const Ran again = work.Run("test --engine sim found/property-1.yaml");
  EXPECT_EQ(again.code, 1) << again;
  EXPECT_THAT(again.out, ::testing::HasSubstr("does not hold"));
}

}  // namespace plcxx::driver
