#include <gtest/gtest.h>

#include "tests/source/loading.h"
#include "transpiler/source/source.h"

namespace plcxx::source {
namespace {

struct Expected {
  uint32_t at, line, column;
};

void ExpectPlaces(std::string text, std::initializer_list<Expected> places) {
  SourceManager sources;
  const FileId file = sources.AddText("a.plc", std::move(text));
  for (const Expected& place : places) {
    const Position position = sources.Locate(sources.Get(file).base + place.at);
    EXPECT_EQ(position.file, file);
    EXPECT_EQ(position.line, place.line) << "at " << place.at;
    EXPECT_EQ(position.column, place.column) << "at " << place.at;
  }
}

TEST(Places, EveryLineEndCounts) {
  ExpectPlaces("a\nb\r\nc\rd", {{0, 1, 1}, {1, 1, 2}, {2, 2, 1}, {4, 2, 3}, {5, 3, 1}, {7, 4, 1}, {8, 4, 2}});
}

TEST(Places, ColumnsAreCharacters) { ExpectPlaces("\tЖ=x\n", {{1, 1, 2}, {2, 1, 2}, {3, 1, 3}, {4, 1, 4}}); }

TEST(Places, EndOfTextBehindTheLastLineEnd) { ExpectPlaces("a\n", {{2, 2, 1}}); }

TEST(Places, EmptyText) { ExpectPlaces("", {{0, 1, 1}}); }

TEST(Places, NoPlaceIsSafe) {
  SourceManager sources;
  EXPECT_FALSE(sources.FileAt(0).valid());
  sources.AddText("a.plc", "text");
  EXPECT_FALSE(sources.FileAt(0).valid());
  EXPECT_FALSE(sources.Locate(0).file.valid());
  EXPECT_EQ(sources.Locate(0).line, 0u);
  EXPECT_EQ(sources.Text({0, 0}), "");
  EXPECT_EQ(sources.Text({0, 3}), "");
  EXPECT_EQ(sources.OriginalByte(0), 0u);
}

TEST(Places, BehindEverythingIsTheEndOfTheLastFile) {
  SourceManager sources;
  const FileId file = sources.AddText("a.plc", "ab");
  EXPECT_EQ(sources.Locate(1000).file, file);
  EXPECT_EQ(sources.Locate(1000).column, 3u);
  EXPECT_EQ(sources.Text({2, 1000}), "b");
}

TEST(Places, FilesDoNotTouch) {
  SourceManager sources;
  const FileId first = sources.AddText("a.plc", "ab");
  const FileId empty = sources.AddText("b.plc", "");
  const FileId last = sources.AddText("c.plc", "c");
  EXPECT_EQ(sources.FileAt(sources.WholeFile(first).end), first);
  EXPECT_EQ(sources.FileAt(sources.WholeFile(empty).begin), empty);
  EXPECT_EQ(sources.FileAt(sources.WholeFile(last).begin), last);
  EXPECT_EQ(sources.Text(sources.WholeFile(last)), "c");
}

TEST(Places, ManyFiles) {
  SourceManager sources;
  for (int i = 0; i < 1000; ++i) sources.AddText("file", "0123456789");
  for (uint32_t i = 0; i < 1000; ++i) {
    const FileId file(i);
    EXPECT_EQ(sources.FileAt(sources.Get(file).base + 5), file);
    EXPECT_EQ(sources.FileAt(sources.Get(file).base + 10), file);
  }
}

void ExpectLines(std::string_view bytes, LineEnds ends, std::vector<std::string> lines) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", bytes, {.line_ends = ends}));
  ASSERT_EQ(sources.LineCount(file), lines.size());
  for (uint32_t i = 0; i < lines.size(); ++i) EXPECT_EQ(sources.Line(file, i + 1), lines[i]) << "line " << i + 1;
}

TEST(Lines, EveryCrAndLfIsReadLongestFirst) {
  ExpectLines("a\nb\r\nc\n\rd\re", LineEnds::kEveryCrAndLf, {"a", "b", "c", "d", "e"});
  ExpectLines("a\r\n\rb\n\r\nc\n\nd", LineEnds::kEveryCrAndLf, {"a", "", "b", "", "c", "", "d"});
  ExpectLines("a\n\rb", LineEnds::kLfCrLfOrCr, {"a", "", "b"});
}

TEST(Lines, ALoneCrMayBeACharacter) { ExpectLines("a\rb\r\nc\n\rd\r", LineEnds::kLfOrCrLf, {"a\rb", "c", "\rd\r"}); }

TEST(Lines, WithoutTheirEnds) {
  SourceManager sources;
  const FileId file = sources.AddText("a.plc", "a\r\n\rb\n");
  EXPECT_EQ(sources.LineCount(file), 3u);
  EXPECT_EQ(sources.Line(file, 1), "a");
  EXPECT_EQ(sources.Line(file, 2), "");
  EXPECT_EQ(sources.Line(file, 3), "b");
  EXPECT_EQ(sources.Line(file, 4), "");
  EXPECT_EQ(sources.Line(file, 0), "");
  EXPECT_EQ(sources.Line(file, 99), "");
}

TEST(Lines, CountedAsAPersonDoes) {
  SourceManager sources;
  EXPECT_EQ(sources.LineCount(sources.AddText("a", "")), 0u);
  EXPECT_EQ(sources.LineCount(sources.AddText("b", "x")), 1u);
  EXPECT_EQ(sources.LineCount(sources.AddText("c", "x\n")), 1u);
  EXPECT_EQ(sources.LineCount(sources.AddText("d", "x\n\n")), 2u);
}

TEST(OriginalBytes, Utf8CountsTheBom) {
  SourceManager sources;
  const FileId file = Loaded(sources.AddBytes("a.plc", "\xEF\xBB\xBFЖx", {}));
  const Offset base = sources.Get(file).base;
  EXPECT_EQ(sources.OriginalByte(base), 3u);
  EXPECT_EQ(sources.OriginalByte(base + 2), 5u);
  EXPECT_EQ(sources.OriginalByte(base + 3), 6u);
}

TEST(OriginalBytes, EightBitCountsCharacters) {
  for (const Encoding encoding : {Encoding::kCp866, Encoding::kCp1251, Encoding::kKoi8R}) {
    SourceManager sources;
    const std::string bytes = Encoded(";Насос\r\n;СОЖ x", encoding);
    const FileId file = Loaded(sources.AddBytes("a.plc", bytes, {.encoding = encoding}));
    const File& loaded = sources.Get(file);
    const auto at = [&](std::string_view what) {
      return sources.OriginalByte(loaded.base + static_cast<Offset>(loaded.text.find(what)));
    };
    EXPECT_EQ(at(";"), 0u);
    EXPECT_EQ(at("сос"), 3u);
    EXPECT_EQ(at("\r"), 6u);
    EXPECT_EQ(at("\n"), 7u);
    EXPECT_EQ(at(";С"), 8u);
    EXPECT_EQ(at("x"), 13u);
    EXPECT_EQ(sources.OriginalByte(sources.WholeFile(file).end), bytes.size());
  }
}

TEST(OriginalBytes, Gb18030CountsWhatACharacterTook) {
  SourceManager sources;
  // The last character took four bytes, the broken one stood for one.
  const std::string_view bytes = ";\xC0\xE4\xC8\xB4\r\n;\xB1\xC3\xFF \x81\x30\x81\x30 x";
  const LoadOptions options{.detection = Detection::kFallback, .fallback = Encoding::kGb18030};
  const FileId file = Loaded(sources.AddBytes("a.il", bytes, options));
  const File& loaded = sources.Get(file);
  EXPECT_EQ(loaded.text, ";冷却\r\n;泵\uFFFD \u0080 x");
  const auto at = [&](std::string_view what) {
    return sources.OriginalByte(loaded.base + static_cast<Offset>(loaded.text.find(what)));
  };
  EXPECT_EQ(at("却"), 3u);
  EXPECT_EQ(at("\r"), 5u);
  EXPECT_EQ(at("\uFFFD"), 10u);
  EXPECT_EQ(at("\u0080"), 12u);
  EXPECT_EQ(at("x"), 17u);
  EXPECT_EQ(sources.OriginalByte(sources.WholeFile(file).end), bytes.size());
}

TEST(OriginalBytes, ReplacedBytesCountOnce) {
  SourceManager sources;
  // A real U+FFFD keeps its three bytes; a bad byte becomes one, but was a single byte.
  const FileId file = Loaded(sources.AddBytes("a.plc", "\xFF\xEF\xBF\xBD\xFFx", {.encoding = Encoding::kUtf8}));
  const File& loaded = sources.Get(file);
  EXPECT_EQ(loaded.text, "\uFFFD\uFFFD\uFFFDx");
  EXPECT_EQ(loaded.replaced.size(), 2u);
  EXPECT_EQ(sources.OriginalByte(loaded.base + 3), 1u);
  EXPECT_EQ(sources.OriginalByte(loaded.base + 6), 4u);
  EXPECT_EQ(sources.OriginalByte(loaded.base + 9), 5u);
}

}  // namespace
}  // namespace plcxx::source
