// plcxx diff: pairs of versions as a suspicious reviewer writes them, each with what the languages' rules say of it.
//
// A pair is a text in by_hand/<dialect>.pairs (how they are written stands at the head of each). What must be seen is
// expected in its own words, and was declared or run where it differs; of every pair, what is called equal is attacked
// by simulated runs of both versions.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tests/diff/both_simulated.h"
#include "tests/temporary_directory.h"
#include "tests/volume.h"
#include "transpiler/review/diff/diff.h"

namespace plcxx::review::diff {
namespace {

using Lines = std::vector<std::string>;

struct HandPair {
  std::string dialect, name;
  bool is_whole = false;                                      // as it is written: not inside of what all have
  std::vector<std::pair<std::string, std::string>> expected;  // the word, and of what
  std::vector<std::pair<std::string, std::string>> old_options, new_options;
  std::map<std::string, std::string> old_files, new_files;  // by name
};

/// The words of a line from the second on.
std::string RestOf(const std::string& line) {
  const size_t at = line.find(' ');
  return at == std::string::npos ? std::string() : line.substr(at + 1);
}

/// "\x8F" is that byte: a text of another encoding.
std::string WithBytes(std::string text) {
  for (size_t at = text.find("\\x"); at != std::string::npos; at = text.find("\\x", at + 1))
    text.replace(at, 4, 1, static_cast<char>(std::stoi(text.substr(at + 2, 2), nullptr, 16)));
  return text;
}

std::string Wrapped(const std::string& wrap, const std::string& text) {
  const size_t at = wrap.find("@\n");
  return at == std::string::npos ? text : wrap.substr(0, at) + text + wrap.substr(at + 2);
}

std::vector<HandPair> ReadPairs(const std::string& dialect, const std::string& extension) {
  std::ifstream in(std::string(PLCXX_ROOT) + "/tests/diff/by_hand/" + dialect + ".pairs", std::ios::binary);
  EXPECT_TRUE(in.is_open());
  std::vector<HandPair> pairs;
  std::string wrap, line;
  std::string* text = nullptr;
  const auto option_of = [](const std::string& words) {
    const size_t equals = words.find('=');
    return std::pair(words.substr(0, equals), words.substr(equals + 1));
  };
  const std::string program = "program" + extension;
  while (std::getline(in, line)) {
    const std::string word = line.substr(0, line.find(' ')), rest = RestOf(line);
    if (word == "##") continue;
    if (word == "wrap") {
      text = &wrap;
    } else if (word == "pair") {
      pairs.push_back({.dialect = dialect, .name = rest});
      text = nullptr;
    } else if (word == "equal" || word == "differs" || word == "open" || word == "spares" || word == "proves" ||
               word == "names") {
      pairs.back().expected.emplace_back(word, rest);
    } else if (word == "whole") {
      pairs.back().is_whole = true;
    } else if (word == "set" || word == "set-new") {
      if (word == "set") pairs.back().old_options.push_back(option_of(rest));
      pairs.back().new_options.push_back(option_of(rest));
    } else if (word == "old" || word == "new" || word == "both") {
      const std::string file = rest.empty() ? program : rest;
      text = &(word == "new" ? pairs.back().new_files : pairs.back().old_files)[file];
      if (word == "both") pairs.back().new_files[file] = "=";  // as the old one
    } else if (text != nullptr) {
      *text += WithBytes(line) + "\n";
    }
  }
  for (HandPair& pair : pairs) {
    for (auto& [file, content] : pair.new_files) {
      if (content == "=") content = pair.old_files[file];
    }
    if (pair.is_whole) continue;
    for (auto* const files : {&pair.old_files, &pair.new_files}) {
      const auto at = files->find(program);
      if (at != files->end()) at->second = Wrapped(wrap, at->second);
    }
  }
  return pairs;
}

class Side {
 public:
  Side(const std::string& label, const HandPair& pair, const std::map<std::string, std::string>& files,
       const std::vector<std::pair<std::string, std::string>>& options) {
    compilation::CompilationRequest request;
    request.dialect = pair.dialect;
    request.base_directory = directory_.path().string();
    request.options = options;
    for (const auto& [name, content] : files) {
      const std::string path = directory_.Write(name, content);
      // Headers, includes and lists of signals are named by sources or options.
      const std::string ending = std::filesystem::path(name).extension();
      if (ending != ".h" && ending != ".inc") request.sources.push_back(path);
    }
    // Symbols before what uses them.
    std::ranges::stable_partition(request.sources, [](const std::string& name) { return name.ends_with(".sym"); });
    side.emplace(MakeDiffSide(label, request));
  }
  std::optional<DiffSide> side;

