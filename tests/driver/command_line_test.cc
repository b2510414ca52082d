// The contract of the command line: exit codes, help, options that every subcommand takes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/driver/run_plcxx.h"

namespace plcxx::driver {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(CommandLine, VersionAndHelp) {
  const Workplace work;
  const Ran version = work.Run("--version");
  EXPECT_EQ(version.code, 0);
  EXPECT_THAT(version.out, ::testing::StartsWith("plcxx "));
  const Ran help = work.Run("--help");
  EXPECT_EQ(help.code, 0);
  EXPECT_THAT(help.out, HasSubstr("Examples:"));
  EXPECT_THAT(help.out, HasSubstr("Exit codes:"));
  EXPECT_THAT(help.errors, IsEmpty());
}

/// "-" is standard output wherever something is written; where that shows the results it is no place for a second
/// thing.
TEST(CommandLine, StandardOutputIsNoFile) {
  const Workplace work;
  work.Write("a.plc", kGoodProgram);
  work.Write("b.plc", "U4A0=/I0A0\n$\nU4A1=I0A1\n");
  work.Write("a.yaml", "sources: [a.plc]\nsteps:\n- run: {ms: 20}\n");
  work.Write("p.prop", "never U4A0\n");
  for (const std::string arguments :
       {"test a.yaml --junit -", "test a.yaml --vcd -", "sim a.plc --watch U4A0 --vcd -",
        "verify a.plc --certificate -", "prove a.plc --property p.prop --junit -",
        "prove a.plc --property p.prop --counterexamples -", "diff a.plc b.plc --counterexamples -",
        "soak a.plc --for 1s -o -", "emit a.plc -o out --depfile -"}) {
    const Ran ran = work.Run(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("'-': standard output shows the results")) << arguments;
    EXPECT_FALSE(work.Has("-")) << arguments;
  }
}

TEST(CommandLine, EverySubcommandTeaches) {
  const Workplace work;
  for (const std::string command :
       {"emit",  "build", "check",      "print",  "test", "sim", "explain",  "report", "verify", "diff",
        "prove", "init",  "completion", "manual", "lsp",  "mcp", "identify", "live",   "soak",   "mutate"}) {
    const Ran help = work.Run(command + " --help");
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_THAT(help.out, HasSubstr("Examples:")) << command;
    EXPECT_THAT(help.out, HasSubstr("plcxx " + command)) << command;
    EXPECT_THAT(help.out, HasSubstr("Exit codes:")) << command;
  }
}

// covers: NC110-253
TEST(CommandLine, HelpListsTheOptionsOfTheDialect) {
  const Workplace work;
  const Ran help = work.Run("emit --dialect nc110 --help");
  for (const char* key : {"clo", "slices", "t-init", "carry", "nc-stub", "stop-on-error", "facts"}) {
    EXPECT_THAT(help.out, HasSubstr("\n  " + std::string(key) + " "));
  }
  EXPECT_THAT(help.out, Not(HasSubstr("system-header")));
  // Of no dialect: which keys there are, and how to ask for one.
  const Ran keys = work.Run("build --help");
  EXPECT_THAT(keys.out, HasSubstr("plcxx emit --dialect NAME --help"));
  for (const char* row : {"\n  nc110    ", "\n  hnc      char, abs, system-header", "\n  all      facts\n"})
    EXPECT_THAT(keys.out, HasSubstr(row));
  EXPECT_EQ(work.Run("emit --dialect cobol --help").code, 0);
  // The project says which; the manual page has all of them.
  work.Write("a.plc", ":MOD PM 9\n:END PM 9\n");
  work.Write("plcxx.yaml", "dialect: prostep\nsources: [a.plc]\n");
  EXPECT_THAT(work.Run("emit --help").out,
              AllOf(HasSubstr("Options of dialect prostep "), Not(HasSubstr("Options of dialect hnc"))));
  const std::string page = work.Run("manual emit").out;
  for (const char* dialect : {"hnc", "host50", "nc110", "prostep", "technol"})
    EXPECT_THAT(page, HasSubstr("Options of dialect " + std::string(dialect) + " "));
}

TEST(CommandLine, WrongUseIsTwo) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  for (const std::string arguments : {"",
                                      "frobnicate",
                                      "emit",
                                      "check --bogus ok.plc",
                                      "check ok.plc --encoding klingon",
                                      "check ok.plc --dialect cobol",
                                      "check ok.plc --diagnostics=xml",
                                      "check ok.plc --set clo",
                                      "check ok.plc --set nothing=1",
                                      "check ok.plc --set clo=x",
                                      "check ok.plc --set =1",
                                      "check ok.plc -Wfoo",
                                      "check ok.plc -Wno-W999",
                                      "check ok.plc -DX",
                                      "check ok.plc -U X",
                                      "emit ok.plc --name ../x",
                                      "emit ok.plc --name ''  --name a/b",
                                      "print nothing ok.plc",
                                      "print ir",
                                      "explain nc110-9999",
                                      "check ok.plc ok.plc",
                                      "check ok.plc ./ok.plc"}) {
    const Ran ran = work.Run(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("error")) << arguments;
  }
}

