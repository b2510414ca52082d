// What shells and people meet on the command line: one meaning of -o, "did you mean", completion, manual pages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Output, AFileAFolderOrStandardOutput) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  const Ran out = work.Run("emit ok.plc --single-file -o - -q");
  EXPECT_EQ(out.code, 0) << out;
  EXPECT_THAT(out.out, HasSubstr("OK_IMPLEMENTATION"));
  EXPECT_FALSE(work.Has("-"));
  EXPECT_EQ(work.Run("emit ok.plc --single-file -o new/one.hpp --depfile one.d -q").code, 0);
  EXPECT_EQ(work.Read("new/one.hpp"), out.out);
  EXPECT_THAT(work.Read("one.d"), HasSubstr("new/one.hpp: "));
  EXPECT_FALSE(work.Has("new/ok.map.json"));
  EXPECT_EQ(work.Run("emit ok.plc --single-file -o folder -q").code, 0);
  EXPECT_TRUE(work.Has("folder/ok.hpp"));
  for (const std::string command : {"emit ok.plc -o one.cpp", "build ok.plc --target host -o libok.a"}) {
    const Ran several = work.Run(command);
    EXPECT_EQ(several.code, 2) << several;
    EXPECT_THAT(several.errors, HasSubstr("is a file, and several are written: name a directory"));
  }
  EXPECT_EQ(work.Run("emit ok.plc -o v1.2/ -q").code, 0);
  EXPECT_TRUE(work.Has("v1.2/ok.hpp"));
  EXPECT_EQ(work.Run("emit ok.plc -o v1.2 -q").code, 0);  // a folder that is there
  EXPECT_EQ(work.Run("report ok.plc -o page.html -q").code, 0);
  EXPECT_THAT(work.Read("page.html"), HasSubstr("<html"));
  EXPECT_EQ(work.Run("report ok.plc --ladder -o rung.svg -q").code, 0);
  EXPECT_THAT(work.Read("rung.svg"), HasSubstr("<svg"));
}

TEST(DidYouMean, CommandsOptionsAndLocations) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  EXPECT_THAT(work.Run("chekc ok.plc").errors, HasSubstr("unknown command 'chekc'; did you mean 'check'?"));
  EXPECT_THAT(work.Run("check ok.plc --dialct nc110").errors, HasSubstr("did you mean '--dialect'"));
  EXPECT_THAT(work.Run("check ok.plc --dialct=nc110").errors, HasSubstr("did you mean '--dialect'"));
  EXPECT_THAT(work.Run("check ok.plc --completely-else").errors, Not(HasSubstr("did you mean")));
  EXPECT_THAT(work.Run("sim ok.plc --watch UA40").errors, HasSubstr("did you mean 'U4A0'"));
  work.Write("s.yaml", "dialect: nc110\nsources: [ok.plc]\nsteps:\n- expect: {UA40: 1}\n");
  EXPECT_THAT(work.Run("test s.yaml --engine sim").errors,
              HasSubstr("s.yaml:4:12: 'UA40' is no location of dialect nc110, did you mean 'U4A0'"));
}

