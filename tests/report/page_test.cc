// The page as text: well-formed, self-contained, complete, the same every time.
#include "transpiler/report/page.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>

#include "tests/report/program_fixture.h"
#include "transpiler/report/html.h"
#include "transpiler/report/ladder_pictures.h"

namespace plcxx::report {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kProgram = R"(
routine slow slow {
body {
stmt s1
%a = load a
store x %a
stmt s2
%1 = load w
store v %1
}
}
)";

/// A program whose texts try to leave the places that they stand in.
struct Hostile : ProgramFixture {
  Hostile()
      : ProgramFixture(std::string(kMemory) + std::string(kProgram),
                       {"; a comment </script><b>&amp; <!-- \" '", "U1 = </pre></script><script>alert(1)</script>", "",
                        "; second \xE2\x80\xAE turned", "W1 = [W2]"}) {
    program().places[ir::PlaceId(0)].name = "</text><i>&\"'";
    program().documentation = {{"<u>", "", "", "meaning </script> <b>", ""}};
    input().documented = {program().places[ir::PlaceId(0)]};
    input().generated = {
        {"main.cpp",
         "#include <x>\nvoid slow() {\n  // U1 = </pre>\n  m[x] = m[a] < 3 && \"</script>\";\n  m[v] = 1;\n}\n",
         {{3, ir::StatementId(0)}, {5, ir::StatementId(1)}, {6, ir::StatementId()}}}};
    input().tables = {{"Texts <i>", {"number", "text"}, {{"1", "</td></table>"}}}};
  }
};

/// Every element is closed in its order, but what HTML has without an end. Scripts and styles hold plain text.
std::string FaultOf(const std::string& page) {
  std::vector<std::string> open;
  for (size_t at = page.find('<'); at != std::string::npos; at = page.find('<', at + 1)) {
    if (page.compare(at, 2, "<!") == 0) continue;
    const size_t end = page.find('>', at);
    if (end == std::string::npos) return "a tag without an end";
    std::string tag = page.substr(at + 1, end - at - 1);
    if (tag.find('<') != std::string::npos) return "'<' in " + tag;
    const bool closes = tag.starts_with("/");
    const std::string name = tag.substr(closes ? 1 : 0, tag.find_first_of(" />", 1) - (closes ? 1 : 0));
    if (tag.ends_with("/")) continue;
    if (!closes) {
      open.push_back(name);
      if (name == "script" || name == "style") at = page.find("</" + name, end) - 1;
      continue;
    }
    if (open.empty() || open.back() != name)
      return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
    open.pop_back();
  }
  return open.empty() ? "" : open.back() + " stays open";
}

std::set<std::string> Matches(const std::string& text, const char* pattern) {
  std::set<std::string> found;
  const std::regex expression(pattern);
  for (std::sregex_iterator it(text.begin(), text.end(), expression), none; it != none; ++it) found.insert((*it)[1]);
  return found;
}

TEST(Page, IsWellFormedWhateverTheTextsHold) {
  Hostile program;
  const std::string page = Page(program.input());
  EXPECT_EQ(FaultOf(page), "");
  EXPECT_THAT(page, HasSubstr("&lt;/script&gt;&lt;b&gt;&amp;amp; &lt;!-- &quot; &#39;"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("\xE2\x80\xAE"))) << "a mark that turns the direction of a line";
  EXPECT_THAT(page, Not(HasSubstr("<b>&")));
}

TEST(Page, FaultsAreFound) {
  EXPECT_EQ(FaultOf("<p><b>x</p>"), "</p> closes b");
  EXPECT_EQ(FaultOf("<p>x"), "p stays open");
}

