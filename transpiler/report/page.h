// The report as one self-contained HTML page: no network, no external script, no date, no path, no version.
//
// In: one program, or two versions of it and what is known about their difference. Out: the page as UTF-8 text, the
// same for the same input. Not its job: deciding what differs (prove/ does), reading or writing files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "transpiler/report/program_input.h"

namespace plcxx::report {

/// What is known about one place of two versions.
enum class Verdict : uint8_t {
  kDifferent,   // behaves differently; `text` and `counterexample` say when
  kNotDecided,  // neither proved nor refuted; `text` says why
  kEqual        // proved equal
};

/// One place (or instance) whose behaviour was compared.
struct Finding {
  std::string place;  // as the source names it, "U4A8"
  std::string kind;   // "output", "internal", "retentive": shown as it is
  Verdict verdict = Verdict::kNotDecided;
  std::vector<ir::StatementId> old_statements, new_statements;  // that cause it, on each side
  std::string text;            // one sentence or more: how it was found out, or why not
  std::string counterexample;  // a scenario as text; empty: none
};

/// What changed from an old version of a program to the one that the page shows.
struct Review {
  ProgramInput old_program;
  std::vector<Finding> findings;  // shown in this order: outputs first is the caller's choice
  std::string summary;            // the verdict in one sentence; empty: the counts are told
  std::string changes;            // the changed statements as lines of a patch; empty: the first finding shows them
  uint32_t equal = 0;             // places proved equal that are not among the findings
};

std::string Page(const ProgramInput& program);
/// The page of `program`, the new version, with the old one and what changed its behaviour.
std::string Page(const ProgramInput& program, const Review& review);

}  // namespace plcxx::report
