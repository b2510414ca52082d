// A program as it is compiled and proved, and changes of its generated code or of the runtime that must not be proved.
//
// In: sources, and a change of one place in one file. Out: by what it is caught. docs/verify.md has a row for each.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tests/temporary_directory.h"
#include "tests/volume.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/compile/runtime_files.h"
#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/emit/output_file.h"
#include "transpiler/emit/print/print.h"
#include "transpiler/prove/verify/bitcode.h"
#include "transpiler/prove/verify/verify.h"

namespace plcxx::prove {

struct Mutation {
  std::string_view name;
  std::string_view file;  // "turret.cpp", "plcxx/timers.h"
  std::string_view from;  // stands in it once
  std::string_view to;
};

/// A row of the table in docs/verify.md.
inline void ExpectInTable(std::string_view name, const std::string& caught) {
  static const std::string kDocument = [] {
    std::ifstream stream(PLCXX_ROOT "/docs/verify.md");
    return std::string(std::istreambuf_iterator<char>(stream), {});
  }();
  const std::string row = "| `" + std::string(name) + "` | " + (caught.empty() ? "proved" : caught) + " |";
  std::cout << row << "\n";
  EXPECT_NE(kDocument.find(row), std::string::npos) << "docs/verify.md lacks: " << row;
}

enum class Asked : uint8_t { kRoutines, kFunctions };

inline std::string FirstNotProved(const std::vector<verify::RoutineProof>& proofs, Asked asked) {
  for (const verify::RoutineProof& proof : proofs) {
    if (proof.exported != (asked == Asked::kRoutines) || proof.result == verify::ProofResult::kProved) continue;
    return proof.routine + ": " + (proof.differences.empty() ? proof.reason : proof.differences.front().what);
  }
  return "";
}

/// One program, as it is compiled and proved.
class Subject {
 public:
  Subject(const char* name, const char* text, const char* dialect,
          const std::vector<std::pair<std::string, std::string>>& options = {}, std::vector<std::string> routines = {})
      : routines_(std::move(routines)) {
    auto found = compile::FindToolchain(compile::Targets().front(), verify::kVerifyCompiler);
    EXPECT_TRUE(std::holds_alternative<compile::Toolchain>(found));
    toolchain_ = std::get<compile::Toolchain>(found);
    compilation::CompilationRequest request;
    request.sources = {directory_.Write(name, text)};
    request.dialect = dialect;
    request.options = options;
    compilation_ = compilation::Compile(request);
    EXPECT_TRUE(compilation_.ok());
    emittable_ = emit::legalize::Legalize(compilation_.program, {.name = "turret"});
    files_ = emit::print::PrintCpp(emittable_, *compilation_.sources);
    for (const compile::RuntimeFile& file : compile::RuntimeFiles())
      runtime_.push_back({.name = file.name, .text = std::string(file.text)});
  }

  /// By what it is caught: "slow: U.10", "not compiled"; empty: all is proved.
  std::string Caught(const std::vector<std::string>& flags = {}) {
    const verify::LoadedCode loaded = Compile(flags);
    if (loaded.code == nullptr) return loaded.reason;
    const std::vector<verify::RoutineProof> proofs = verify::Verify(emittable_, *loaded.code, Routines(), {});
    EXPECT_FALSE(proofs.empty());
    std::string caught = FirstNotProved(proofs, Asked::kRoutines);
    const bool by_functions = !routines_.empty() || caught.find("all is proved but") != std::string::npos;
    return by_functions ? FirstNotProved(proofs, Asked::kFunctions) : caught;
  }

  /// Of the code as it is, of all its routines and functions.
  std::vector<verify::RoutineProof> Proofs(const verify::VerifyLimits& limits) {
    const verify::LoadedCode loaded = Compile({});
    EXPECT_EQ(loaded.reason, "");
    return loaded.code == nullptr ? std::vector<verify::RoutineProof>()
                                  : verify::Verify(emittable_, *loaded.code, Routines(), limits);
  }

  /// The file's text, generated or of the runtime.
  std::string& TextOf(std::string_view name) {
    for (std::vector<emit::OutputFile>* all : {&files_, &runtime_}) {
      for (emit::OutputFile& file : *all) {
        if (file.name == name) return file.text;
      }
    }
    ADD_FAILURE() << "no file " << name;
    return files_.front().text;
  }

 private:
  verify::LoadedCode Compile(const std::vector<std::string>& flags) {
    std::vector<std::string> further = {"-Wno-everything"};
    further.insert(further.end(), flags.begin(), flags.end());
    auto compiled = verify::CompileToBitcode(
        {.toolchain = &toolchain_, .files = &files_, .further_flags = further, .runtime = runtime_});
    if (std::holds_alternative<verify::BitcodeFailure>(compiled)) return {.code = nullptr, .reason = "not compiled"};
    return verify::LoadCode(std::get<verify::Bitcode>(compiled).files);
  }

  /// Also one that the header does not declare.
  std::vector<ir::RoutineId> Routines() const {
    if (routines_.empty()) return verify::RoutinesToVerify(compilation_.program);
    std::vector<ir::RoutineId> routines;
    for (uint32_t i = 0; i < compilation_.program.routines.size(); ++i) {
      const ir::RoutineId id(i);
      if (std::ranges::find(routines_, compilation_.program.routines[id].name) != routines_.end())
        routines.push_back(id);
    }
    EXPECT_EQ(routines.size(), routines_.size());
    return routines;
  }

  testing_support::TemporaryDirectory directory_;
  std::vector<std::string> routines_;  // that are looked at; none: all
  compile::Toolchain toolchain_;
  compilation::Compilation compilation_;
  emit::Emittable emittable_;
  std::vector<emit::OutputFile> files_, runtime_;
};

enum class Outcome : uint8_t { kProved, kCaught };

/// With the change it is caught, or proved all the same; docs/verify.md says so.
inline void Expect(Outcome outcome, Subject& subject, const Mutation& mutation) {
  std::string& text = subject.TextOf(mutation.file);
  const std::string whole = text;
  const size_t at = text.find(mutation.from);
  ASSERT_NE(at, std::string::npos) << mutation.name;
  ASSERT_EQ(text.find(mutation.from, at + 1), std::string::npos) << mutation.name;
  text.replace(at, mutation.from.size(), mutation.to);
  const std::string caught = subject.Caught();
  EXPECT_EQ(caught.empty(), outcome == Outcome::kProved) << mutation.name << ": " << caught;
  // It differs, and a state shows it; "not within the time" would be too little.
  EXPECT_EQ(caught.find("not within"), std::string::npos) << mutation.name << ": " << caught;
  EXPECT_NE(caught, "not compiled") << mutation.name;
  ExpectInTable(mutation.name, caught);
  text = whole;
}

/// One in so many; all of them take minutes.
template <class Change>
std::vector<Change> SampleOf(std::vector<Change> all, size_t one_in) {
  const size_t step = testing_support::Volume(one_in, size_t{1});
  std::vector<Change> sample;
  for (size_t i = 0; i < all.size(); i += step) sample.push_back(all[i]);
  return sample;
}

inline void ExpectSampleCaught(Subject& subject, std::span<const Mutation> mutations) {
  for (const Mutation& mutation : SampleOf(std::vector<Mutation>(mutations.begin(), mutations.end()), 4))
    Expect(Outcome::kCaught, subject, mutation);
}

/// As it is it is proved; with any of the changes it is not.
inline void ExpectAllCaught(Subject& subject, std::span<const Mutation> mutations) {
  EXPECT_EQ(subject.Caught(), "");
  ExpectSampleCaught(subject, mutations);
}

}  // namespace plcxx::prove
