// Diagnostics of several programs as one document: what reads JSON or SARIF reads one value.
//
// While an object lives, PrintDiagnostics and PrintDiagnosticsBeside keep their documents; at its end they are written,
// one for each stream: an array with the messages of all, or one run with the results of all.
#pragma once

#include <string>
#include <vector>

namespace plcxx::driver {

class DiagnosticsDocuments {
 public:
  DiagnosticsDocuments();
  DiagnosticsDocuments(const DiagnosticsDocuments&) = delete;
  DiagnosticsDocuments& operator=(const DiagnosticsDocuments&) = delete;
  ~DiagnosticsDocuments();
};

/// Several JSON documents of diagnostics, or several SARIF logs of one run each, as one.
std::string MergedDiagnostics(const std::vector<std::string>& documents);

}  // namespace plcxx::driver