TEST(CommandLine, ProgramWithErrorsIsOne) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  work.Write("bad.plc", kBadProgram);
  EXPECT_EQ(work.Run("check ok.plc").code, 0);
  EXPECT_EQ(work.Run("check bad.plc").code, 1);
  EXPECT_EQ(work.Run("print ir bad.plc").code, 1);
  EXPECT_EQ(work.Run("sim bad.plc").code, 1);
  EXPECT_EQ(work.Run("emit bad.plc -o out").code, 1);
}

TEST(CommandLine, OutputThatCannotBeWrittenIsNotDone) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  EXPECT_EQ(work.Run("print cpp ok.plc >/dev/full 2>/dev/null; test $? = 2").code, 0);
  EXPECT_EQ(work.Run("--help >/dev/full 2>/dev/null; test $? = 2").code, 0);
  // One code, whatever the result is, and whatever else was found.
  work.Write("bad.yaml", "sources: [ok.plc]\nsteps:\n- run: {slow: 1}\n- expect: {U4A0: 1}\n");
  work.Write("ok.prop", "never I0A0\n");
  for (const std::string command :
       {"emit ok.plc -o /dev/full/out", "emit ok.plc --single-file -o ok.plc/x.hpp",
        "report ok.plc -o /proc/none/x.html", "report ok.plc --lists -o ok.plc/x.txt",
        "test bad.yaml --engine sim --junit /dev/full", "sim ok.plc --for 20ms --watch U4A0 --vcd /dev/full",
        "prove ok.plc --property ok.prop --junit /dev/full", "build ok.plc --target host -o ok.plc/out",
        "check ok.plc --write-baseline --baseline ok.plc/b", "manual -o ok.plc/man",
        "verify ok.plc --certificate /dev/full"}) {
    const Ran ran = work.Run(command);
    EXPECT_EQ(ran.code, 2) << command << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("cannot write '")) << command;
  }
}

// A name that is mistyped, or lacks its extension, has the right one beside it.
TEST(CommandLine, AFileThatIsNotThere) {
  const Workplace work;
  work.Write("door.plc", kGoodProgram);
  EXPECT_THAT(work.Run("check dor.plc").errors, HasSubstr("no such file, did you mean 'door.plc' [plcxx-7]"));
  EXPECT_THAT(work.Run("check Door.plc").errors, HasSubstr("did you mean 'door.plc'"));
  EXPECT_THAT(work.Run("check door").errors, HasSubstr("did you mean 'door.plc'"));
  EXPECT_THAT(work.Run("check mill.plc").errors, HasSubstr("no such file [plcxx-7]"));
  work.Write("door.yaml", "sources: [dor.plc]\nsteps:\n- set: {I0A0 1}\n");
  EXPECT_THAT(work.Run("test dor.yaml").errors, HasSubstr("dor.yaml: there is no such file, did you mean 'door.yaml'"));
  EXPECT_THAT(work.Run("test door.yaml").errors,
              HasSubstr("door.yaml:3:15: the value of 'I0A0 1' is missing\n  help: write it behind its key, a colon"));
  work.Write("plcxx.yaml", "dialect: nc110\nsources: door.plc\nproperties: door.prp\n");
  work.Write("door.prop", "never U4A0\n");
  EXPECT_THAT(work.Run("check").errors, HasSubstr("there is no file 'door.prp'\n  help: did you mean 'door.prop'"));
}

TEST(CommandLine, TheEndOfAModuleAsOthersWriteIt) {
  const Workplace work;
  work.Write("a.pst", ":MOD PM 0\n:A I 0.0\n:= O 0.0\n:ENDMOD\n");
  EXPECT_THAT(work.Run("check a.pst --dialect prostep").errors,
              AllOf(HasSubstr("unknown instruction 'ENDMOD'"), HasSubstr("help: the module's end is ':END PM n'")));
}

