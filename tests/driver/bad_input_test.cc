// Files that are no program: a clear error each, nothing written, no crash, no hang, memory bounded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Emits and expects a refusal in these words, and that nothing was written.
void ExpectRefused(const Workplace& work, const std::string& arguments, const std::string& words, int code = 1) {
  const Ran ran = work.Run("emit " + arguments + " -o out");
  EXPECT_EQ(ran.code, code) << arguments << "\n" << ran;
  EXPECT_THAT(ran.errors, HasSubstr("error")) << arguments;
  EXPECT_THAT(ran.errors, HasSubstr(words)) << arguments;
  EXPECT_FALSE(work.Has("out")) << arguments;
  EXPECT_THAT(ran.out, IsEmpty()) << arguments;
}

TEST(BadInput, Empty) {
  const Workplace work;
  work.Write("empty.plc", "");
  work.Write("empty", "");
  ExpectRefused(work, "empty.plc", "empty");
  ExpectRefused(work, "empty", "empty");
  ExpectRefused(work, "- --dialect nc110", "empty");
}

TEST(BadInput, Binary) {
  const Workplace work;
  std::string bytes;
  for (int i = 0; i < 4096; ++i) bytes += static_cast<char>(i * 37 % 256);
  work.Write("binary.plc", bytes);
  ExpectRefused(work, "binary.plc", "no text");
}

TEST(BadInput, MissingOrDirectory) {
  const Workplace work;
  std::filesystem::create_directory(work.Path("folder.plc"));
  ExpectRefused(work, "missing.plc", "cannot read");
  ExpectRefused(work, "missing", "cannot read");
  ExpectRefused(work, "folder.plc", "directory");
  ExpectRefused(work, ".", "directory");
}

// To open a pipe may last for ever, and a device may have no end.
TEST(BadInput, WhatIsNoFile) {
  const Workplace work;
  ASSERT_EQ(mkfifo(work.Path("pipe.plc").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(work.Path("pipe.yaml").c_str(), 0600), 0);
  ASSERT_EQ(mkfifo(work.Path("pipe").c_str(), 0600), 0);
  work.Write("main.plc", kGoodProgram);
  ExpectRefused(work, "pipe.plc", "cannot read source 'pipe.plc': it is no file, but a pipe");
  ExpectRefused(work, "/dev/zero --dialect nc110", "cannot read source '/dev/zero': it is no file, but a device");
  ExpectRefused(work, "main.plc --set messages=pipe", "it is no file, but a pipe");
  for (const std::string command :
       {"prove main.plc --property pipe", "prove main.plc --property /dev/zero", "test pipe.yaml",
        "check --project pipe.yaml", "sim main.plc --for 1s --plant pipe.yaml", "why U4A0 main.plc --vcd pipe",
        "why U4A0 main.plc --scenario pipe.yaml", "verify main.plc --object pipe", "identify pipe",
        "check main.plc --baseline pipe"}) {
    const Ran ran = work.Run(command);
    EXPECT_EQ(ran.code, 2) << command << "\n" << ran;
    EXPECT_THAT(ran.errors, ::testing::ContainsRegex("but a (pipe|device)")) << command;
  }
}

/// A shell gives the name of a descriptor for <(...), and that is a pipe with a writer.
TEST(BadInput, APipeThatTheShellHasOpenedIsRead) {
  const Workplace work;
  work.Write("main.plc", kGoodProgram);
  work.Write("wrong.plc", kBadProgram);
  for (const std::string name : {"/dev/fd/0", "/proc/self/fd/0"}) {
    const auto code = [&](const std::string& file) {
      const int status = std::system(
          ("cat '" + work.Path(file) + "' | " PLCXX_BINARY " check --dialect nc110 " + name + " >/dev/null 2>&1")
              .c_str());
      return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    };
    EXPECT_EQ(code("main.plc"), 0) << name;
    EXPECT_EQ(code("wrong.plc"), 1) << name;
  }
}

// The remedy is that of the cause, in the words of every dialect.
TEST(BadInput, EachCauseHasItsRemedy) {
  const Workplace work;
  std::filesystem::create_directory(work.Path("folder.x"));
  work.Write("empty.x", "");
  work.Write("utf16.x", std::string("\xFF\xFEI\0", 4));
  work.Write("object.x", std::string("a\0b", 3));
  const struct {
    const char *source, *remedy;
  } cases[] = {{"missing.x", "help: check its name"},
               {"folder.x", "help: name the files in it; 'plcxx init' makes a project"},
               {"empty.x", "help: copy it again from the control"},
               {"utf16.x", "help: save it as UTF-8, as 'iconv -f UTF-16 -t UTF-8' does"},
               {"object.x", "help: name the file with the text of the program"}};
  for (const char* dialect : {"", "classicladder", "hnc", "host50", "nc110", "prostep", "technol"}) {
    const std::string chosen = *dialect == '\0' ? "" : " --dialect " + std::string(dialect);
    for (const auto& [source, remedy] : cases) {
      // In technol an empty file is one of several that make a program: what it lacks is said as of any other.
      if (std::string_view(dialect) == "technol" && std::string_view(source) == "empty.x") continue;
      EXPECT_THAT(work.Run("check " + std::string(source) + chosen).errors, HasSubstr(remedy)) << source << chosen;
    }
  }
  // What was cut off is seen where the program comes through a pipe or is not yet saved, too.
  EXPECT_THAT(work.Run("check - --dialect nc110", "; \xD0\x96\xD0").errors, HasSubstr("help: copy it again, its end"));
}

// Nobody wrote --git: what is missing is said, and what to write instead.
TEST(BadInput, ADiffWithoutARepository) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  EXPECT_EQ(work.Run("init").code, 0);
  const Ran ran = work.Run("diff", "", "GIT_CEILING_DIRECTORIES='" + work.Path("..") + "'");
  EXPECT_EQ(ran.code, 2) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("git has no version here ("));
  EXPECT_THAT(ran.errors, HasSubstr("): name both, as in 'plcxx diff OLD NEW'"));
}

