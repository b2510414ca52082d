// Messages of a parser about the statement that it reads: what follows from its first fault is not reported again.
#pragma once

#include <type_traits>
#include <utility>

#include "transpiler/diagnostics/diagnostics.h"

namespace plcxx::dialects {

/// A base of what reads statements. Refers to its arguments.
class FaultReporter {
 protected:
  /// `failed`: a fault of the statement is reported; the parser clears it where a statement begins. `faulty`: what
  /// every fault makes faulty as a whole, if there is something.
  FaultReporter(diag::Engine& diagnostics, bool& failed, bool* faulty = nullptr)
      : diagnostics_(diagnostics), failed_(failed), faulty_(faulty) {}

  /// What is wrong with the statement; kept if it is the first one.
  template <class... Args>
  diag::Diagnostic& Fault(source::Range range, const diag::Message<Args...>& message,
                          std::type_identity_t<Args>... args) {
    if (faulty_ != nullptr) *faulty_ = true;
    if (std::exchange(failed_, true)) return unreported_ = {};
    return diagnostics_.Report(range, message, args...);
  }
  /// A fault that does not follow from one of the statement.
  template <class... Args>
  diag::Diagnostic& Report(source::Range range, const diag::Message<Args...>& message,
                           std::type_identity_t<Args>... args) {
    if (faulty_ != nullptr) *faulty_ = true;
    return diagnostics_.Report(range, message, args...);
  }
  /// What is no fault, unless the statement has one.
  template <class... Args>
  void Warn(source::Range range, const diag::Message<Args...>& message, std::type_identity_t<Args>... args) {
    if (!failed_) diagnostics_.Report(range, message, args...);
  }

  diag::Engine& diagnostics_;

 private:
  bool& failed_;
  bool* faulty_;
  diag::Diagnostic unreported_;  // takes the notes of faults that are not reported
};

}  // namespace plcxx::dialects
