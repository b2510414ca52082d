#include "transpiler/review/verify/certificate.h"

#include <map>
#include <nlohmann/json.hpp>

#include "transpiler/compile/runtime_files.h"
#include "transpiler/scenarios/failure.h"
#include "transpiler/support/sha256.h"

namespace plcxx::review::verify {
namespace {

using Json = nlohmann::ordered_json;

/// Without the folder: the certificate is the same wherever the sources stand.
std::string FileName(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

Json Hashed(const std::string& name, std::string_view bytes) {
  return {{"file", name}, {"sha256", support::Sha256(bytes)}};
}

std::string_view Name(prove::verify::ProofResult result) {
  switch (result) {
    case prove::verify::ProofResult::kProved:
      return "proved";
    case prove::verify::ProofResult::kDifferent:
      return "different";
    case prove::verify::ProofResult::kNotDecided:
      return "not decided";
  }
  return "";
}

Json DifferenceJson(const prove::verify::CodeDifference& difference) {
  Json json = {{"what", difference.what}};
  if (!difference.has_values) return json;
  json["expected"] = difference.expected;
  json["compiled"] = difference.compiled;
  json["state"] = Json::object();
  for (const prove::verify::VariableValue& value : difference.state) json["state"][value.name] = value.value;
  return json;
}

/// "main.cld:7:9: a[i] = 0;" without the folder of the file.
std::string WithoutFolder(const std::string& place) {
  const size_t slash = place.rfind('/', place.find(':'));
  return slash == std::string::npos ? place : place.substr(slash + 1);
}

Json RoutineJson(const prove::verify::RoutineProof& proof, const compilation::Compilation& compilation) {
  Json json = {{"routine", proof.routine}, {"result", Name(proof.result)}};
  if (!proof.reason.empty()) json["reason"] = proof.reason;
  if (proof.statement.valid()) {
    json["loop_of"] =
        WithoutFolder(scenarios::StatementPlace(proof.statement, compilation.program, *compilation.sources));
  }
  json["state_bytes"] = proof.bytes;
  json["host_functions"] = proof.host_functions;
  json["obligations"] = proof.obligations;
  if (proof.claims != 0) json["loop_claims"] = proof.claims;
  json["instructions"] = proof.instructions;
  if (!proof.relies_on.empty()) json["relies_on"] = proof.relies_on;
  for (const prove::verify::CodeDifference& difference : proof.differences)
    json["differences"].push_back(DifferenceJson(difference));
  return json;
}

/// How many of each kind are proved, and each one that is not.
Json FactsJson(const FactsReport& facts) {
  Json json = {{"proved", facts.CountOf(prove::verify::facts::FactResult::kProved)}, {"of", facts.findings.size()}};
  if (!facts.refusal.empty()) json["refused"] = facts.refusal;
  std::map<std::string, uint64_t> kinds;
  for (const FactFinding& finding : facts.findings) {
    if (finding.result == prove::verify::facts::FactResult::kProved) ++kinds[finding.kind];
  }
  json["kinds"] = Json::object();
  for (const auto& [kind, count] : kinds) json["kinds"][kind] = count;
  for (const FactFinding& finding : facts.findings) {
    switch (finding.result) {
      case prove::verify::facts::FactResult::kProved:
        break;
      case prove::verify::facts::FactResult::kNotDecided:
        json["open"].push_back(
            {{"kind", finding.kind}, {"statement", WithoutFolder(finding.place)}, {"reason", finding.reason}});
        break;
      case prove::verify::facts::FactResult::kViolated:
        json["violated"].push_back({{"kind", finding.kind},
                                    {"statement", WithoutFolder(finding.place)},
                                    {"value", finding.value},
                                    {"routine", finding.routine},
                                    {"state", finding.state}});
        break;
    }
  }
  return json;
}

Json FrontEndJson(const prove::verify::front_end::Comparison& comparison, const compilation::Compilation& compilation) {
  Json json = {{"compiler", comparison.compiler}};
  if (!comparison.reason.empty()) json["not_compared"] = comparison.reason;
  json["assumed"] = {"executions that come to a run-time fault are not compared: C leaves them open",
                     "what the control itself has (the schedule, its functions, the dispatcher) is not compared"};
  json["functions"] = Json::array();
  for (const prove::verify::front_end::FunctionProof& function : comparison.functions) {
    if (function.not_compared.empty()) {
      json["functions"].push_back(RoutineJson(function.proof, compilation));
      // Of its calls alone, in the proofs of these.
      if (!function.in_callers.empty()) json["functions"].back()["in_callers"] = function.in_callers;
      continue;
    }
    json["functions"].push_back({{"routine", function.proof.routine}, {"not_compared", function.not_compared}});
  }
  return json;
}

}  // namespace

std::string CertificateText(const Certificate& certificate) {
  const compilation::Compilation& compilation = *certificate.compilation;
  Json json = {{"program", compilation.name}, {"dialect", compilation.program.dialect},
               {"plcxx", PLCXX_VERSION},      {"options", Json::object()},
               {"sources", Json::array()},    {"generated", Json::array()},
               {"runtime", Json::array()}};
  for (const auto& [key, value] : compilation.options) json["options"][key] = value;
  // All that was read, what options and includes name, too.
  for (uint32_t i = 0; i < compilation.sources->size(); ++i) {
    const source::File& file = compilation.sources->Get(source::FileId(i));
    json["sources"].push_back(Hashed(FileName(file.path), file.text));
  }
  for (const emit::OutputFile& file : *certificate.files) json["generated"].push_back(Hashed(file.name, file.text));
  for (const compile::RuntimeFile& file : compile::RuntimeFiles())
    json["runtime"].push_back(Hashed(file.name, file.text));
  if (certificate.objects.empty()) {
    json["compiler"] = {{"version", certificate.toolchain->version},
                        {"target", certificate.target->name},
                        {"flags", certificate.bitcode->flags}};
  }
  for (const auto& [path, bytes] : certificate.objects) json["objects"].push_back(Hashed(FileName(path), bytes));
  json["assumed"] = {"a bit that has a byte of its own is 0 or 1 there before a routine",
                     "host functions write what their declarations say and nothing else",
                     "a retentive copy that the host gives has the program's layout",
                     "of the state from which a fact is shown, nothing",
                     certificate.objects.empty()
                         ? "the compiler translates LLVM IR to the processor's instructions as LLVM defines it"
                         : "the linker writes what the objects' notes say, and library functions do what they promise"};
  bool all = true;
  json["routines"] = Json::array();
  for (const prove::verify::RoutineProof& proof : *certificate.proofs) {
    json[proof.exported ? "routines" : "functions"].push_back(RoutineJson(proof, compilation));
    if (proof.exported) all = all && proof.result == prove::verify::ProofResult::kProved;
  }
  json["facts"] = FactsJson(*certificate.facts);
  all = all && certificate.facts->all_proved();
  if (!certificate.left_out.empty()) json["left_out"] = certificate.left_out;
  if (certificate.front_end != nullptr) json["front_end"] = FrontEndJson(*certificate.front_end, compilation);
  json["proved"] = all && certificate.left_out.empty();
  return json.dump(2) + "\n";
}

}  // namespace plcxx::review::verify
