#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "tests/diagnostics/reporting.h"
#include "transpiler/diagnostics/explain.h"

namespace plcxx::diag {
namespace {

using nlohmann::json;

/// The rules of the SARIF 2.1.0 schema for the objects that we write: what is required, what is allowed, which values.
class SchemaCheck {
 public:
  std::vector<std::string> Faults(const json& log) {
    Object(log, "log", {"version", "runs"}, {"$schema"});
    if (log.value("version", "") != "2.1.0") Fault("log.version");
    for (const json& run : log.value("runs", json::array())) Run(run);
    return faults_;
  }

 private:
  void Fault(const std::string& what) { faults_.push_back(what); }

  void Object(const json& object, const std::string& what, std::set<std::string> required,
              const std::set<std::string>& optional) {
    if (!object.is_object()) return Fault(what + " is no object");
    for (const auto& [key, value] : object.items()) {
      if (required.erase(key) == 0 && !optional.contains(key)) Fault(what + "." + key + " is unknown");
    }
    for (const std::string& key : required) Fault(what + "." + key + " is missing");
  }

  void Run(const json& run) {
    Object(run, "run", {"tool"}, {"results", "columnKind"});
    const std::string kind = run.value("columnKind", "");
    if (kind != "unicodeCodePoints" && kind != "utf16CodeUnits") Fault("run.columnKind");
    Object(run.at("tool"), "tool", {"driver"}, {});
    const json& driver = run.at("tool").at("driver");
    Object(driver, "driver", {"name"}, {"version", "rules"});
    for (const json& rule : driver.at("rules")) Rule(rule);
    for (const json& result : run.at("results")) Result(result, driver.at("rules"));
  }

  void Rule(const json& rule) {
    Object(rule, "rule", {"id"}, {"shortDescription", "help", "defaultConfiguration"});
    Object(rule.at("shortDescription"), "shortDescription", {"text"}, {"markdown"});
    Object(rule.at("help"), "help", {"text"}, {"markdown"});
    Object(rule.at("defaultConfiguration"), "defaultConfiguration", {}, {"enabled", "level"});
    Level(rule.at("defaultConfiguration").value("level", "warning"));
  }

  void Level(const std::string& level) {
    if (!std::set<std::string>{"none", "note", "warning", "error"}.contains(level)) Fault("level " + level);
  }

  void Result(const json& result, const json& rules) {
    Object(result, "result", {"message"},
           {"ruleId", "ruleIndex", "level", "locations", "relatedLocations", "fixes", "properties"});
    Object(result.at("message"), "message", {"text"}, {});
    Level(result.value("level", "warning"));
    if (rules.at(result.at("ruleIndex").get<size_t>()).at("id") != result.at("ruleId")) Fault("ruleIndex");
    for (const json& location : result.value("locations", json::array())) Location(location);
    for (const json& location : result.value("relatedLocations", json::array())) Location(location);
    for (const json& fix : result.value("fixes", json::array())) Fix(fix);
  }

  void Location(const json& location) {
    Object(location, "location", {}, {"physicalLocation", "message"});
    if (!location.contains("physicalLocation")) return;
    const json& physical = location.at("physicalLocation");
    Object(physical, "physicalLocation", {"artifactLocation"}, {"region"});
    Artifact(physical.at("artifactLocation"));
    Region(physical.at("region"));
  }

  void Artifact(const json& artifact) {
    Object(artifact, "artifactLocation", {"uri"}, {});
    for (const char c : artifact.at("uri").get<std::string>()) {
      if (c <= ' ' || c > '~' || std::string_view("<>\"\\^`{|}").find(c) != std::string_view::npos) Fault("uri");
    }
  }

  void Region(const json& region) {
    Object(region, "region", {"startLine", "startColumn", "endLine", "endColumn"}, {});
    for (const auto& [key, value] : region.items()) {
      if (!value.is_number_integer() || value.get<int>() < 1) Fault("region." + key);
    }
    const auto place = [&](const char* line, const char* column) {
      return std::pair(region.at(line).get<int>(), region.at(column).get<int>());
    };
    if (place("startLine", "startColumn") > place("endLine", "endColumn")) Fault("region ends before it begins");
  }

  void Fix(const json& fix) {
    Object(fix, "fix", {"artifactChanges"}, {"description"});
    Object(fix.at("description"), "description", {"text"}, {});
    for (const json& change : fix.at("artifactChanges")) {
      Object(change, "artifactChange", {"artifactLocation", "replacements"}, {});
      Artifact(change.at("artifactLocation"));
      if (change.at("replacements").empty()) Fault("no replacements");
      for (const json& replacement : change.at("replacements")) {
        Object(replacement, "replacement", {"deletedRegion"}, {"insertedContent"});
        Region(replacement.at("deletedRegion"));
        Object(replacement.at("insertedContent"), "insertedContent", {"text"}, {});
      }
    }
  }