TEST(BadInput, Unreadable) {
  if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
  const Workplace work;
  work.Write("closed.plc", kGoodProgram);
  std::filesystem::permissions(work.Path("closed.plc"), std::filesystem::perms::none);
  ExpectRefused(work, "closed.plc", "cannot read");
}

TEST(BadInput, TooLarge) {
  const Workplace work;
  work.Write("large.plc", "");
  std::filesystem::resize_file(work.Path("large.plc"), 100u << 20);  // sparse
  ExpectRefused(work, "large.plc --dialect nc110", "too long");
}

TEST(BadInput, LongLine) {
  const Workplace work;
  std::string line = "U4A0=I0A0";
  while (line.size() < (1u << 20)) line += "+I0A1";
  work.Write("line.plc", line + "\n");
  ExpectRefused(work, "line.plc --dialect nc110", "too long");
}

TEST(BadInput, NestedBrackets) {
  const Workplace work;
  constexpr size_t kDepth = 10'000;
  work.Write("round.plc", "U4A0=" + std::string(kDepth, '(') + "I0A0" + std::string(kDepth, ')') + "\n$\n");
  work.Write("square.plc", "W4A0=" + std::string(kDepth, '[') + "W0A0" + std::string(kDepth, ']') + "\n$\n");
  work.Write("open.plc", "U4A0=" + std::string(kDepth, '(') + "\n$\n");
  std::string blocks;
  for (size_t i = 0; i < kDepth; ++i) blocks += "DOF:I0A0\n";
  work.Write("blocks.plc", blocks);
  ExpectRefused(work, "round.plc", "parenthes");
  ExpectRefused(work, "square.plc", "error");
  ExpectRefused(work, "open.plc", "parenthes");
  ExpectRefused(work, "blocks.plc", "nesting");
}

TEST(BadInput, UnknownEncoding) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  ExpectRefused(work, "ok.plc --encoding ebcdic", "cp866", 2);
}

TEST(BadInput, CutOffUtf8) {
  const Workplace work;
  const std::string whole = "U4A0=I0A0 ; \xD0\xB4\xD0\xB0";
  work.Write("cut.plc", whole.substr(0, whole.size() - 1));
  work.Write("single.plc", "U4A0=I0A0 ; \xE2\x82");
  ExpectRefused(work, "cut.plc", "UTF-8");
  ExpectRefused(work, "cut.plc --encoding utf-8", "UTF-8");
  ExpectRefused(work, "single.plc", "UTF-8");
  EXPECT_EQ(work.Run("check cut.plc --encoding cp866").code, 0);
}