TEST(Page, NeedsNothingButItself) {
  Hostile program;
  const std::string page = Page(program.input());
  EXPECT_THAT(page, Not(HasSubstr("http:")));
  EXPECT_THAT(page, Not(HasSubstr("https:")));
  EXPECT_THAT(page, Not(HasSubstr("<link")));
  EXPECT_THAT(page, Not(HasSubstr(" src=")));
  EXPECT_THAT(page, Not(HasSubstr("url(")));
  EXPECT_THAT(page, Not(HasSubstr("@import")));
  EXPECT_THAT(page, Not(HasSubstr("deep"))) << "where a file lay is nobody's business";
  EXPECT_THAT(page, HasSubstr("main.plc:2"));
}

TEST(Page, IsTheSameEveryTime) {
  Hostile one, two;
  EXPECT_EQ(Page(one.input()), Page(two.input()));
  EXPECT_EQ(Page(one.input()), Page(one.input()));
}

TEST(Page, EveryLinkHasATargetAndNoTargetIsDouble) {
  Hostile program;
  const std::string page = Page(program.input());
  const std::set<std::string> ids = Matches(page, " id=\"([^\"]*)\"");
  for (const std::string& link : Matches(page, " href=\"#([^\"]*)\"")) EXPECT_TRUE(ids.contains(link)) << link;
  size_t count = 0;
  for (size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) ++count;
  EXPECT_EQ(count, ids.size());
}

TEST(Page, HasEveryLineOfSourceAndGeneratedCode) {
  Hostile program;
  const std::string page = Page(program.input());
  for (const char* text : {"#include &lt;x&gt;", "void slow() {", "m[v] = 1;", "W1 = [W2]", "data-n=\"6\""}) {
    EXPECT_THAT(page, HasSubstr(text));
  }
}

TEST(Page, AReviewShowsBothVersions) {
  Hostile program, old;
  const Review review{old.input(),
                      {{"x",
                        "output",
                        Verdict::kDifferent,
                        {ir::StatementId(0)},
                        {ir::StatementId(0)},
                        "differs when <a> is 1",
                        "steps: [<run>]"},
                       {"v", "internal", Verdict::kNotDecided, {}, {ir::StatementId(1)}, "time is up", ""},
                       {"z", "internal", Verdict::kEqual, {}, {}, "", ""}}};
  const std::string page = Page(program.input(), review);
  EXPECT_EQ(FaultOf(page), "");
  EXPECT_THAT(page, HasSubstr("1 different, 1 not decided, 1 proved equal"));
  EXPECT_THAT(page, HasSubstr("changed behaviour: x"));
  EXPECT_THAT(page, HasSubstr("differs when &lt;a&gt; is 1"));
  EXPECT_THAT(page, HasSubstr("steps: [&lt;run&gt;]"));
  EXPECT_THAT(page, HasSubstr("id=\"old-s-"));
  const std::set<std::string> ids = Matches(page, " id=\"([^\"]*)\"");
  for (const std::string& link : Matches(page, " href=\"#([^\"]*)\"")) EXPECT_TRUE(ids.contains(link)) << link;
}

TEST(Page, OfAProgramWithoutStatements) {
  ProgramFixture empty("routine slow slow {\nbody {\n}\n}\n", {});
  EXPECT_EQ(FaultOf(Page(empty.input())), "");
}

TEST(LadderPictures, OneForEachRoutineWithTheCommentsAboveTheRungs) {
  Hostile program;
  const std::vector<Picture> pictures = LadderPictures(program.input());
  ASSERT_EQ(pictures.size(), 1u);
  EXPECT_EQ(pictures[0].name, "slow");
  EXPECT_EQ(FaultOf(pictures[0].svg), "");
  EXPECT_THAT(pictures[0].svg, HasSubstr("; a comment &lt;/script&gt;"));
  EXPECT_THAT(pictures[0].svg, HasSubstr("W1 = [W2]"));
  EXPECT_EQ(FaultOf(LadderPicture(program.input())), "");
}

TEST(Escape, ControlCharactersAreShown) { EXPECT_EQ(Escape("a\x01<\tb"), "a\xEF\xBF\xBD&lt;\tb"); }

}  // namespace
}  // namespace plcxx::report
