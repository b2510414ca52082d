// The folder of a soak: findings, runs worth keeping, the record and its page.
#pragma once

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

/// Runs of earlier times, by the names of their files.
std::vector<soak::Stimuli> ReadCorpus(const std::string& directory);
std::vector<soak::Stimuli> StimuliOf(const std::vector<std::vector<scenarios::KnownStep>>& runs);

/// Can the record be written there, and is a file of its name a record? False: reported.
bool CanTakeRecord(const std::string& directory);

/// Writes `files` (paths below the folder), record and page; runs that are needed no more disappear. False: reported.
bool WriteSoak(const std::string& directory, const soak::Record& record, std::vector<emit::OutputFile> files,
               std::vector<std::string> protected_paths);

/// `plcxx soak --merge`: folders of shards become one. Gives the exit code.
int MergeSoaks(const std::string& directory, const std::vector<std::string>& from, const std::string& form);

/// What is said at the end, and the exit code.
int TellSoak(const soak::Record& record, const std::string& directory, const std::string& form);

}  // namespace plcxx::driver
