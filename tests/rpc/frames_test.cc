#include "transpiler/rpc/frames.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace plcxx::rpc {
namespace {

/// What is read from `bytes` when they arrive in pieces of `piece` bytes; errors begin with '!'.
std::vector<std::string> Read(FrameReader& reader, std::string_view bytes, size_t piece = 1) {
  std::vector<std::string> texts;
  for (size_t at = 0; at < bytes.size(); at += piece) {
    reader.Feed(bytes.substr(at, piece));
    while (const auto frame = reader.Next()) texts.push_back(frame->error.empty() ? frame->text : "!" + frame->error);
  }
  return texts;
}

std::string Frame(std::string_view text) { return Framed(Framing::kHeaders, text); }

TEST(Frames, AreReadInPiecesOfAnySize) {
  const std::string bytes =
      Frame("{}") + "Content-Type: x\r\ncontent-length:  4\r\n\r\n[12]" + "Content-Length: 2\n\n{}";
  for (const size_t piece : {1u, 2u, 3u, 7u, 1000u}) {
    FrameReader reader(Framing::kHeaders);
    EXPECT_EQ(Read(reader, bytes, piece), (std::vector<std::string>{"{}", "[12]", "{}"})) << piece;
  }
}

TEST(Frames, AfterAHeaderWithoutLengthReadingGoesOn) {
  for (const char* bad : {"Content-Length: many\r\n\r\n", "Content-Length: -5\r\n\r\n", "Content-Length:\r\n\r\n",
                          "\r\n\r\n", "nonsense\r\n\r\n{\"a\":1}", "Content-Length: 99999999999999999999999\r\n\r\n"}) {
    FrameReader reader(Framing::kHeaders);
    const std::vector<std::string> texts = Read(reader, bad + Frame("{}"));
    ASSERT_GE(texts.size(), 2u) << bad;
    EXPECT_EQ(texts.front().front(), '!') << bad;
    EXPECT_EQ(texts.back(), "{}") << bad;
  }
}

TEST(Frames, AHeaderWithoutEndIsRefused) {
  FrameReader reader(Framing::kHeaders);
  const std::vector<std::string> texts = Read(reader, std::string(10'000, 'x') + Frame("{}"), 1000);
  ASSERT_FALSE(texts.empty());
  EXPECT_EQ(texts.front().front(), '!');
  EXPECT_EQ(texts.back(), "{}");
}

TEST(Frames, ALengthThatIsTooLargeSwallowsNothingForGood) {
  FrameReader reader(Framing::kHeaders);
  reader.Feed("Content-Length: 40\r\n\r\n{}" + Frame("{\"a\":1}") + Frame("[]"));
  const auto swallowed = reader.Next();
  ASSERT_TRUE(swallowed);
  ASSERT_TRUE(swallowed->error.empty());
  reader.Reread(swallowed->text);
  std::vector<std::string> texts;
  while (const auto frame = reader.Next()) texts.push_back(frame->text);
  EXPECT_EQ(texts, (std::vector<std::string>{"{\"a\":1}", "[]"}));
}

TEST(Frames, ALengthThatIsTooSmallLeavesARestThatIsSkipped) {
  FrameReader reader(Framing::kHeaders);
  const std::vector<std::string> texts = Read(reader, "Content-Length: 3\r\n\r\n{\"a\":1}" + Frame("[]"), 5);
  ASSERT_EQ(texts.size(), 3u) << ::testing::PrintToString(texts);
  EXPECT_EQ(texts[0], "{\"a");
  EXPECT_EQ(texts[1].front(), '!');
  EXPECT_EQ(texts[2], "[]");
}

TEST(Frames, AMessageAboveTheLimitIsSkipped) {
  FrameReader headers(Framing::kHeaders, 10);
  std::vector<std::string> texts = Read(headers, Frame(std::string(1000, 'x')) + Frame("{}"), 13);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0].front(), '!');
  EXPECT_EQ(texts[1], "{}");

  FrameReader lines(Framing::kLines, 10);
  texts = Read(lines, std::string(1000, 'x') + "\n{}\n", 7);
  ASSERT_EQ(texts.size(), 2u);
  EXPECT_EQ(texts[0].front(), '!');
  EXPECT_EQ(texts[1], "{}");
}

// A length of 10^12 made the server deaf: it waited for so many bytes.
TEST(Frames, AHeaderEndsAMessageThatIsTooLong) {
  FrameReader reader(Framing::kHeaders, 100);
  std::vector<std::string> texts =
      Read(reader, "Content-Length: 1000000000000\r\n\r\n{}" + Frame("[1]") + Frame("[2]"), 3);
  ASSERT_EQ(texts.size(), 3u) << ::testing::PrintToString(texts);
  EXPECT_EQ(texts[0].front(), '!');
  EXPECT_EQ(texts[1], "[1]");
  EXPECT_EQ(texts[2], "[2]");

  // A text that speaks of a header is none.
  const std::string talk = "{\"a\":\"Content-Length: 5\\r\\n\", \"b\":\"content-length:\"}" + std::string(200, ' ');
  texts = Read(reader, Frame(talk) + Frame("[3]"), 7);
  ASSERT_EQ(texts.size(), 2u) << ::testing::PrintToString(texts);
  EXPECT_EQ(texts[0].front(), '!');
  EXPECT_EQ(texts[1], "[3]");
}

TEST(Frames, LinesAreMessages) {
  FrameReader reader(Framing::kLines);
  EXPECT_EQ(Read(reader, "{}\r\n\n  \n[1]\nrest"), (std::vector<std::string>{"{}", "[1]"}));
}

}  // namespace
}  // namespace plcxx::rpc