TEST(CommandLine, WhatIsWrongBeginsWithNoCapital) {
  const Workplace work;
  EXPECT_THAT(work.Run("").errors, HasSubstr("plcxx: error: a command is missing\n"));
  EXPECT_THAT(work.Run("--verson").errors,
              HasSubstr("'--verson' is no option of plcxx itself, did you mean '--version'"));
  EXPECT_THAT(work.Run("completion").errors, HasSubstr("plcxx: error: SHELL is required"));
  EXPECT_THAT(work.Run("emit x.plc --parts 0").errors, HasSubstr("--parts: value 0 not in range 1 to 64"));
  // CLI11 takes a number below 0 for a very large one where no range is said.
  for (const std::string command :
       {"soak x.plc --seed", "mutate x.yaml --most", "sim x.plc --samples", "why U4A0 --step"}) {
    for (const std::string value : {"-1", "x"}) {
      const Ran ran = work.Run(command + " " + value);
      EXPECT_EQ(ran.code, 2) << ran;
      EXPECT_THAT(ran.errors, HasSubstr(": value " + value + " not in range ")) << command;
    }
  }
  EXPECT_THAT(work.Run("sim x.plc --samples 0").errors, HasSubstr("value 0 not in range 1 to "));
  EXPECT_THAT(work.Run("check x.plc --max-messages 1 --max-messages 2").errors,
              HasSubstr("--max-messages is given 2 times: write it once"));
  EXPECT_THAT(work.Run("soak x.plc --cxx clang++").errors, HasSubstr("--cxx is the compiler of --engine fleet"));
}

TEST(CommandLine, WordsThatAreNoCommand) {
  const Workplace work;
  EXPECT_THAT(work.Run("sim x.plc --scenario s.yaml").errors,
              HasSubstr("was not expected: --scenario; it is an option of: why"));
  for (const std::string option : {"-o", "--name", "--dialect"}) {
    const Ran empty = work.Run("emit x.plc " + option + " ''");
    EXPECT_EQ(empty.code, 2) << empty;
    EXPECT_THAT(empty.errors, HasSubstr("'" + option + "' is given an empty value")) << empty;
  }
  for (const std::string command : {"check", "emit", "test", "sim", "prove", "print ir", "why", "mutate", "identify",
                                    "explain", "init", "manual", "diff x.plc", "live"}) {
    const Ran empty = work.Run(command + " ''");
    EXPECT_EQ(empty.code, 2) << command << "\n" << empty;
    EXPECT_THAT(empty.errors, HasSubstr("' is given an empty word: write one, or leave it out\n")) << command;
  }
  EXPECT_THAT(work.Run("emt x.plc").errors, HasSubstr("unknown command 'emt'; did you mean 'emit'?"));
  EXPECT_EQ(work.Run("emt x.plc").code, 2);
  EXPECT_THAT(work.Run("frobnicate").errors, AllOf(HasSubstr("unknown command 'frobnicate'"), Not(HasSubstr("mean"))));
  EXPECT_EQ(work.Run("help").out, work.Run("--help").out);
  EXPECT_EQ(work.Run("help emit").out, work.Run("emit --help").out);
  EXPECT_EQ(work.Run("-v").out, work.Run("--version").out);
  EXPECT_THAT(work.Run("emit --nosuch").errors, HasSubstr("plcxx emit --help tells how it is used"));
}

// Whoever reads a verdict and the help alone knows what it is good for, and what is not meant by it.
TEST(CommandLine, HelpSaysWhatAVerdictClaimsAndWhatNot) {
  const Workplace work;
  for (const char* command : {"diff", "prove", "verify"}) {
    const std::string help = work.Run(std::string(command) + " --help").out;
    EXPECT_THAT(help, AllOf(HasSubstr("What a verdict claims:\n  proved"), HasSubstr("nothing, and it is no success: "),
                            HasSubstr("It does not claim that ")))
        << command;
  }
}

// Where the options of a command belong is said with the command line as it would be right.
TEST(CommandLine, OptionsInFrontOfTheCommand) {
  const Workplace work;
  const Ran ran = work.Run("--project plcxx.yaml check");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(ran.errors,
            "plcxx: error: the command comes first, its options after it: plcxx check --project plcxx.yaml\n"
            "plcxx --help tells how it is used\n");
  EXPECT_THAT(work.Run("--quiet emit a.plc -o out").errors, HasSubstr(": plcxx emit --quiet a.plc -o out\n"));
  EXPECT_THAT(work.Run("--project=x.yaml").errors, HasSubstr("'--project' is no option of plcxx itself"));
  EXPECT_EQ(work.Run("-h").out, work.Run("--help").out);
}

TEST(CommandLine, ReportSaysWhatItWrote) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  EXPECT_THAT(work.Run("report ok.plc -o page").errors, HasSubstr("wrote page/ok.html\n"));
  EXPECT_THAT(work.Run("report ok.plc -o page -q").errors, Not(HasSubstr("wrote")));
  EXPECT_EQ(work.Run("emit ok.plc -o -").code, 2);
  EXPECT_FALSE(work.Has("-"));
}

