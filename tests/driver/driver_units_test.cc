// The parts of the driver that are functions of their arguments alone.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "tests/temporary_directory.h"
#include "transpiler/driver/dependency_file.h"
#include "transpiler/driver/output_files.h"
#include "transpiler/driver/sim_plan.h"

namespace plcxx::driver {
namespace {

TEST(DependencyRule, EscapesAsMakeWants) {
  EXPECT_EQ(DependencyRule({"out/a.cpp"}, {"a b", "c#d", "e$f", "g\\ h"}),
            "out/a.cpp: \\\n  a\\ b \\\n  c\\#d \\\n  e$$f \\\n  g\\\\\\ h\n");
  EXPECT_EQ(DependencyRule({"a", "b"}, {}), "a b:\n");
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

TEST(WriteAll, LeavesNothingBehindAfterAFailure) {
  const testing_support::TemporaryDirectory directory;
  const std::string in_the_way = directory.File("b");
  std::filesystem::create_directory(in_the_way);
  const auto failure = WriteAll({"", {{directory.File("a"), "text"}, {in_the_way, "text"}}, {}});
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->path, in_the_way);
  EXPECT_FALSE(std::filesystem::exists(directory.File("a")));
}

TEST(WriteAll, EachFailureHasARemedyOfItsOwn) {
  const testing_support::TemporaryDirectory directory;
  const std::string folder = directory.File("folder"), file = directory.File("file");
  std::filesystem::create_directory(folder);
  std::ofstream(file) << "text";
  const auto remedy = [](const std::string& path, std::vector<std::string> sources = {}) {
    const auto failure = WriteAll({"", {{path, "other"}}, std::move(sources), {path}});
    return failure ? failure->reason + ": " + failure->remedy : "";
  };
  EXPECT_EQ(remedy(folder), "it is a directory: choose another name for the file, or move the directory away");
  EXPECT_EQ(remedy(file, {file}), "it is a source of this program: write to another folder, or under another name");
  EXPECT_EQ(remedy(file + "/below"), "not a directory: a file is where the path needs a folder: check the path");
  EXPECT_EQ(remedy(folder + "/missing/x"),
            "no such file or directory: check its name, and make the folder that it is to lie in");
  EXPECT_EQ(remedy(directory.File(std::string(300, 'x'))), "file name too long: choose a shorter name");
  EXPECT_EQ(remedy("/dev/full"), "no space left on device: make room there, or write to another disk");
}

TEST(WriteAll, TwoResultsHaveTwoNames) {
  const testing_support::TemporaryDirectory directory;
  const auto failure = WriteAll({"", {{directory.File("x"), "one"}, {directory.File("./x"), "two"}}, {}});
  ASSERT_TRUE(failure.has_value());
  EXPECT_EQ(failure->reason, "it is named for two results");
  EXPECT_FALSE(std::filesystem::exists(directory.File("x")));
  EXPECT_FALSE(WriteAll({"", {{"/dev/null", "one"}, {"/dev/null", "two"}}, {}}).has_value());
}

TEST(CannotBeWritten, IsKnownBeforeTheWork) {
  const testing_support::TemporaryDirectory directory;
  const std::string folder = directory.File("folder"), file = directory.File("file");
  std::filesystem::create_directory(folder);
  std::ofstream(file) << "text";
  const auto reason = [](const std::string& path) {
    const auto failure = CannotBeWritten(path);
    return failure ? failure->reason : "";
  };
  for (const std::string& right : {file, folder + "/x", folder + "/missing/deep/x", std::string("/dev/null")})
    EXPECT_EQ(reason(right), "") << right;
  EXPECT_EQ(reason("x.vcd"), "");
  EXPECT_EQ(reason(folder), "it is a directory");
  EXPECT_EQ(reason(file + "/x"), "not a directory");
  EXPECT_EQ(reason(file + "/deep/x"), "not a directory");
  if (geteuid() != 0) {
    std::filesystem::permissions(folder, std::filesystem::perms::owner_read);
    EXPECT_EQ(reason(folder + "/x"), "permission denied");
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
  }
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
  ASSERT_FALSE(WriteAll({"", {{link, "new"}}, {}, {link}}).has_value());
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

// covers: NC110-209
// The period of this dialect is the FAST one: SLOW comes in every n-th.
}  // namespace
}  // namespace plcxx::driver
