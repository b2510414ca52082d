// JUnit's XML of scenarios.
#include "transpiler/driver/junit.h"

#include <gtest/gtest.h>

#include <vector>

#include "transpiler/scenarios/test_case.h"

namespace plcxx::driver {
namespace {

TEST(Junit, IsEscapedAndCounted) {
  const std::vector<scenarios::TestCase> cases = {
      {"a.yaml", "dir", scenarios::TestOutcome::kPassed, ""},
      {"b<1>.yaml", "dir", scenarios::TestOutcome::kFailed, "x < \"y\" & \x01\xFF\nsecond"},
      {"c.yaml", "", scenarios::TestOutcome::kUnusable, "\xD0\x96"}};
  EXPECT_EQ(JunitXml(cases, JunitOf::kScenarios),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<testsuites name=\"plcxx test\" tests=\"3\" failures=\"1\" errors=\"1\">\n"
            "  <testsuite name=\"scenarios\" tests=\"3\" failures=\"1\" errors=\"1\" skipped=\"0\">\n"
            "    <testcase classname=\"dir\" name=\"a.yaml\"/>\n"
            "    <testcase classname=\"dir\" name=\"b&lt;1&gt;.yaml\">\n"
            "      <failure message=\"x &lt; &quot;y&quot; &amp; \xEF\xBF\xBD\xEF\xBF\xBD\">x &lt; &quot;y&quot; &amp; "
            "\xEF\xBF\xBD\xEF\xBF\xBD\nsecond</failure>\n"
            "    </testcase>\n"
            "    <testcase classname=\"\" name=\"c.yaml\">\n"
            "      <error message=\"\xD0\x96\">\xD0\x96</error>\n"
            "    </testcase>\n"
            "  </testsuite>\n"
            "</testsuites>\n");
}

TEST(Junit, SaysWhichCommandItIsOf) {
  const std::vector<scenarios::TestCase> cases = {{"never A", "p.prop", scenarios::TestOutcome::kPassed, ""}};
  const std::string xml = JunitXml(cases, JunitOf::kProperties);
  EXPECT_NE(xml.find("<testsuites name=\"plcxx prove\""), std::string::npos) << xml;
  EXPECT_NE(xml.find("<testsuite name=\"properties\""), std::string::npos) << xml;
}

}  // namespace
}  // namespace plcxx::driver