TEST(DidYouMean, WordsThatMessagesList) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  struct Misspelt {
    const char *command, *message;
  };
  const Misspelt kMisspelt[] = {
      {"print schem", "'schem' is no phase, did you mean 'schema'; there are: source, "},
      {"print whatever ok.plc", "'whatever' is no phase; there are: source, "},
      {"manual chek", "'chek' is no command of plcxx, did you mean 'check'; there are: "},
      {"completion bassh", "'bassh' is no shell that plcxx knows, did you mean 'bash'; there are: bash, zsh, fish"},
      {"build ok.plc --target cortexm4", "'cortexm4' is no target, did you mean 'cortex-m4'; there are: host, "},
      {"test ok.yaml --engine simm", "there is no engine 'simm', did you mean 'sim'; there are: sim, host, all, "},
      {"check ok.plc --encoding kamenick", "'kamenick' is no encoding, did you mean 'kamenicky'; there are: auto, "},
      {"check ok.plc --dialect nc10", "'nc10' is no dialect, did you mean 'nc110' [plcxx-1]"},
      {"check ok.plc --set slics=2", "'slics' is no option of dialect nc110, did you mean 'slices' [plcxx-2]"},
      {"check ok.plc --diagnostics sarf",
       "--diagnostics: 'sarf' is no value of it, did you mean 'sarif'; there are: text, json, sarif"},
      {"emit ok.plc --host linuxnc", "did you mean 'linuxcnc'; there are: own, posix, linuxcnc, modbus"},
      {"init --pipeline githb", "did you mean 'github'; there are: auto, github, gitlab, none"},
      {"diff ok.plc ok.plc --format markdwn", "did you mean 'markdown'; there are: text, markdown, json, sarif, html"},
      {"build ok.plc --target host -O 7", "-O: '7' is no value of it; there are: 0, 1, 2, 3, s, z"},
      {"test ok.yaml --engine fleet511", "did you mean 'fleet512'; there are: sim, "},
      {"init --dialect hst50", "'hst50' is no dialect, did you mean 'host50'; there are: "},
  };
  work.Write("ok.yaml", "dialect: nc110\nsources: [ok.plc]\n");
  for (const Misspelt& misspelt : kMisspelt) {
    const Ran ran = work.Run(misspelt.command);
    EXPECT_EQ(ran.code, 2) << ran;
    EXPECT_THAT(ran.errors, HasSubstr(misspelt.message));
  }
}

TEST(Completion, OfEveryShellHasEveryCommand) {
  const Workplace work;
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const Ran script = work.Run("completion " + shell);
    EXPECT_EQ(script.code, 0) << shell;
    for (const char* word : {"emit", "check", "init", "diff", "cortex-m4f", "markdown"})
      EXPECT_THAT(script.out, HasSubstr(word)) << shell;
    work.Write("script", script.out);
    const std::string command =
        "command -v " + shell + " >/dev/null || exit 0; " + shell + " -n '" + work.Path("script") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << shell;
  }
  EXPECT_EQ(work.Run("completion tcsh").code, 2);
}

TEST(Completion, BashCompletesWordsAndValues) {
  const Workplace work;
  work.Write("script", work.Run("completion bash").out);
  const auto completed = [&](const std::string& words, int at) {
    const std::string script = "compopt() { :; }; . '" + work.Path("script") + "'; COMP_WORDS=(" + words +
                               "); COMP_CWORD=" + std::to_string(at) + "; _plcxx; echo \"${COMPREPLY[*]}\"";
    work.Write("run.sh", script);
    const std::string command = "bash '" + work.Path("run.sh") + "' >'" + work.Path("words") + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    return work.Read("words");
  };
  EXPECT_EQ(completed("plcxx em", 1), "emit\n");
  EXPECT_EQ(completed("plcxx check --diale", 2), "--dialect\n");
  EXPECT_EQ(completed("plcxx check --dialect h", 3), "hnc host50\n");
  EXPECT_EQ(completed("plcxx diff --format m", 3), "markdown\n");
  EXPECT_EQ(completed("plcxx build --target cortex-m4", 3), "cortex-m4 cortex-m4f\n");
}

TEST(Manual, EachCommandHasAPage) {
  const Workplace work;
  const Ran all = work.Run("manual -o man");
  EXPECT_EQ(all.code, 0) << all;
  EXPECT_THAT(work.Read("man/plcxx.1"), AllOf(HasSubstr(".SH COMMANDS"), HasSubstr("plcxx\\-emit")));
  EXPECT_THAT(work.Read("man/plcxx-check.1"),
              AllOf(StartsWith(".TH plcxx\\-check 1"), HasSubstr("\\fB\\-\\-write\\-baseline\\fR"),
                    HasSubstr("Exit codes: 0")));
  EXPECT_EQ(work.Run("manual check").out, work.Read("man/plcxx-check.1"));
  EXPECT_EQ(work.Run("manual chekc").code, 2);
  EXPECT_THAT(work.Run("manual").errors, IsEmpty());
}

}  // namespace
}  // namespace plcxx::driver
