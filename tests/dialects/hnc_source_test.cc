// The text before it is parsed: encodings, line ends, literals, comments, characters (specification 1, 2.1, 2.2).
// covers: HNC-001 HNC-002 HNC-005..007 HNC-010..013 HNC-029 HNC-032

#include "tests/dialects/hnc_parsing.h"
#include "transpiler/dialects/hnc/source/source_text.h"

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct Rewritten {
  source::SourceManager sources;
  SourceText text;

  explicit Rewritten(const std::string& bytes) {
    const auto loaded = sources.AddBytes("test.cld", bytes, LoadOptionsOf(std::nullopt));
    text = Rewrite(sources, std::get<source::FileId>(loaded));
  }
  std::vector<std::string> Findings() const {
    std::vector<std::string> found;
    for (const Finding& finding : text.findings.all()) {
      const source::Position position = sources.Locate(finding.range.begin);
      found.push_back(std::to_string(position.line) + ":" + std::to_string(position.column) + " " +
                      std::string(finding.row.code.substr(4)));
    }
    return found;
  }
};

TEST(HncSource, LineEnds) {
  EXPECT_EQ(Rewritten("a\r\nb\rc\nd").text.text, "a\nb\nc\nd\n");
  EXPECT_EQ(Rewritten("a\\\r\nb").text.text, "a\\\nb\n");
}

TEST(HncSource, TheEndMarkEndsTheFile) { EXPECT_EQ(Rewritten("a\n\x1A garbage '").text.text, "a\n"); }

TEST(HncSource, LiteralsHoldTheBytesOfTheFile) {
  EXPECT_EQ(Rewritten("\"\xD6\xD0\"").text.text, "\"\xD6\xD0\"\n");          // GBK
  EXPECT_EQ(Rewritten("\"\xE4\xB8\xAD\"").text.text, "\"\xE4\xB8\xAD\"\n");  // UTF-8
  EXPECT_EQ(Rewritten("\"\xD6\x5C\"").text.text, "\"\xD6\\134\"\n") << "the second byte is no backslash";
}

TEST(HncSource, TwoCharactersInTheOrderOfTheParser) {
  EXPECT_EQ(Rewritten("#if 'AB'").text.text, "#if '\\102\\101'\n");
  EXPECT_EQ(Rewritten("'AB'").text.text, "'AB'\n") << "the tokens are filtered; # of a macro wants what is written";
  EXPECT_EQ(Rewritten("'A'").text.text, "'A'\n");
  EXPECT_EQ(Rewritten("'\\0\\x41'").text.text, "'\\101\\000'\n");
  EXPECT_EQ(Rewritten("#if '\xD6\xD0'").text.text, "#if '\\320\\326'\n");
  EXPECT_EQ(Rewritten("'\xD6\xD0'").text.text, "'\xD6\xD0'\n");
  EXPECT_EQ(Rewritten("'\xD6\x5C'").text.text, "'\\134\\326'\n") << "its second byte is a backslash";
  EXPECT_THAT(Rewritten("'abc'").Findings(), ElementsAre("1:1 E004"));
}

TEST(HncSource, CharactersOutsideLiterals) {
  EXPECT_THAT(Rewritten("int a\xA3\xBD 5;").Findings(), ElementsAre("1:6 E002"));  // full-width =
  EXPECT_EQ(Rewritten("int a\xA3\xBD 5;").text.text, "int a= 5;\n");
  EXPECT_THAT(Rewritten("\xD6\xD0\xCE\xC4 x $").Findings(), ElementsAre("1:1 E002", "1:6 E002"));
  EXPECT_THAT(Rewritten("// \xD6\xD0\n/* \xD6\xD0 */ \"\xD6\xD0\"").Findings(), IsEmpty());
}

TEST(HncSource, CommentsThatContinue) {
  EXPECT_THAT(Rewritten("// text \\\nmore\n").Findings(), ElementsAre("1:9 W22"));
  EXPECT_THAT(Rewritten("// \xD6\x5C\nx\n").Findings(), ElementsAre("1:4 W22"));
  EXPECT_EQ(Rewritten("// a \\  \nx\n").text.text, "// a    \nx\n") << "blanks between: no splice";
  EXPECT_EQ(Rewritten("// a \\\\ \nx\n").text.text, "// a    \nx\n") << "nor by the one in front of it";
  EXPECT_EQ(Rewritten("// a \\ \\\t\nx\n").text.text, "// a     \nx\n");
  EXPECT_EQ(Rewritten("#pragma argsused \\ \nx\n").text.text, "#pragma argsused   \nx\n");
  EXPECT_EQ(Rewritten("it's \\ \n#endif\n").text.text, "it's   \n#endif\n");
  EXPECT_EQ(Rewritten("foo \\ \n#endif\n").text.text, "foo   \n#endif\n") << "nobody goes on with a directive";
}

TEST(HncSource, TextOfComments) {
  const Rewritten text("/* one\n * two\n */ x // three\n");
  ASSERT_EQ(text.text.comments.size(), 2U);
  EXPECT_EQ(text.text.comments[0].text, "one\ntwo");
  EXPECT_EQ(text.text.comments[1].text, "three");
}

TEST(HncSource, PlacesGoBackToTheFile) {
  const Rewritten text("\"\xD6\xD0\"; x\r\ny");
  const auto column_of = [&](const char* word) {
    const auto at = static_cast<uint32_t>(text.text.text.find(word));
    const source::Position position = text.sources.Locate(text.text.Original(at));
    return std::to_string(position.line) + ":" + std::to_string(position.column);
  };
  EXPECT_EQ(column_of("x"), "1:6");
  EXPECT_EQ(column_of("y"), "2:1");
}

TEST(HncSource, ForeignTextInGroupsThatDoNotCount) {
  EXPECT_THAT(ErrorsOf("#if 0\ndon't \xA3\xBD\n#endif\n"), IsEmpty());
}

TEST(HncSource, PlacesBehindLine) {
  EXPECT_THAT(ErrorsOf("#line 100 \"panel.cld\"\nint a;\nint b = nowhere;\n"), ElementsAre("panel.cld:101:9 E010"));
}

}  // namespace
}  // namespace plcxx::hnc
