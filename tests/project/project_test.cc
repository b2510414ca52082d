// plcxx.yaml: what is read, and what is refused with its place.
#include "transpiler/project/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/project/project_fixture.h"
#include "transpiler/project/keys.h"

namespace plcxx::project {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::StartsWith;

TEST(Project, SaysWhatAProgramIsMadeOf) {
  const Folder folder;
  folder.Write("MESSAGES", "1#A\n");
  folder.Write("test/x.yaml", "steps: []\n");
  folder.Write("lathe.prop", "never U4A0\n");
  const Program program = folder.Only(R"(name: lathe
dialect: nc110
sources: [a.sym, b.plc]
encoding: cp866
options: {messages: MESSAGES, clo: [10, 2]}
include: inc
warnings: {enable: W370, disable: [W303], errors: all, baseline: base.yaml}
scenarios: test
properties: lathe.prop
generated: cpp
targets:
  cortex-m4f: {clock: 168MHz, max-slow-us: 10, max-stack: 256, optimize: s}
  host:
)");
  const std::string in = folder.Path("");
  EXPECT_EQ(program.name, "lathe");
  EXPECT_EQ(program.dialect, "nc110");
  EXPECT_THAT(program.sources, ElementsAre("a.sym", "b.plc"));
  EXPECT_EQ(program.encoding, "cp866");
  EXPECT_THAT(program.options, ElementsAre(Pair("messages", "MESSAGES"), Pair("clo", "10,2")));
  EXPECT_THAT(program.include, ElementsAre(in + "inc"));
  EXPECT_THAT(program.warnings, ElementsAre("W370", "no-W303", "error"));
  EXPECT_EQ(program.baseline, in + "base.yaml");
  EXPECT_THAT(program.scenarios, ElementsAre(in + "test"));
  EXPECT_THAT(program.properties, ElementsAre(in + "lathe.prop"));
  EXPECT_EQ(program.generated, in + "cpp");
  ASSERT_EQ(program.targets.size(), 2u);
  EXPECT_EQ(program.targets[0].name, "cortex-m4f");
  EXPECT_EQ(program.targets[0].clock, "168MHz");
  EXPECT_EQ(program.targets[0].max_slow_us, 10u);
  EXPECT_EQ(program.targets[0].max_stack, 256u);
  EXPECT_EQ(program.targets[0].optimize, "s");
  EXPECT_EQ(program.targets[1].output, in + "out/host");
}

// A value that does not fit the default of another option may fit what that one is set to.
TEST(Project, OptionsAreRightTogether) {
  const Folder folder;
  const Program program = folder.Only("dialect: technol\nsources: [b.plc]\noptions: {fast-ms: 1000, slow-ms: 1000}\n");
  EXPECT_THAT(program.options, ElementsAre(Pair("fast-ms", "1000"), Pair("slow-ms", "1000")));
}

TEST(Project, LittleIsEnough) {
  const Folder folder;
  const Program program = folder.Only("sources: b.plc\n");
  EXPECT_THAT(program.sources, ElementsAre("b.plc"));
  EXPECT_EQ(program.generated, folder.Path("generated"));
  EXPECT_EQ(RequestOf(program).base_directory + "/b.plc", folder.Path("b.plc"));
}

TEST(Project, MacrosAreAMapOrAList) {
  const Folder folder;
  const auto texts = [&](std::string_view macros) {
    std::string all;
    for (const dialects::MacroOption& macro :
         folder.Only("dialect: hnc\nsources: b.plc\n" + std::string(macros)).macros)
      all += macro.name + "=" + macro.text.value_or("(undefined)") + ";";
    return all;
  };
  EXPECT_EQ(texts("macros: {A: 3, B: }\n"), "A=3;B=1;");
  EXPECT_EQ(texts("macros: [A=3, B]\nundefine: C\n"), "A=3;B=1;C=(undefined);");
}

TEST(Project, APatternMeansAllTheOthers) {
  const Folder folder;
  folder.Write("sub/d.plc", "$\n");
  folder.Write("sub/deep/e.plc", "$\n");
  EXPECT_THAT(folder.Only("sources: [a.sym, '*.plc']\n").sources, ElementsAre("a.sym", "b.plc", "c.plc"));
  EXPECT_THAT(folder.Only("sources: [c.plc, '*.plc']\n").sources, ElementsAre("c.plc", "b.plc"));
  EXPECT_THAT(folder.Only("sources: [./c.plc, '*.plc', '?.plc']\n").sources, ElementsAre("./c.plc", "b.plc"));
  EXPECT_THAT(folder.Only("sources: b.plc\nscenarios: [c.plc, '*.plc']\n").scenarios,
              ElementsAre(folder.Path("c.plc"), folder.Path("b.plc")));
  EXPECT_THAT(folder.Only("sources: ['?.plc', b.plc]\n").sources, ElementsAre("c.plc", "b.plc"));
  EXPECT_THAT(folder.Only("sources: '**/*.plc'\n").sources,
              ElementsAre("b.plc", "c.plc", "sub/d.plc", "sub/deep/e.plc"));
  EXPECT_THAT(folder.Only("sources: 's*/d.plc'\n").sources, ElementsAre("sub/d.plc"));
  EXPECT_THAT(folder.Only("sources: '**/*'\n").sources,
              ElementsAre("a.sym", "b.plc", "c.plc", "sub/d.plc", "sub/deep/e.plc"));
}

TEST(Project, SeveralProgramsShareWhatIsBesideThem) {
  const Folder folder;
  folder.Write("mill/m.plc", "$\n");
  const ProjectOrErrors read = folder.Read(R"(dialect: nc110
options: {clo: [20, 2], slices: 2}
targets: {cortex-m4f: {clock: 100MHz}}
programs:
- {name: lathe, sources: b.plc}
- folder: mill
  sources: '*.plc'
  options: {slices: 1}
  targets: {cortex-m4f: {max-stack: 100}, host: }
)");
  ASSERT_TRUE(std::holds_alternative<Project>(read)) << folder.Errors("").at(0);
  const auto& project = std::get<Project>(read);
  ASSERT_EQ(project.programs.size(), 2u);
  const Program& mill = project.programs[1];
  EXPECT_EQ(NameOf(mill), "mill");
  EXPECT_EQ(mill.dialect, "nc110");
  EXPECT_THAT(mill.sources, ElementsAre("m.plc"));
  EXPECT_THAT(mill.options, ElementsAre(Pair("clo", "20,2"), Pair("slices", "1")));
  EXPECT_EQ(mill.targets.at(0).clock, "100MHz");
  EXPECT_EQ(mill.targets.at(0).max_stack, 100u);
  EXPECT_EQ(mill.generated, folder.Path("mill/generated"));
  EXPECT_EQ(mill.include.back() + "/", folder.Path(""));
  EXPECT_EQ(FindProgram(project, "lathe"), &project.programs[0]);
  EXPECT_EQ(FindProgram(project, "saw"), nullptr);
}

TEST(Project, IsFoundUpwardsAsFarAsTheVersionedFolder) {
  const Folder folder;
  folder.Write("plcxx.yaml", "sources: b.plc\n");
  folder.Write("sub/deep/e.plc", "$\n");
  EXPECT_EQ(FindProject(folder.Path("b.plc")), folder.Path("plcxx.yaml"));
  EXPECT_EQ(FindProject(folder.Path("sub/deep")), folder.Path("plcxx.yaml"));
  EXPECT_EQ(FindProject(folder.Path("sub/deep/e.plc")), folder.Path("plcxx.yaml"));
  folder.Write("sub/.git/HEAD", "");
  EXPECT_EQ(FindProject(folder.Path("sub/deep")), std::nullopt);
}

/// One letter of each key left out, in each section.
TEST(Project, EveryMisspeltKeyIsRefusedAtItsPlace) {
  const Folder folder;
  const auto wrong = [](std::string_view key) {
    return std::string(key.substr(0, 1)) + "_" + std::string(key.substr(1));
  };
  for (const KeyRow& row : Keys()) {
    const std::string word = wrong(row.text);
    std::string text, place;
    switch (row.section) {
      case Section::kFile:
      case Section::kProgram:
        text = "sources: b.plc\n" + word + ": x\n";
        place = "2:1: ";
        break;
      case Section::kWarnings:
        text = "sources: b.plc\nwarnings: {" + word + ": x}\n";
        place = "2:12: ";
        break;
      case Section::kTarget:
        text = "sources: b.plc\ntargets:\n  host:\n    " + word + ": x\n";
        place = "4:5: ";
        break;
    }
    EXPECT_THAT(folder.Errors(text), ElementsAre(AllOf(StartsWith(place + "'" + word + "' is no key of "),
                                                       HasSubstr("did you mean '" + std::string(row.text) + "'"))));
  }
}

struct WrongValue {
  const char* text;
  const char* error;
};

TEST(Project, EveryWrongValueIsRefusedAtItsPlace) {
  const Folder folder;
  const WrongValue kWrong[] = {
      {"name: a/b", "2:7: 'a/b' cannot name files\n  help: use letters, digits, '_', '-' and '.'"},
      {"name: [a]", "2:7: 'name' is a single word or number"},
      {"name: ", "2:6: 'name' is missing"},
      {"folder: ''", "2:9: a path of 'folder' is empty"},
      {"dialect: nc11",
       "2:10: 'nc11' is no dialect; there are: classicladder, hnc, host50, nc110, prostep, technol\n"
       "  help: did you mean 'nc110'"},
      {"encoding: cp868", "2:11: 'cp868' is no encoding; there are: "},
      {"options: [a]", "2:10: 'options' is a map '{key: value}'"},
      {"options: {speed: 2}", "2:11: 'speed' is no option of dialect nc110\n  help: its options are: "},
      {"options: {slics: 2}",
       "2:11: 'slics' is no option of dialect nc110, did you mean 'slices'\n  help: its options are: "},
      {"options: {slices: 99}", "2:19: value '99' of option 'slices' is not valid\n  help: expected 1..64 or auto"},
      {"options: {facts: maybe}",
       "2:18: value 'maybe' of option 'facts' is not valid\n  help: expected trusted or checked"},
      {"macros: {A: 1}", "2:1: 'macros' says nothing to dialect nc110\n  help: delete it: "},
      {"undefine: [A]", "2:1: 'undefine' says nothing to dialect nc110"},
      {"system-include: lib", "2:1: 'system-include' says nothing to dialect nc110"},
      {"include: /etc",
       "2:10: '/etc' is outside of the project DIR\n  help: move it there, or allow it with --allow-outside"},
      {"system-include: ../x", "2:17: '../x' is outside of the project DIR"},
      {"warnings: on", "2:11: 'warnings' is a map '{key: value}'"},
      {"warnings: {enable: W99999}", "2:20: 'W99999' names no warning\n  help: plcxx explain --list shows them all"},
      {"warnings: {disable: W35O}", "2:21: 'W35O' names no warning\n  help: did you mean 'W350'"},
      {"warnings: {disable: nc110_w356}", "2:21: 'nc110_w356' names no warning\n  help: did you mean 'nc110-W356'"},
      {"warnings: {disable: nc110-43}",
       "2:21: 'nc110-43' names no warning\n  help: 'nc110-43' is an error, and errors cannot be chosen"},
      {"warnings: {disable: no-W356}", "2:21: 'no-W356' names no warning\n  help: did you mean 'W356'"},
      {"warnings: {errors: error}", "2:20: 'error' names no warning"},
      {"scenarios: nothing.yaml", "2:12: there is no file 'DIR/nothing.yaml'"},
      {"scenarios: [a.sym, ./a.sym]", "2:20: './a.sym' is named twice\n  help: name each file once"},
      {"scenarios: b.plx", "2:12: there is no file 'DIR/b.plx'\n  help: did you mean 'b.plc'"},
      {"targets: cortex-m4x", "2:10: 'cortex-m4x' is no target; there are: "},
      {"targets: {cortex-m4x: {}}", "2:11: 'cortex-m4x' is no target; there are: "},
      {"targets: {host: {clock: fast}}", "2:25: 'fast' is no frequency\n  help: write 168MHz, 32kHz or 16000000"},
      {"targets: {host: {max-stack: -3}}", "2:29: '-3': 'max-stack' is a whole number"},
      {"targets: {host: {optimize: 4}}", "2:28: '4' is no level of optimization; there are: 0, 1, 2, 3, s, z"},
      {"host: linux", "2:7: 'linux' is no host; there are: own, posix, linuxcnc, modbus"},
      {"generated: /tmp/x", "2:12: '/tmp/x' is outside of the project DIR"},
      {"programs: 3", "2:11: 'programs' is a list of maps"},
      {"programs: []", "2:11: 'programs' is a list of maps"},
      {"programs: [{sources: b.plc}, {sources: b.plc}]", "2:30: a second program called "},
      {"name: a\nname: b", "3:1: 'name' is given twice"},
  };
  for (const WrongValue& wrong : kWrong) {
    const std::string dialect = std::string_view(wrong.text).starts_with("dialect") ? "" : "dialect: nc110, ";
    const std::string text = dialect.empty() ? "sources: b.plc\n" + std::string(wrong.text) + "\n"
                                             : "sources: b.plc\n" + std::string(wrong.text) + "\ndialect: nc110\n";
    const std::vector<std::string> errors = folder.Errors(text);
    ASSERT_THAT(errors, ::testing::Not(IsEmpty())) << text;
    EXPECT_THAT(errors.front(), StartsWith(wrong.error)) << text;
  }
}

TEST(Project, SourcesHaveToBeThere) {
  const Folder folder;
  EXPECT_THAT(folder.Errors("name: x\n"),
              ElementsAre("1:1: 'sources' is missing\n  help: name the files of the program, in their order"));
  EXPECT_THAT(folder.Errors("sources: [b.plc, d.plcc]\n"), ElementsAre("1:18: there is no file 'DIR/d.plcc'"));
  EXPECT_THAT(folder.Errors("sources: '*.il'\n"), ElementsAre("1:10: no file is called '*.il'"));
  EXPECT_THAT(folder.Errors("sources: [b.plc, a.sym, b.plc]\n"),
              ElementsAre("1:25: 'b.plc' is named twice\n  help: name each file once"));
  EXPECT_THAT(folder.Errors("sources: []\n"), ElementsAre("1:10: 'sources' names no file"));
  EXPECT_THAT(folder.Errors("sources: ../../*.plc\n"), ElementsAre(HasSubstr("is outside of the project DIR")));
  EXPECT_THAT(folder.Errors("sources: [/etc/passwd]\n"), ElementsAre(HasSubstr("is outside of the project DIR")));
}

TEST(Project, WhatIsNoYamlIsSaid) {
  const Folder folder;
  EXPECT_THAT(folder.Errors(""), ElementsAre(" the file says nothing: 'sources' is missing"));
  EXPECT_THAT(folder.Errors("sources: [b.plc\n"), ElementsAre(HasSubstr("not YAML: ")));
  EXPECT_THAT(folder.Errors("- a\n"), ElementsAre("1:1: plcxx.yaml is a map '{key: value}'"));
  EXPECT_THAT(folder.Errors("sources: b.plc,\n,"), Contains(HasSubstr("")));
  EXPECT_THAT(folder.Errors("a: 1\n---\nb: 2\n"), ElementsAre("2:1: the file holds more than one YAML document"));
  EXPECT_THAT(folder.Errors(std::string(2u << 20, '#')), ElementsAre(" the file is larger than 1 MB: not a project"));
  EXPECT_THAT(folder.Errors(std::string(100'000, '[')), ElementsAre(HasSubstr("not YAML: ")));
  EXPECT_THAT(ToText(std::get<std::vector<yaml::Error>>(ReadProject(folder.Path("none.yaml"))).at(0)),
              HasSubstr("there is no such file"));
}

TEST(Project, AnchorsNeitherLoopNorExplode) {
  const Folder folder;
  EXPECT_THAT(folder.Errors("sources: &a [b.plc, *a]\n"), Contains(HasSubstr("'sources' is a single word")));
  EXPECT_THAT(folder.Errors("programs: &p [{sources: b.plc, programs: *p}]\n"),
              Contains(HasSubstr("'programs' is no key of a program")));
  std::string bomb = "sources: &s [" + std::string("b.plc");
  for (int i = 0; i < 500; ++i) bomb += ", b.plc";
  bomb += "]\nprograms:\n";
  for (int i = 0; i < 900; ++i) bomb += "- {name: p" + std::to_string(i) + ", sources: *s}\n";
  EXPECT_THAT(folder.Errors(bomb), ElementsAre(HasSubstr("the file says too much: aliases repeat it")));
  std::string many = "programs:\n";
  for (int i = 0; i < 1001; ++i) many += "- {sources: b.plc}\n";
  EXPECT_THAT(folder.Errors(many), ElementsAre(HasSubstr("more than 1000 programs")));
}

TEST(Project, MoreValuesThanMemoryIsForAreRefusedBeforeTheyAreKept) {
  const Folder folder;
  const std::string commas(400'000, ',');
  EXPECT_THAT(folder.Errors("sources: {" + commas + "}\n"),
              ElementsAre(HasSubstr("more than 400000 values: divide the file")));
  EXPECT_THAT(folder.Errors("sources: [" + commas + "]\n"), Contains(HasSubstr("more than 400000 values")));
}

TEST(Project, AHugePatternEnds) {
  const Folder folder;
  // Each '**' would walk through everything again.
  for (int i = 0; i < 12; ++i) folder.Write("d" + std::to_string(i) + "/e/f/g/h/x.txt", "");
  std::string pattern;
  for (int i = 0; i < 8; ++i) pattern += "**/*/";
  EXPECT_THAT(
      folder.Errors("sources: '" + pattern + "**/*.plc'\n"),
      ElementsAre(::testing::AnyOf(HasSubstr("no file is called"), HasSubstr("names would have to be looked at"))));
}

TEST(Project, WordsInMessagesAreSafeForATerminal) {
  const Folder folder;
  EXPECT_THAT(folder.Errors("\"\\e]0;x\\a\": 1\n"), ElementsAre(::testing::Not(HasSubstr("\x1b"))));
}

}  // namespace
}  // namespace plcxx::project
