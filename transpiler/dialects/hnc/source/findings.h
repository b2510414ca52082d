// What is wrong with a program, collected where there is no diag::Engine yet: some of it does not count after all (text
// in a group that #if leaves out), and the parser's module has no engine of its own.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "transpiler/diagnostics/diagnostics.h"
#include "transpiler/source/source.h"

namespace plcxx::hnc {

/// Which phase found it: what is wrong with the text or the syntax hides what follows from it on the same line.
enum class Phase : uint8_t { kText, kSyntax, kMeaning };

struct Finding {
  Phase phase = Phase::kText;
  diag::Row row;
  source::Range range;
  std::vector<std::string> arguments;
  std::vector<diag::Note> notes;
  std::vector<diag::FixIt> fixits;
};

class Findings {
 public:
  template <class... Args>
  Finding& Report(source::Range range, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    Finding finding{.phase = phase_, .row = message.row, .range = range, .arguments = {}, .notes = {}, .fixits = {}};
    (finding.arguments.push_back(ToText(args)), ...);
    all_.push_back(std::move(finding));
    return all_.back();
  }
  /// Of what is reported from now on.
  void SetPhase(Phase phase) { phase_ = phase; }
  std::vector<Finding>& all() { return all_; }
  const std::vector<Finding>& all() const { return all_; }

 private:
  static std::string ToText(diag::Text text) { return std::string(text); }
  static std::string ToText(diag::Number number) { return std::to_string(number); }

  Phase phase_ = Phase::kText;
  std::vector<Finding> all_;
};

}  // namespace plcxx::hnc