  std::vector<std::string> faults_;
};

json Checked(const Reporting& report) {
  const json log = json::parse(report.Sarif());
  EXPECT_EQ(SchemaCheck().Faults(log), std::vector<std::string>());
  return log;
}

Reporting Rich() {
  Reporting report("$\nЖ=IOA7 (\n", "dir with blank/Ж#1.plc");
  Diagnostic& diagnostic = report.engine.Report(report.Find("IOA7"), kBroken, "IOA7");
  diagnostic.notes.push_back({report.Find("("), "this one"});
  diagnostic.notes.push_back({{}, "placeless"});
  diagnostic.fixits.push_back({report.Find("O"), "0"});
  diagnostic.fixits.push_back({report.Find("("), ""});
  report.engine.Report({}, kOdd);
  report.engine.Report(report.Find("$"), kOdd);
  return report;
}

TEST(SchemaCheck, FindsWhatIsWrong) {
  json log = Checked(Rich());
  log["runs"][0]["tool"]["driver"].erase("name");
  log["runs"][0]["results"][0]["message"].erase("text");
  log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0;
  log["runs"][0]["results"][1]["ruleIndex"] = 0;
  log["runs"][0]["results"][2]["level"] = "fatal";
  EXPECT_EQ(SchemaCheck().Faults(log), (std::vector<std::string>{"driver.name is missing", "message.text is missing",
                                                                 "region.startLine", "ruleIndex", "level fatal"}));
}

TEST(RenderSarif, WithoutDiagnostics) {
  const json log = Checked(Reporting("x"));
  EXPECT_TRUE(log["runs"][0]["results"].is_array());
  EXPECT_TRUE(log["runs"][0]["results"].empty());
  EXPECT_TRUE(log["runs"][0]["tool"]["driver"]["rules"].empty());
}

TEST(RenderSarif, TheLog) {
  const json log = Checked(Rich());
  EXPECT_TRUE(log["$schema"].get<std::string>().find("sarif") != std::string::npos);
  const json& run = log["runs"][0];
  EXPECT_EQ(run["tool"]["driver"]["name"], "plcxx");
  EXPECT_EQ(run["tool"]["driver"]["version"], "0.1.0");
  EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
  EXPECT_EQ(run["tool"]["driver"]["rules"].size(), 2u) << "one per code";
  EXPECT_EQ(run["results"].size(), 3u);
}

TEST(RenderSarif, AResult) {
  const json result = Checked(Rich())["runs"][0]["results"][0];
  EXPECT_EQ(result["ruleId"], "test-1");
  EXPECT_EQ(result["level"], "error");
  EXPECT_EQ(result["message"]["text"], "'IOA7' is broken");
  EXPECT_EQ(result["locations"][0]["physicalLocation"], json::parse(R"({
    "artifactLocation": {"uri": "dir%20with%20blank/%D0%96%231.plc"},
    "region": {"startLine": 2, "startColumn": 3, "endLine": 2, "endColumn": 7}})"));
  ASSERT_EQ(result["relatedLocations"].size(), 2u);
  EXPECT_EQ(result["relatedLocations"][0]["message"]["text"], "this one");
  EXPECT_EQ(result["relatedLocations"][0]["physicalLocation"]["region"]["startColumn"], 8);
  EXPECT_FALSE(result["relatedLocations"][1].contains("physicalLocation"));
  EXPECT_EQ(result["properties"]["help"], "mend it");
}

TEST(RenderSarif, AFix) {
  const json fix = Checked(Rich())["runs"][0]["results"][0]["fixes"][0];
  EXPECT_EQ(fix["description"]["text"], "replace 'O' by '0', delete '('");
  ASSERT_EQ(fix["artifactChanges"].size(), 1u) << "one file";
  const json& replacements = fix["artifactChanges"][0]["replacements"];
  ASSERT_EQ(replacements.size(), 2u);
  EXPECT_EQ(replacements[0]["insertedContent"]["text"], "0");
  EXPECT_EQ(replacements[0]["deletedRegion"]["startColumn"], 4);
  EXPECT_EQ(replacements[1]["insertedContent"]["text"], "");
}

TEST(RenderSarif, WithoutPlaceNoLocations) {
  EXPECT_FALSE(Checked(Rich())["runs"][0]["results"][1].contains("locations"));
}

TEST(RenderSarif, ARuleOfTheCatalogueHasItsPage) {
  Reporting report("x");
  report.engine.Report(report.Find("x"), Nc110UnknownIdentifier, "x");
  report.engine.Report({}, UnknownDialect, "x", "y");
  const json rules = Checked(report)["runs"][0]["tool"]["driver"]["rules"];
  EXPECT_EQ(rules[0]["id"], "plcxx-1") << "the order of the catalogue";
  EXPECT_EQ(rules[1]["id"], "nc110-1");
  EXPECT_EQ(rules[1]["help"]["markdown"], Explain("nc110-1").value());
  EXPECT_EQ(rules[1]["shortDescription"]["text"], "malformed operand");
  EXPECT_EQ(rules[1]["defaultConfiguration"]["level"], "error");
}

TEST(RenderSarif, UrisOfUnusualPaths) {
  const std::pair<const char*, const char*> paths[] = {
      {"/abs/a.plc", "file:///abs/a.plc"}, {"<stdin>", "%3Cstdin%3E"},
      {"../up/a.plc", "../up/a.plc"},      {"c:a.plc", "c%3Aa.plc"},
      {"100%.plc", "100%25.plc"},          {"a\xFF?.plc", "a%FF%3F.plc"},
      {"a\\b.plc", "a%5Cb.plc"},           {"tab\tname", "tab%09name"},
  };
  for (const auto& [path, uri] : paths) {
    Reporting report("x", path);
    report.engine.Report(report.Find("x"), kOdd);
    const json result = Checked(report)["runs"][0]["results"][0];
    EXPECT_EQ(result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"], uri);
  }
}

TEST(RenderSarif, SameInputSameBytes) { EXPECT_EQ(Rich().Sarif(), Rich().Sarif()); }

}  // namespace
}  // namespace plcxx::diag