// covers: NC110-233
TEST(CommandLine, WarningsAreSwitchedByName) {
  const Workplace work;
  work.Write("fast.plc", "U4A0=I0A0\n");  // no '$': W303
  EXPECT_THAT(work.Run("check fast.plc").errors, HasSubstr("warning"));
  EXPECT_THAT(work.Run("check fast.plc -Wno-W303").errors, Not(HasSubstr("warning:")));
  EXPECT_THAT(work.Run("check fast.plc -Wno-nc110-W303").errors, Not(HasSubstr("warning:")));
  EXPECT_THAT(work.Run("check fast.plc -Wno-W3O3").errors,
              HasSubstr("'-Wno-W3O3' names no warning: did you mean 'W303'"));
  EXPECT_THAT(work.Run("check fast.plc -Wno-nc110-43").errors,
              HasSubstr("'nc110-43' is an error, and errors cannot be"));
  EXPECT_EQ(work.Run("check fast.plc -Wno-W303 -Werror").code, 0);
  for (const std::string option : {"-Werror", "-Werror=W303", "-Werror=nc110-W303", "-Wno-W303 -Werror=W303"}) {
    const Ran ran = work.Run("check fast.plc " + option);
    EXPECT_EQ(ran.code, 1) << option << "\n" << ran;
    EXPECT_THAT(ran.errors, HasSubstr("error:")) << option;
  }
  EXPECT_EQ(work.Run("check fast.plc -Werror -Wno-error").code, 0);
}

// covers: NC110-229 NC110-255
TEST(CommandLine, ErrorsStandInTheOrderOfTheSource) {
  const Workplace work;
  work.Write("bad.plc", "U4A1=I0A\nDOF:I0A1\nU4A2=99\n$\nU4A3=!NOT\n");
  const Ran all = work.Run("check bad.plc");
  EXPECT_EQ(all.code, 1);
  size_t last = 0;
  for (const char* place : {"bad.plc:1:", "bad.plc:2:", "bad.plc:3:", "bad.plc:5:"}) {
    const size_t at = all.errors.find(place);
    ASSERT_NE(at, std::string::npos) << place << "\n" << all;
    EXPECT_GE(at, last) << place << "\n" << all;
    last = at;
  }
  const Ran first = work.Run("check bad.plc --set stop-on-error=on");
  EXPECT_THAT(first.errors, HasSubstr("bad.plc:1:"));
  EXPECT_THAT(first.errors, Not(HasSubstr("bad.plc:2:")));
  EXPECT_THAT(first.errors, HasSubstr("1 error"));
}

TEST(CommandLine, DialectByExtensionContentOrWord) {
  const Workplace work;
  work.Write("program", kGoodProgram);
  work.Write("letter.txt", "Dear colleague,\nthe machine is broken.\n");
  EXPECT_EQ(work.Run("check program").code, 0);
  EXPECT_EQ(work.Run("check program --dialect nc110").code, 0);
  const Ran unknown = work.Run("check letter.txt");
  EXPECT_EQ(unknown.code, 2);
  EXPECT_THAT(unknown.errors, HasSubstr("plcxx-1"));
  EXPECT_THAT(unknown.errors, HasSubstr("nc110"));
}

TEST(CommandLine, StandardInputIsASource) {
  const Workplace work;
  EXPECT_EQ(work.Run("check -", kGoodProgram).code, 0);
  EXPECT_EQ(work.Run("check - --dialect nc110", kGoodProgram).code, 0);
  EXPECT_EQ(work.Run("check - -", kGoodProgram).code, 2);
  const Ran bad = work.Run("check - --dialect nc110", kBadProgram);
  EXPECT_EQ(bad.code, 1);
  EXPECT_THAT(bad.errors, HasSubstr("<stdin>:2:"));
  EXPECT_EQ(work.Run("emit - --dialect nc110 -o out", kGoodProgram).code, 0);
  EXPECT_TRUE(work.Has("out/program.cpp"));
}

TEST(CommandLine, NoColoursInAFile) {
  const Workplace work;
  work.Write("bad.plc", kBadProgram);
  EXPECT_THAT(work.Run("check bad.plc", "", "TERM=xterm-256color").errors, Not(HasSubstr("\x1b[")));
}

TEST(CommandLine, IncludeDirectoriesServeOptions) {
  const Workplace work;
  work.Write("ok.plc", kGoodProgram);
  std::filesystem::create_directory(work.Path("texts"));
  work.Write("texts/messages", "15#hello\n");
  EXPECT_EQ(work.Run("check ok.plc --set messages=messages").code, 1);
  EXPECT_EQ(work.Run("check ok.plc --set messages=messages -I nowhere -I texts").code, 0);
}

}  // namespace
}  // namespace plcxx::driver
