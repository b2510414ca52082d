// Two programs of one file each, as `plcxx diff` compares them.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/temporary_directory.h"
#include "transpiler/driver/diff.h"

namespace plcxx::driver {

struct LanguageOfTexts {
  std::string dialect, extension;
};

inline Diff CompareTexts(const LanguageOfTexts& language, const std::string& old_text, const std::string& new_text,
                         const DiffOptions& options = {}) {
  const testing_support::TemporaryDirectory directory;
  const auto side = [&](const std::string& name, const std::string& text) {
    CompilationRequest request;
    request.sources = {directory.Write(name + language.extension, text)};
    request.dialect = language.dialect;
    return MakeDiffSide(name, request);
  };
  DiffSide old_side = side("old", old_text), new_side = side("new", new_text);
  EXPECT_TRUE(old_side.compilation.ok());
  EXPECT_TRUE(new_side.compilation.ok());
  Diff diff = CompareSides(old_side, new_side, options);
  EXPECT_EQ(diff.refusal, "");
  return diff;
}

}  // namespace plcxx::driver
