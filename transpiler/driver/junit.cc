#include "transpiler/driver/junit.h"

#include <algorithm>
#include <string_view>

namespace plcxx::driver {
namespace {

/// The bytes of the UTF-8 character at `at`; 0 when it is none, or none that XML 1.0 allows.
size_t CharacterBytes(std::string_view text, size_t at) {
  const auto lead = static_cast<unsigned char>(text[at]);
  if (lead < 0x80) return lead >= 0x20 || lead == '\n' || lead == '\t' ? 1 : 0;
  const size_t bytes = lead >= 0xF0 && lead <= 0xF4  ? 4
                       : lead >= 0xE0 && lead < 0xF0 ? 3
                       : lead >= 0xC2 && lead < 0xE0 ? 2
                                                     : 0;
  if (bytes == 0 || at + bytes > text.size()) return 0;
  for (size_t i = 1; i < bytes; ++i) {
    if ((static_cast<unsigned char>(text[at + i]) & 0xC0) != 0x80) return 0;
  }
  const auto second = static_cast<unsigned char>(text[at + 1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second >= 0xA0) || (lead == 0xF4 && second >= 0x90);
  const bool no_character = lead == 0xEF && second == 0xBF && static_cast<unsigned char>(text[at + 2]) >= 0xBE;
  return overlong || beyond || no_character ? 0 : bytes;
}

/// Text between tags or in an attribute; what XML cannot hold becomes the replacement character.
std::string EscapedForXml(std::string_view text) {
  std::string escaped;
  for (size_t at = 0; at < text.size();) {
    const size_t bytes = CharacterBytes(text, at);
    const std::string_view character = text.substr(at, bytes);
    if (bytes == 0) {
      escaped += "\xEF\xBF\xBD";
    } else if (character == "&") {
      escaped += "&amp;";
    } else if (character == "<") {
      escaped += "&lt;";
    } else if (character == ">") {
      escaped += "&gt;";
    } else if (character == "\"") {
      escaped += "&quot;";
    } else {
      escaped += character;
    }
    at += std::max<size_t>(bytes, 1);
  }
  return escaped;
}

std::string_view Element(scenarios::TestOutcome outcome) {
  return outcome == scenarios::TestOutcome::kFailed ? "failure" : "error";
}

std::string_view SuiteNameOf(JunitOf what) {
  switch (what) {
    case JunitOf::kScenarios:
      return "scenarios";
    case JunitOf::kProperties:
      return "properties";
  }
  return {};
}

std::string_view SuiteCommandOf(JunitOf what) {
  switch (what) {
    case JunitOf::kScenarios:
      return "plcxx test";
    case JunitOf::kProperties:
      return "plcxx prove";
  }
  return {};
}

}  // namespace

std::string JunitXml(std::span<const scenarios::TestCase> cases, JunitOf what) {
  const auto count = [&](scenarios::TestOutcome outcome) {
    return std::to_string(
        std::count_if(cases.begin(), cases.end(), [&](const scenarios::TestCase& c) { return c.outcome == outcome; }));
  };
  const std::string counts = " tests=\"" + std::to_string(cases.size()) + "\" failures=\"" +
                             count(scenarios::TestOutcome::kFailed) + "\" errors=\"" +
                             count(scenarios::TestOutcome::kUnusable) + "\"";
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"" +
                    std::string(SuiteCommandOf(what)) + "\"" + counts + ">\n";
  xml += "  <testsuite name=\"" + std::string(SuiteNameOf(what)) + "\"" + counts + " skipped=\"0\">\n";
  for (const scenarios::TestCase& test : cases) {
    xml += "    <testcase classname=\"" + EscapedForXml(test.group) + "\" name=\"" + EscapedForXml(test.name) + "\"";
    if (test.outcome == scenarios::TestOutcome::kPassed) {
      xml += "/>\n";
      continue;
    }
    const std::string element(Element(test.outcome));
    const std::string_view first_line = std::string_view(test.text).substr(0, test.text.find('\n'));
    xml += ">\n      <" + element + " message=\"" + EscapedForXml(first_line) + "\">" + EscapedForXml(test.text) +
           "</" + element + ">\n    </testcase>\n";
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace plcxx::driver
