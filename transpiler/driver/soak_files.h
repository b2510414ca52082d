// The folder of a soak: findings, runs worth keeping, the record and its page.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "transpiler/driver/output_files.h"
#include "transpiler/scenarios/known_runs.h"
#include "transpiler/soak/record.h"

namespace plcxx::driver {

/// The record of a soak, and the runs worth keeping, below the folder.
inline constexpr const char* kSoakRecord = "soak.json";
inline constexpr const char* kSoakPage = "coverage.html";
inline constexpr const char* kSoakCorpus = "corpus";

/// Where runs are kept.
std::string CorpusFolder(const std::string& directory);

/// Runs of earlier times, in the order of their files' names.
struct Corpus {
  std::vector<std::string> names;
  std::vector<soak::Stimuli> runs;
  std::set<std::string> unreadable;  // names of files that are no scenarios
};
/// Notes tell what cannot be read, and which words mean nothing to this program and are left out.
Corpus ReadCorpus(const std::string& directory, const compilation::Compilation& compilation);
std::vector<soak::Stimuli> StimuliOf(const std::vector<std::vector<scenarios::KnownStep>>& runs);

/// Can record, page and runs be written there, before the hours that they take? False: reported.
bool CanTakeSoak(const std::string& directory, const std::vector<std::string>& protected_paths);

/// Is there something of that name that no finding may replace?
bool IsTakenByOther(const std::string& directory, const std::string& name);

/// What a soak writes.
struct SoakOutput {
  std::vector<emit::OutputFile> files;  // paths below the folder, beside record and page
  std::vector<std::string> protected_paths;
  std::set<std::string> stays;  // runs of earlier times, by name, that do not disappear
};
/// Runs that are needed no more disappear. False: reported.
bool WriteSoak(const std::string& directory, const soak::Record& record, SoakOutput output);

/// `plcxx soak --merge`: folders of shards become one. Gives the exit code.
int MergeSoaks(const std::string& directory, const std::vector<std::string>& from, const std::string& form);

/// What is said at the end, and the exit code.
int TellSoak(const soak::Record& record, const std::string& directory, const std::string& form);

}  // namespace plcxx::driver