// "; +24 V" with a Cyrillic letter at the end of the last line: one byte above 7FH is no UTF-8 that was cut off.
TEST(BadInput, OneLastLetterIsOfAnEightBitEncoding) {
  const Workplace work;
  work.Write("volt.plc", "U4A0=I0A0 ; +24 \xC2");
  work.Write("last.plc", "U4A0=I0A0 ; \xFF");
  for (const char* file : {"volt.plc", "last.plc"}) {
    EXPECT_EQ(work.Run(std::string("check --dialect nc110 ") + file).code, 0) << file;
    EXPECT_EQ(work.Run(std::string("check --encoding cp1251 ") + file).code, 0) << file;
  }
  ExpectRefused(work, "volt.plc --encoding utf-8", "UTF-8");
}

TEST(BadInput, UndefinedBytesAreNamed) {
  const Workplace work;
  work.Write("mixed.plc", "U4A0=I0A0 ; \xFF caf\xE9 \n$\n");
  const Ran ran = work.Run("check mixed.plc --encoding utf-8");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors, HasSubstr("plcxx-6"));
}

// DOS ends a text with 1AH and fills up what is left of its block; more than that is lost text.
TEST(BadInput, TextBehindTheEndMarkIsNamed) {
  const Workplace work;
  const std::string program = "$\nU4A0=I0A0\n;\x1A comment\nU4A1=I0A1 +\n";
  work.Write("lost.plc", program);
  const Ran ran = work.Run("check --dialect nc110 lost.plc");
  EXPECT_EQ(ran.code, 0) << ran;
  EXPECT_THAT(ran.errors,
              HasSubstr("lost.plc:3:2: warning: 'lost.plc' ends here, with a byte 1AH (Ctrl-Z); the 20 bytes"));
  EXPECT_EQ(work.Run("check --dialect nc110 lost.plc -Werror=plcxx-26").code, 1);
  EXPECT_THAT(work.Run("check --dialect nc110 lost.plc -Wno-plcxx-26").errors, Not(HasSubstr("1AH")));
  work.Write("filled.plc", "$\nU4A0=I0A0\n\x1A\x1A" + std::string(60, '\0'));
  EXPECT_THAT(work.Run("check --dialect nc110 filled.plc").errors, Not(HasSubstr("1AH")));
  work.Write("t.plc", "$\nU4A0=I0A0\n");
  work.Write("H", "I0A0 START\n\x1A\nI0A1 STOP\n");
  EXPECT_THAT(work.Run("check --dialect nc110 t.plc --set help=H").errors, HasSubstr("'H' ends here"))
      << "named files, too";
  work.Write("m.plc", ":MOD PM 1\n:A I 0.0\n:= O 0.0\n:END PM 1\n\x1A more\n");
  EXPECT_THAT(work.Run("check --dialect prostep m.plc").errors, Not(HasSubstr("1AH"))) << "its control says nothing";
}

TEST(BadInput, ContradictorySymbolFile) {
  const Workplace work;
  work.Write("names.sym", "*\nCLAMP=U4A0\nCLAMP=U4A1\n");
  work.Write("main.plc", "!CLAMP=I0A0\n$\n");
  ExpectRefused(work, "names.sym main.plc", "twice");
}

TEST(BadInput, SameSourceTwice) {
  const Workplace work;
  work.Write("main.plc", kGoodProgram);
  std::filesystem::create_symlink("main.plc", work.Path("other.plc"));
  ExpectRefused(work, "main.plc main.plc", "twice", 2);
  ExpectRefused(work, "main.plc ./main.plc", "twice", 2);
  ExpectRefused(work, "main.plc other.plc", "twice", 2);
}

TEST(BadInput, ElevenSources) {
  const Workplace work;
  std::string arguments;
  for (int i = 0; i < 11; ++i) {
    const std::string name = "part" + std::to_string(i) + ".plc";
    work.Write(name, "U4A" + std::to_string(i) + "=I0A0\n");
    arguments += name + " ";
  }
  ExpectRefused(work, arguments, "nc110-51");
}

