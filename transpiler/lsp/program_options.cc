#include "transpiler/lsp/program_options.h"

#include "transpiler/compilation/warning_options.h"
#include "transpiler/dialects/dialect.h"

namespace plcxx::lsp {
namespace {

using rpc::Json;

[[noreturn]] void Refuse(const std::string& text) { throw rpc::Error(rpc::kInvalidParams, text); }

std::vector<std::string> TextsOf(const Json& object, const char* key) {
  std::vector<std::string> texts;
  if (!object.contains(key)) return texts;
  for (const Json& text : rpc::ArrayOf(object, key)) {
    if (!text.is_string()) Refuse("'" + std::string(key) + "' holds something that is not a string");
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

/// Numbers and flags of JSON are meant as the texts that --set takes.
std::string OptionText(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  return value.dump();
}

compilation::CompilationRequest ReadProgram(const Json& program) {
  if (!program.is_object()) Refuse("a program is not an object");
  compilation::CompilationRequest request;
  request.sources = TextsOf(program, "sources");
  if (request.sources.empty()) Refuse("a program has no sources");
  request.dialect = rpc::OptionalText(program, "dialect").value_or("");
  if (!request.dialect.empty() && dialects::DialectByName(request.dialect) == nullptr) {
    Refuse("there is no dialect '" + request.dialect + "'");
  }
  request.base_directory = rpc::OptionalText(program, "base").value_or("");
  if (const auto encoding = rpc::OptionalText(program, "encoding")) {
    request.encoding = source::EncodingByName(*encoding);
    if (!request.encoding) Refuse("there is no encoding '" + *encoding + "'");
  }
  if (program.contains("options")) {
    for (const auto& [key, value] : rpc::ObjectOf(program, "options").items()) {
      request.options.emplace_back(key, OptionText(value));
    }
  }
  request.include_directories = TextsOf(program, "include");
  request.system_include_directories = TextsOf(program, "systemInclude");
  for (const std::string& definition : TextsOf(program, "define")) {
    const size_t equals = definition.find('=');
    request.macros.push_back(
        {definition.substr(0, equals), equals == std::string::npos ? "1" : definition.substr(equals + 1)});
  }
  std::vector<std::string> unknown;
  request.warnings = compilation::ReadWarningOptions(TextsOf(program, "warnings"), unknown);
  if (!unknown.empty())
    Refuse("'" + unknown.front() + "' names no warning: " + compilation::RemedyOfUnknownWarning(unknown.front()));
  return request;
}

}  // namespace

std::vector<compilation::CompilationRequest> ReadPrograms(const Json& options) {
  std::vector<compilation::CompilationRequest> requests;
  if (!options.is_object() || !options.contains("programs")) return requests;
  for (const Json& program : rpc::ArrayOf(options, "programs")) requests.push_back(ReadProgram(program));
  return requests;
}

}  // namespace plcxx::lsp
