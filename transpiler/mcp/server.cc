#include "transpiler/mcp/server.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "transpiler/mcp/tools.h"
#include "transpiler/rpc/standard_streams.h"

namespace plcxx::mcp {
namespace {

/// Revisions of the protocol that are served alike; the newest first.
constexpr std::array<std::string_view, 3> kRevisions = {"2025-06-18", "2025-03-26", "2024-11-05"};

constexpr std::string_view kInstructions =
    "Programs of machine tool controls: nc110, technol, host50, prostep, hnc, classicladder. Begin with 'project' to "
    "see what the "
    "folder "
    "holds, then 'check'. Files are named relative to the folder. A scenario names the sources and options of its "
    "program. What 'diff' and 'prove' say is proved or shown by a run; what is not decided is called so.";

Json Initialize(const Json& params) {
  const std::string asked = rpc::OptionalText(params, "protocolVersion").value_or("");
  const bool known = std::ranges::find(kRevisions, asked) != kRevisions.end();
  return {{"protocolVersion", known ? std::string_view(asked) : kRevisions.front()},
          {"capabilities", {{"tools", {{"listChanged", false}}}}},
          {"serverInfo", {{"name", "plcxx"}, {"title", "plcxx"}, {"version", PLCXX_VERSION}}},
          {"instructions", kInstructions}};
}

Json ListTools() {
  Json tools = Json::array();
  for (const Tool& tool : Tools()) {
    tools.push_back({{"name", tool.name},
                     {"title", tool.title},
                     {"description", tool.description},
                     {"inputSchema", tool.schema()},
                     {"annotations",
                      {{"readOnlyHint", !tool.writes}, {"destructiveHint", tool.writes}, {"openWorldHint", false}}}});
  }
  return {{"tools", tools}};
}

/// An object with a member that the schema does not have is a mistake that would pass unseen.
void CheckMembers(const Tool& tool, const Json& arguments) {
  if (!arguments.is_object()) throw rpc::Error(rpc::kInvalidParams, "'arguments' is not an object");
  const Json schema = tool.schema();
  for (const auto& [key, value] : arguments.items()) {
    if (!schema["properties"].contains(key)) {
      throw rpc::Error(rpc::kInvalidParams, "tool '" + std::string(tool.name) + "' has no parameter '" + key + "'");
    }
  }
  for (const Json& key : schema["required"]) {
    if (!arguments.contains(key.get<std::string>())) {
      throw rpc::Error(rpc::kInvalidParams,
                       "tool '" + std::string(tool.name) + "' needs the parameter '" + key.get<std::string>() + "'");
    }
  }
}

Json CallTool(const Workplace& workplace, const Json& params) {
  const std::string name = rpc::TextOf(params, "name");
  const auto tool = std::ranges::find(Tools(), std::string_view(name), &Tool::name);
  if (tool == Tools().end()) throw rpc::Error(rpc::kInvalidParams, "there is no tool '" + name + "'");
  const bool has_arguments = params.contains("arguments") && !params["arguments"].is_null();
  const Json arguments = has_arguments ? params["arguments"] : Json::object();
  CheckMembers(*tool, arguments);
  Json result = tool->run(workplace, arguments);
  // A program with errors is a result; a command that could not do its work is a failure of the tool.
  constexpr int kWrongUse = 2;
  const int code = result.value("exitCode", 0);
  const bool failed = code >= kWrongUse || code < 0;
  const std::string text = result.dump(1, ' ', false, Json::error_handler_t::replace);
  return {
      {"content", {{{"type", "text"}, {"text", text}}}}, {"structuredContent", std::move(result)}, {"isError", failed}};
}

}  // namespace

int Serve(const ServerOptions& options) {
  const Workplace workplace{.plcxx = options.plcxx, .folder = options.folder, .most_seconds = options.most_seconds};
  rpc::StandardStreams streams;
  rpc::Server server(rpc::Framing::kLines, [&](std::string_view text) { streams.Send(rpc::Framing::kLines, text); });
  const auto nothing = [](const Json&) { return Json::object(); };
  server.SetCancel("notifications/cancelled", "requestId");
  server.Add("initialize", Initialize);
  server.Add("ping", nothing);
  server.Add("notifications/initialized", nothing);
  server.Add("notifications/cancelled", nothing);
  server.Add("tools/list", [](const Json&) { return ListTools(); });
  server.Add("tools/call", [&workplace](const Json& params) { return CallTool(workplace, params); });
  streams.Run(server, [] { return false; }, [] { return false; });
  return 0;
}

}  // namespace plcxx::mcp