TEST(BadInput, AScenarioWithoutProgramIsToldByEveryCommand) {
  const Workplace work;
  work.Write("alone.yaml", "steps:\n- run: {slow: 1}\n- expect: {U4A0: 1}\n");
  for (const std::string command :
       {"check alone.yaml", "emit alone.yaml", "print ir alone.yaml", "report alone.yaml", "sim alone.yaml",
        "build alone.yaml --target host", "verify alone.yaml", "prove alone.yaml", "soak alone.yaml --for 1s",
        "live alone.yaml --no-browser", "mutate alone.yaml", "test alone.yaml", "why U4A0 --scenario alone.yaml",
        "identify alone.yaml alone.yaml"}) {
    const Ran ran = work.Run(command);
    EXPECT_EQ(ran.code, 2) << command << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("alone.yaml: no 'sources': the scenario names no program")) << command;
  }
}

// A program whose source is not there has an error, as one that cannot be read; diff has compared nothing.
TEST(BadInput, ASourceThatIsNotThereIsAnError) {
  const Workplace work;
  work.Write("main.plc", "$\nU4A0=I0A0\n");
  for (const std::string command : {"check", "emit", "sim", "report", "verify", "soak --for 1s", "print ir", "live",
                                    "build --target host", "identify main.plc"}) {
    const Ran ran = work.Run(command + " nope.plc");
    EXPECT_EQ(ran.code, 1) << command << ran;
    EXPECT_THAT(ran.errors, HasSubstr("'nope.plc': no such file"));
  }
  EXPECT_EQ(work.Run("check main.plc nope.plc").code, 1);
  EXPECT_EQ(work.Run("check main.plc . --dialect nc110").code, 1);
  const Ran compared = work.Run("diff main.plc nope.plc");
  EXPECT_EQ(compared.code, 2);
  EXPECT_THAT(compared.errors, AllOf(HasSubstr("'nope.plc': no such file"), Not(HasSubstr("cannot be compared"))));
}

TEST(BadInput, FilesThatAreNoSourcesAreToldWithTheCause) {
  const Workplace work;
  work.Write("main.plc", "$\nU4A0=I0A0\n");
  work.Write("doors.prop", "never U4A0 and U4A1\n");
  work.Write("run.vcd", "");
  const auto refused = [&](const std::string& command) {
    const Ran ran = work.Run(command);
    EXPECT_EQ(ran.code, 2) << ran;
    return ran.errors;
  };
  EXPECT_THAT(refused("prove main.plc --property dors.prop"),
              HasSubstr("cannot read 'dors.prop': no such file, did you mean 'doors.prop'; --property names a file of "
                        "properties, one a line"));
  EXPECT_THAT(refused("prove main.plc --property ."), HasSubstr("cannot read '.': it is a directory; "));
  EXPECT_THAT(refused("live main.plc --no-browser --vcd rum.vcd"),
              HasSubstr("cannot read 'rum.vcd': no such file, did you mean 'run.vcd'; --vcd names a recorded trace"));
  EXPECT_THAT(refused("identify man.plc"),
              HasSubstr("cannot read 'man.plc': no such file, did you mean 'main.plc'; FILE is an object, "));
  work.Write("s.yaml", "sources: [main.plc]\nsteps:\n- run: {slow: 1}\n");
  EXPECT_THAT(refused("sim s.yaml main.plc"),
              HasSubstr("'s.yaml' is YAML, as scenarios are, which name their programs"));
  EXPECT_THAT(refused("check main.plc s.yaml"), HasSubstr("leave it or the sources out"));
  EXPECT_THAT(refused("prove main.plc --property s.yaml"), HasSubstr("are proved by 'plcxx prove s.yaml'"));
  EXPECT_THAT(refused("verify main.plc --target cortex-m4 --object nope.a"),
              HasSubstr("cannot read 'nope.a': no such file; --object names an object or a library"));
  EXPECT_THAT(refused("verify main.plc --routine fsat"), HasSubstr("there is no routine 'fsat'"));
  EXPECT_THAT(refused("live main.plc --link tcp:here:99999 --read U4A0"), HasSubstr("'99999' is no port: 1 to 65535"));
  EXPECT_THAT(refused("live main.plc --link socket:none --force U4A0=1,U4A0=0"),
              HasSubstr("'U4A0' is given two values"));
  EXPECT_THAT(refused("live main.plc --link socket:none --watch U4A0 --save main.plc/x.vcd"),
              HasSubstr("cannot write 'main.plc/x.vcd': not a directory"));  // before the machine is asked
  EXPECT_THAT(refused("live main.plc --link somewhere"), HasSubstr("'somewhere' is none of tcp:HOST:PORT, "));
}

}  // namespace
}  // namespace plcxx::driver
