// The parts of the driver that are functions of their arguments alone.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/compilation/dialect_choice.h"
#include "transpiler/compilation/warning_options.h"
#include "transpiler/driver/dependency_file.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/sim_plan.h"

namespace plcxx::driver {
namespace {

using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

TEST(DependencyRule, EscapesAsMakeWants) {
  EXPECT_EQ(DependencyRule({"out/a.cpp"}, {"a b", "c#d", "e$f", "g\\ h"}),
            "out/a.cpp: \\\n  a\\ b \\\n  c\\#d \\\n  e$$f \\\n  g\\\\\\ h\n");
  EXPECT_EQ(DependencyRule({"a", "b"}, {}), "a b:\n");
}

TEST(Warnings, LastWordWins) {
  std::vector<std::string> unknown;
  const diag::WarningOptions options = compilation::ReadWarningOptions(
      {"no-W303", "W303", "W370", "no-nc110-W370", "error=W356", "no-error=W356", "error=W357"}, unknown);
  EXPECT_THAT(unknown, ::testing::IsEmpty());
  EXPECT_THAT(options.enabled, UnorderedElementsAre("W303", "W370", "W356", "W357"));
  EXPECT_THAT(options.disabled, UnorderedElementsAre("nc110-W370"));
  EXPECT_THAT(options.errors, UnorderedElementsAre("W357"));
  EXPECT_FALSE(options.all_errors);
}

TEST(Warnings, ErrorsAreNoWarnings) {
  std::vector<std::string> unknown;
  compilation::ReadWarningOptions({"41", "no-nc110-41", "error=foo", "error"}, unknown);
  EXPECT_THAT(unknown, ElementsAre("-W41", "-Wno-nc110-41", "-Werror=foo"));
}

TEST(FileNames, StayInTheirDirectory) {
  for (const char* name : {"mill", "MILL_2", "a-b.c", "9"}) EXPECT_TRUE(IsFileName(name)) << name;
  for (const char* name : {"", ".", "..", ".a", "a/b", "-o", "a b", "a\nb", "\xD1\x84"})
    EXPECT_FALSE(IsFileName(name)) << name;
}

TEST(Durations, NeedAUnit) {
  EXPECT_EQ(ParseDuration("3s"), 3000u);
  EXPECT_EQ(ParseDuration("100ms"), 100u);
  EXPECT_EQ(ParseDuration("2min"), 120'000u);
  for (const char* text : {"", "3", "s", "-3s", "3 s", "3h", "99999999999s", "1.5s"}) {
    EXPECT_EQ(ParseDuration(text), std::nullopt) << text;
  }
}

TEST(Dialects, ExtensionThenContent) {
  const auto peek = [](const std::string& path) -> std::string {
    return path.starts_with("program") ? "U4A0=I0A0*/I0A1\n$\n" : "good morning\n";
  };
  const dialects::Dialect* nc110 = dialects::DialectByName("nc110");
  EXPECT_EQ(compilation::ChooseDialect("nc110", {"x"}, peek), nc110);
  EXPECT_EQ(compilation::ChooseDialect("cobol", {"x.plc"}, peek), nullptr);
  EXPECT_EQ(compilation::ChooseDialect("", {"x.SYM"}, peek), nc110);
  EXPECT_EQ(compilation::ChooseDialect("", {"program.PLC"}, peek), nc110)
      << "two dialects use .plc: the content decides";
  EXPECT_EQ(compilation::ChooseDialect("", {"x.plc"}, peek), nullptr);
  EXPECT_EQ(compilation::ChooseDialect("", {"letter", "program"}, peek), nc110);
  EXPECT_EQ(compilation::ChooseDialect("", {"letter"}, peek), nullptr);
}

TEST(WriteAll, LeavesNothingBehindAfterAFailure) {
  const testing_support::TemporaryDirectory directory;
  const std::string in_the_way = directory.File("b");
  std::filesystem::create_directory(in_the_way);
  const auto failure = WriteAll({"", {{directory.File("a"), "text"}, {in_the_way, "text"}}, {}});
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->path, in_the_way);
  EXPECT_FALSE(std::filesystem::exists(directory.File("a")));
}

std::string TextOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(WriteAll, WritesThroughLinks) {
  const testing_support::TemporaryDirectory directory;
  const std::string file = directory.File("file"), link = directory.File("link");
  ASSERT_FALSE(WriteAll({"", {{file, "old"}}, {}}).has_value());
  std::filesystem::create_symlink(file, link);
  ASSERT_FALSE(WriteAll({"", {{link, "new"}}, {}}).has_value());
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(TextOf(file), "new");
}

// With `--junit /dev/full`, as root, the device was a file from then on. A pipe stands for it here.
TEST(WriteAll, WritesToWhatIsNoFile) {
  const testing_support::TemporaryDirectory directory;
  const std::string pipe = directory.File("pipe"), link = directory.File("link");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink(pipe, link);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_FALSE(WriteAll({"", {{link, "text"}}, {}}).has_value());
  char text[8] = {};
  EXPECT_EQ(read(reader, text, sizeof text), 4);
  EXPECT_STREQ(text, "text");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  close(reader);
}

TEST(WriteAll, WritesNothingWhereWhatIsNoFileRefuses) {
  const testing_support::TemporaryDirectory directory;
  const std::string file = directory.File("file"), name = directory.File("socket");
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  ASSERT_LT(name.size(), sizeof address.sun_path);
  name.copy(address.sun_path, name.size());
  const int listening = socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind(listening, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const auto failure = WriteAll({"", {{file, "text"}, {name, "text"}}, {}});
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->path, name);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_TRUE(std::filesystem::is_socket(name));
  close(listening);
}

TEST(Compile, StopsWhereItIsToldTo) {
  const testing_support::TemporaryDirectory directory;
  compilation::CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.plc"};
  directory.Write("main.plc", "U4A0=I0A0\n$\n");
  for (const compilation::Stage stage :
       {compilation::Stage::kLoaded, compilation::Stage::kLowered, compilation::Stage::kStructured,
        compilation::Stage::kChecked, compilation::Stage::kOptimized}) {
    const compilation::Compilation compilation = compilation::Compile(request, stage);
    EXPECT_TRUE(compilation.ok());
    EXPECT_EQ(compilation.reached, stage);
  }
  directory.Write("main.plc", "U4A0=I0A\n$\n");
  const compilation::Compilation bad = compilation::Compile(request);
  EXPECT_FALSE(bad.ok());
  EXPECT_FALSE(bad.wrong_use);
  EXPECT_EQ(bad.reached, compilation::Stage::kLoaded);
}

// covers: NC110-209
TEST(Compile, SlicesByCost) {
  const testing_support::TemporaryDirectory directory;
  std::string program = "$\n";
  for (int i = 0; i < 30'000; ++i) {
    program += "U" + std::to_string(100 + i / 32 % 100) + "K" + std::to_string(i % 32) + "=I0A0*I0A1+I0A2*/I0A3\n";
  }
  directory.Write("main.plc", program);
  compilation::CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.plc"};
  request.options = {{"slices", "auto"}, {"clo", "10,1"}};
  const compilation::Compilation compilation = compilation::Compile(request);
  ASSERT_TRUE(compilation.ok());
  EXPECT_GT(compilation.estimates.slices, 1u);
  EXPECT_EQ(compilation.estimates.slow_period_ms, 10 * compilation.estimates.slices);
}

// The period of this dialect is the FAST one: SLOW comes in every n-th.
TEST(Compile, SlowPartInEveryNthPeriodHasNoPeriodInSlices) {
  const testing_support::TemporaryDirectory directory;
  directory.Write("main.il", "SLOWDIV 8\nSLOW\nNETWORK\nLD %I0\nOUT %Q0\nEND_SLOW\n");
  compilation::CompilationRequest request;
  request.base_directory = directory.path().string();
  request.sources = {"main.il"};
  const compilation::Compilation compilation = compilation::Compile(request);
  ASSERT_TRUE(compilation.ok());
  EXPECT_EQ(compilation.estimates.slow_period_ms, 0u);
}

}  // namespace
}  // namespace plcxx::driver