 private:
  testing_support::TemporaryDirectory directory_;
};

std::string Told(const Diff& diff) {
  std::string text = std::to_string(diff.equal) + " equal";
  for (const DiffItem& item : diff.items) {
    text += "; " + item.name + (item.verdict == ItemVerdict::kDifferent ? " different" : " not decided " + item.reason);
    if (item.counterexample) text += " (" + item.counterexample->steps + ")";
  }
  for (const std::string& what : diff.not_looked_at) text += "; not looked at: " + what;
  return text;
}

bool IsShown(const DiffItem& item) {
  return item.verdict == ItemVerdict::kDifferent && (item.declared || item.counterexample);
}

/// `attack`: the runs that try what is called equal.
void Judge(const HandPair& pair, SimulatedRuns attack) {
  SCOPED_TRACE(pair.dialect + ": " + pair.name);
  Side old_side("old", pair, pair.old_files, pair.old_options), new_side("new", pair, pair.new_files, pair.new_options);
  ASSERT_TRUE(old_side.side->compilation.ok() && old_side.side->compilation.has_program) << "old does not compile";
  ASSERT_TRUE(new_side.side->compilation.ok() && new_side.side->compilation.has_program) << "new does not compile";
  DiffOptions options{.same = {}, .time_ms = 0, .scenario_directory = {}, .compiler = {}, .progress = {}};
  Diff diff;
  // All of the time is used where something stays open: much of it is given only where a verdict is missing.
  const auto lacks_verdict = [&diff](const auto& expected) {
    const auto at = std::ranges::find(diff.items, expected.second, &DiffItem::name);
    return (expected.first == "differs" && (at == diff.items.end() || !IsShown(*at))) ||
           (expected.first == "proves" && at != diff.items.end()) || (expected.first == "equal" && !diff.items.empty());
  };
  for (const uint64_t time_ms : {2'000, 10'000, 60'000}) {
    options.time_ms = time_ms;
    diff = CompareSides(*old_side.side, *new_side.side, options);
    if (std::ranges::none_of(pair.expected, lacks_verdict)) break;
  }
  ASSERT_EQ(diff.refusal, "");
  for (const auto& [word, name] : pair.expected) {
    const auto at = std::ranges::find(diff.items, name, &DiffItem::name);
    const bool is_listed = at != diff.items.end();
    const bool differs = is_listed && at->verdict == ItemVerdict::kDifferent;
    if (word == "equal") {
      EXPECT_TRUE(diff.items.empty()) << Told(diff);
    }
    if (word == "differs") {
      EXPECT_TRUE(is_listed && IsShown(*at)) << name << ": " << Told(diff);
    }
    if (word == "open") {
      EXPECT_TRUE(is_listed) << name << ": " << Told(diff);
    }
    if (word == "proves") {
      EXPECT_FALSE(is_listed) << name << ": " << Told(diff);
    }
    if (word == "spares") {
      EXPECT_FALSE(differs) << name << ": " << Told(diff);
    }
    if (word == "names") {
      const auto has = [&name](const std::string& what) { return what.find(name) != std::string::npos; };
      EXPECT_TRUE(std::ranges::any_of(diff.not_looked_at, has)) << name << ": " << Told(diff);
    }
  }
  const bool has_common_time = std::ranges::none_of(
      diff.items, [](const DiffItem& item) { return item.kind == ItemKind::kSchedule && item.declared.has_value(); });
  if (!has_common_time) return;
  terms::Random random(0x1B873593CC9E2D51);
  const std::optional<std::string> seen = SeenToDiffer(*old_side.side, *new_side.side, diff, options, attack, random);
  EXPECT_FALSE(seen.has_value()) << "called equal, but " << *seen << ": " << Told(diff);
}

/// One pair in `every`, the same ones everywhere.
void JudgeAll(const std::string& dialect, const std::string& extension, size_t every = 1) {
  const std::vector<HandPair> pairs = ReadPairs(dialect, extension);
  EXPECT_GE(pairs.size(), 12U);
  const SimulatedRuns attack{.runs = pairs.size() > 40 ? 3 : 8, .steps = pairs.size() > 40 ? 40 : 60};
  for (size_t i = 0; i < pairs.size(); i += every) {
    const HandPair& pair = pairs[i];
    const auto begin = std::chrono::steady_clock::now();
    Judge(pair, attack);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    if (seconds.count() > 4) std::cout << pair.name << ": " << seconds.count() << " s\n";
  }
}

// A part in each run, all in the heavy one.
TEST(ByHand, Nc110) { JudgeAll("nc110", ".plc", testing_support::Volume<size_t>(2, 1)); }
TEST(ByHand, Host50) { JudgeAll("host50", ".il", testing_support::Volume<size_t>(2, 1)); }
TEST(ByHand, Prostep) { JudgeAll("prostep", ".plc", testing_support::Volume<size_t>(2, 1)); }
TEST(ByHand, Technol) { JudgeAll("technol", ".plc", testing_support::Volume<size_t>(2, 1)); }
TEST(ByHand, Classicladder) { JudgeAll("classicladder", ".clp", testing_support::Volume<size_t>(2, 1)); }
// A State of thousands of cells takes its time.
TEST(ByHand, Hnc) { JudgeAll("hnc", ".cld", testing_support::Volume<size_t>(4, 1)); }

}  // namespace
}  // namespace plcxx::review::diff
