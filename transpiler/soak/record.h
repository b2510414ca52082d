// What a soak leaves behind: what was looked at, reached and found, in a form that is written, read and taken together.
//
// In: a soak, or records of several. Out: the record, as JSON and from it. It has all that a reader is shown, so that
// records are merged where the program is not there. Not its job: the runs themselves (files beside it).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "transpiler/soak/soak.h"

namespace plcxx::soak {

/// A statement with its goals, which follow each other in number.
struct StatementRecord {
  std::string file;
  uint32_t line = 0;
  std::string text;  // its first line
  std::vector<GoalKind> goals;
};

struct OutputRecord {
  std::string name;
  uint8_t width = 1;
  uint64_t ones = 0, zeros = 0;  // bits that were 1, bits that were 0

  bool moved() const { return (ones & zeros) != 0; }
};

struct MessageRecord {
  std::string text;
  MessageLife life;
};

struct FindingRecord {
  CauseKind kind{};
  uint32_t number = 0;                            // of a message
  std::string key, text, steps, file, not_shown;  // see Finding, Cause
};

struct Record {
  std::string program;
  std::string hash;  // of the program: goals of another one have other numbers
  uint64_t seed = 1;
  uint32_t machines = 0;
  std::set<std::string> shards;  // "1/2"; none: it was the whole
  /// What each soak in it was, in words that are the same where the same machines did the same: see WorkWords.
  std::set<std::string> works;
  uint64_t machine_ms = 0, parts = 0, steps = 0;
  uint64_t wide_parts = 0;  // of the parts: in a fleet
  bool out_of_time = false;
  bool was_asked_to_end = false;
  std::string plant;  // the file that moves the machine; empty: none does
  size_t inputs = 0, nameless = 0, driven = 0, nameless_outputs = 0;
  size_t properties = 0;
  std::vector<StatementRecord> statements;
  GoalSet reached;
  std::map<std::string, GoalSet> corpus;  // by the file's name
  std::vector<OutputRecord> outputs;
  std::map<uint32_t, MessageRecord> messages;
  std::vector<FindingRecord> findings;
  std::set<std::string> more;  // causes of further findings
  std::vector<std::string> not_repeated;

  size_t GoalCount() const;
};

/// The name of a run that is kept, from what it does.
std::string CorpusName(const Stimuli& stimuli);

/// But for what the command line says: shards, machines, seed.
Record MakeRecord(const scenarios::ProveMachine& machine, const Soaked& soaked, const Goals& goals,
                  const Inputs& inputs, const WatchPlan& plan);

/// What decides which inputs chance chooses, but for the program and the plant: two soaks of the same words did the
/// same, as far as the shorter one went. The record has seed, machines and shards.
std::string WorkWords(const Record& record, const SoakRequest& request, const WatchPlan& plan);

std::string ToJson(const Record& record);
/// What is wrong with a record that another version wrote.
inline constexpr std::string_view kOfAnotherVersion = "it is of another version of plcxx";
/// Or what is wrong with it: lower case, no full stop.
std::variant<Record, std::string> ReadRecord(const std::string& json);

/// What `other` has is added. Not empty: why it cannot be. Runs and findings that have become redundant are taken out.
std::string AddRecord(Record& record, const Record& other);

struct Count {
  size_t reached = 0, all = 0;
};
/// Of conditions those that were seen both ways.
Count CountOf(const Record& record, GoalKind kind);

}  // namespace plcxx::soak
