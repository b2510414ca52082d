// Two versions of a program as texts, compared.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {

/// A dialect and how its files end.
struct Language {
  std::string dialect, extension;
};
inline const Language kTechnol{"technol", ".plc"}, kHost50{"host50", ".il"}, kNc110{"nc110", ".plc"},
    kClassicladder{"classicladder", ".clp"}, kProstep{"prostep", ".plc"}, kHnc{"hnc", ".cld"};

inline Diff ComparedTexts(const Language& language, const std::string& old_text, const std::string& new_text,
                          const DiffOptions& options = {}) {
  const testing_support::TemporaryDirectory directory;
  const auto side = [&](const std::string& name, const std::string& text) {
    compilation::CompilationRequest request;
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

/// The text with "@" replaced.
inline std::string With(std::string text, const std::string& part) {
  const size_t at = text.find('@');
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, 1, part);
}

inline std::string NamesIn(const Diff& diff) {
  std::string names;
  for (const DiffItem& item : diff.items) names += item.name + " ";
  return names;
}

inline const DiffItem* ItemNamed(const Diff& diff, const std::string& name) {
  const auto at = std::ranges::find(diff.items, name, &DiffItem::name);
  return at == diff.items.end() ? nullptr : &*at;
}

/// As ComparedTexts, of versions of which something may stay open beside the differences that are looked for: all of
/// the time would be used for that, so much of it is given only where a first comparison has not shown them.
inline Diff ComparedUntilShown(const Language& language, const std::string& old_text, const std::string& new_text,
                               const std::vector<std::string>& differences, uint64_t most_ms = 60'000) {
  Diff diff = ComparedTexts(language, old_text, new_text, {.time_ms = 4'000});
  const bool are_shown = std::ranges::all_of(differences, [&](const std::string& name) {
    const DiffItem* const item = ItemNamed(diff, name);
    return item != nullptr && item->verdict == ItemVerdict::kDifferent;
  });
  return are_shown ? diff : ComparedTexts(language, old_text, new_text, {.time_ms = most_ms});
}

}  // namespace plcxx::review::diff
