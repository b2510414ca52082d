#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>

#include "tests/source/loading.h"
#include "tests/temporary_directory.h"
#include "transpiler/source/source.h"

namespace plcxx::source {
namespace {

class Loading : public testing::Test {
 protected:
  std::string Path(const std::string& name) const { return (directory_ / name).string(); }
  std::string Write(const std::string& name, std::string_view bytes) const {
    std::ofstream(Path(name), std::ios::binary) << bytes;
    return Path(name);
  }
  const File& Text(std::string_view bytes, const LoadOptions& options = {}) {
    return sources_.Get(Loaded(sources_.AddBytes("a.plc", bytes, options)));
  }
  LoadError Error(std::string_view bytes, const LoadOptions& options = {}) {
    return Refused(sources_.AddBytes("a.plc", bytes, options));
  }

  const testing_support::TemporaryDirectory temporary_;
  const std::filesystem::path directory_ = temporary_.path();
  SourceManager sources_;
};

TEST_F(Loading, AFile) {
  const std::string path = Write("a.plc", "U4A0=I0A1\r\n");
  const File& file = sources_.Get(Loaded(sources_.Load(path, {})));
  EXPECT_EQ(file.path, path);
  EXPECT_EQ(file.text, "U4A0=I0A1\r\n");
  EXPECT_EQ(file.encoding, Encoding::kUtf8);
  EXPECT_FALSE(file.had_bom);
}

TEST_F(Loading, AMissingFile) {
  EXPECT_EQ(Refused(sources_.Load(Path("nothing.plc"), {})).problem, LoadProblem::kMissing);
  const std::string file = Write("a.plc", "x");
  EXPECT_EQ(Refused(sources_.Load(file + "/b.plc", {})).problem, LoadProblem::kMissing);
  EXPECT_EQ(Refused(sources_.Load("", {})).problem, LoadProblem::kMissing);
}

TEST_F(Loading, ADirectory) {
  const LoadError error = Refused(sources_.Load(directory_.string(), {}));
  EXPECT_EQ(error.problem, LoadProblem::kDirectory);
  EXPECT_FALSE(error.detail.empty());
}

TEST_F(Loading, AnUnreadableFile) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser reads everything";
  const std::string path = Write("a.plc", "x");
  chmod(path.c_str(), 0);
  const LoadError error = Refused(sources_.Load(path, {}));
  EXPECT_EQ(error.problem, LoadProblem::kUnreadable);
  EXPECT_EQ(error.detail, "permission denied");
}

TEST_F(Loading, ANameTooLongForTheSystem) {
  EXPECT_EQ(Refused(sources_.Load(std::string(5000, 'a'), {})).problem, LoadProblem::kUnreadable);
}

TEST_F(Loading, AHugeFileIsRefusedUnread) {
  const std::string path = Write("huge.plc", "");
  std::filesystem::resize_file(path, 100u << 20);  // full of NUL bytes: reading it would say kBinary
  const LoadError error = Refused(sources_.Load(path, {}));
  EXPECT_EQ(error.problem, LoadProblem::kTooLarge);
  EXPECT_EQ(error.detail, "it is larger than 67108864 bytes");
}

TEST_F(Loading, AFileWithoutSizeIsReadUpToTheLimit) {
  EXPECT_EQ(Refused(sources_.Load("/proc/version", {.max_bytes = 10})).problem, LoadProblem::kTooLarge);
}

// To open a pipe may last for ever, and a device may have no end.
TEST_F(Loading, WhatIsNoFileIsRefusedUnopened) {
  const LoadError error = Refused(sources_.Load("/dev/zero", {}));
  EXPECT_EQ(error.problem, LoadProblem::kNoFile);
  EXPECT_EQ(error.detail, "it is no file, but a device");
  EXPECT_EQ(Refused(sources_.Load("/dev/null", {})).problem, LoadProblem::kNoFile);
}

TEST_F(Loading, ExactlyAtTheLimit) {
  const std::string path = Write("a.plc", "12345");
  Loaded(sources_.Load(path, {.max_bytes = 5}));
  EXPECT_EQ(Refused(sources_.Load(path, {.max_bytes = 4})).problem, LoadProblem::kTooLarge);
  EXPECT_EQ(Error("12345", {.max_bytes = 4}).problem, LoadProblem::kTooLarge);
}

TEST_F(Loading, AnEmptyFile) { EXPECT_EQ(Refused(sources_.Load(Write("a.plc", ""), {})).problem, LoadProblem::kEmpty); }

TEST_F(Loading, NulBytesAreNoText) {
  const LoadError error = Error(std::string_view("a\nb\r\nc\0d", 8));
  EXPECT_EQ(error.problem, LoadProblem::kBinary);
  EXPECT_EQ(error.line, 3u);
}

TEST_F(Loading, Utf16IsNamed) {
  const LoadError error = Error(std::string_view("\xFF\xFEU\0", 4));
  EXPECT_EQ(error.problem, LoadProblem::kUtf16);
  EXPECT_NE(error.detail.find("UTF-16"), std::string::npos);
}

// One remedy for two causes would be wrong for one of them; what is too large as a whole or in a line is not the file.
TEST_F(Loading, EachCauseHasItsRemedy) {
  std::set<std::string_view> remedies;
  for (const LoadProblem problem :
       {LoadProblem::kMissing, LoadProblem::kDirectory, LoadProblem::kNoFile, LoadProblem::kUnreadable,
        LoadProblem::kTooLarge, LoadProblem::kBinary, LoadProblem::kUtf16, LoadProblem::kCutOff, LoadProblem::kEmpty})
    EXPECT_TRUE(remedies.insert(RemedyOf(problem)).second) << RemedyOf(problem);
  EXPECT_FALSE(remedies.contains(""));
  EXPECT_EQ(RemedyOf(LoadProblem::kLineTooLong), RemedyOf(LoadProblem::kTooLarge));
}

TEST_F(Loading, ALongLine) {
  const LoadError error = Error("ab\nabcdef\n", {.max_line_bytes = 5});
  EXPECT_EQ(error.problem, LoadProblem::kLineTooLong);
  EXPECT_EQ(error.line, 2u);
  EXPECT_EQ(error.detail, "line 2 is longer than 5 bytes");
  Text("abcde\r\nabcde\rabcde", {.max_line_bytes = 5});
}

TEST_F(Loading, TheEndMarkEndsTheText) {
  // NUL bytes and long lines behind it are of no interest: DOS filled its blocks up with what was in memory.
  const std::string_view bytes("x=1\n\x1A\0\0\xFFqqqqqqqqqqqq", 20);
  EXPECT_EQ(Text(bytes, {.max_line_bytes = 5}).text, "x=1\n");
  EXPECT_EQ(Text("\x1A").text, "");
  EXPECT_EQ(Text("a\x1Az", {.end_marks = ""}).text, "a\x1Az");
}

TEST_F(Loading, EndMarksOfADialect) {
  const LoadOptions options{.end_marks = "\x03\x1A"};
  EXPECT_EQ(Text("a\x03"
                 "b\x1A",
                 options)
                .text,
            "a");
  EXPECT_EQ(Text("a\x1A\x03", options).text, "a");
  EXPECT_EQ(Text("a\x03z").text, "a\x03z");
}

TEST_F(Loading, TextBehindTheEndMarkIsCounted) {
  EXPECT_EQ(Text("x=1\n\x1A\ny=2").unread_bytes, 4u);
  EXPECT_EQ(Text("\x1A;\x1A\x1A").unread_bytes, 1u) << "to the last byte of text, not to the filling behind it";
  EXPECT_EQ(Text(std::string_view("x=1\x1A\x1A\0\r\n\t \f\v\x1A", 12)).unread_bytes, 0u);
  EXPECT_EQ(Text("x=1\n").unread_bytes, 0u);
  EXPECT_EQ(Text("x=1\x1A").unread_bytes, 0u);
  EXPECT_EQ(Text("\xEF\xBB\xBF\x1Ay").unread_bytes, 1u);
  EXPECT_EQ(Text("x\x1Ay", {.end_marks = ""}).unread_bytes, 0u);
  EXPECT_EQ(Text("x\x03y", {.end_marks = "\x03\x1A"}).unread_bytes, 1u);
  EXPECT_EQ(Text("x\x1Ay", {.text_behind_end = TextBehindEnd::kIsNothing}).unread_bytes, 0u);
}

TEST_F(Loading, TheEndMarkComesBeforeTheEncoding) {
  // Cyrillic behind the mark would otherwise make the UTF-8 in front of it CP866.
  EXPECT_EQ(Text(";Насос\n\x1A" + Encoded("Смазка", Encoding::kCp866)).encoding, Encoding::kUtf8);
}

TEST_F(Loading, TheBomIsNoText) {
  const File& file = Text("\xEF\xBB\xBFx=1");
  EXPECT_EQ(file.text, "x=1");
  EXPECT_TRUE(file.had_bom);
  EXPECT_EQ(Text("\xEF\xBB\xBF").text, "");
}

TEST_F(Loading, ABomIsTheAuthorsWord) {
  const File& file = Text("\xEF\xBB\xBFx\xFF");
  EXPECT_EQ(file.encoding, Encoding::kUtf8);
  EXPECT_EQ(file.text, "x\uFFFD");
}

TEST_F(Loading, StandardInput) {
  const std::string path = Write("input", "x=1\n");
  // The stream itself: a replaced descriptor below it is what a shell's '<' is.
  ASSERT_NE(std::freopen(path.c_str(), "r", stdin), nullptr);
  const File& file = sources_.Get(Loaded(sources_.Load("-", {})));
  EXPECT_EQ(file.path, "<stdin>");
  EXPECT_EQ(file.text, "x=1\n");
}

TEST_F(Loading, StandardInputIsBounded) {
  ASSERT_NE(std::freopen("/dev/zero", "r", stdin), nullptr);
  EXPECT_EQ(Refused(sources_.Load("-", {.max_bytes = 100000})).problem, LoadProblem::kTooLarge);
}

TEST_F(Loading, TimeGrowsAsTheText) {
  // Processor time, the least of some runs: other work of the machine does not count.
  const auto milliseconds_for = [&](size_t size) {
    std::string bytes;
    while (bytes.size() < size) bytes += "U4A8=[W3K0=33H]+U4A8*/I0A7*/T5U ;turret\r\n";
    const std::string path = Write("big.plc", bytes);
    double least = 1e9;
    for (int run = 0; run < 5; ++run) {
      const std::clock_t begin = std::clock();
      const FileId file = Loaded(sources_.Load(path, {}));
      least = std::min(least, 1000.0 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
      EXPECT_EQ(sources_.Get(file).text.size(), bytes.size());
    }
    return least;
  };
  constexpr size_t kMegabyte = 1U << 20;
  const double one = milliseconds_for(kMegabyte), ten = milliseconds_for(10 * kMegabyte);
  EXPECT_LT(ten, 30 * one) << "ten times the text: " << ten << " ms, " << one << " ms";
}

}  // namespace
}  // namespace plcxx::source
