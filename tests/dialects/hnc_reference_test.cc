// What the lowering says of the program for the comparison with Clang's reading of it (ir/reference.h).

#include "transpiler/dialects/hnc/lowering/reference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace plcxx::hnc {
namespace {

using testing::ElementsAre;

// A slot has the number of its handler, counted from 1 in the order of the registrations; 0 is none. Where nothing is
// registered but one handler there is no slot.
TEST(HncReference, AHandlerIsTheNumberThatIsStored) {
  source::SourceManager sources;
  diag::Engine diagnostics;
  dialects::Request request;
  request.sources = &sources;
  request.diagnostics = &diagnostics;
  request.files.push_back(sources.AddText(
      "test.cld",
      "#include \"plc.h\"\nvoid one(int ch) { mod_M_code(ch) = -1; }\nvoid two(int ch) { mod_M_code(ch) = -1; }\n"
      "void init() { plc1_time = 16; plc2_time = 32; if (P[0]) set_mst_func(0, 'M', one);\n"
      "  if (P[1]) set_mst_func(0, 'M', two); if (P[2]) set_mst_func(0, 'M', 0); set_mst_func(1, 'M', two); }\nvoid "
      "plc1() { }\nvoid plc2() { }\n"));
  const ir::Reference reference = MakeReference(request);
  ASSERT_EQ(reference.reason, "");
  std::vector<std::string> stored;
  for (const ir::ReferenceEffect& effect : reference.effects) {
    if (effect.function != "set_mst_func") continue;
    const std::string value = effect.stores_at ? std::to_string(effect.value) : "nothing";
    stored.push_back(effect.arguments[0] + " " + effect.arguments[2] + ": " + value);
  }
  EXPECT_THAT(stored, ElementsAre("0 one: 1", "0 two: 2", "0 0: 0", "1 two: nothing"));
}

struct Described {
  source::SourceManager sources;
  diag::Engine diagnostics;
  ir::Reference reference;
};

void Describe(Described& described, const std::string& text, const std::map<std::string, std::string>& options = {}) {
  dialects::Request request;
  request.sources = &described.sources;
  request.diagnostics = &described.diagnostics;
  request.options = options;
  request.files.push_back(described.sources.AddText("test.cld", "#include \"plc.h\"\n" + text));
  described.reference = MakeReference(request);
  EXPECT_EQ(described.reference.reason, "");
}

constexpr std::string_view kWorkingEntries =
    "void init() { plc1_time = 16; plc2_time = 32; }\nvoid plc1() { work(); }\nvoid plc2() { }\n";

// What Clang hands over in another form than the routine has is compared where it is called.
TEST(HncReference, WhatHasAnotherFormIsComparedInItsCallers) {
  Described described;
  Describe(
      described,
      "struct pair { int a; char b; };\nint sum(struct pair p) { return p.a; }\nstruct pair make(int n) { struct "
      "pair p; p.a = n; p.b = 1; return p; }\nint at(int n, int *p) { return *p + n; }\nint *to() { return &R_i[3]; "
      "}\n"
      "int old(c) char c; { return c; }\nint real(f) float f; { return f; }\nint wide(d, n) double d; int n; { "
      "return d + n; }\n"
      "int now(char c, float f) { return c + f; }\nvoid plain(long l) { R_l[1] = l; }\n"
      "void work() { struct pair p; p = make(2); plain(sum(p) + at(1, to()) + old(1) + real(1.0) + wide(1.0, 2) + "
      "now(1, 2)); }\n" +
          std::string(kWorkingEntries));
  std::map<std::string, std::string> why;
  for (const ir::ReferenceFunction& function : described.reference.functions) why[function.name] = function.in_callers;
  EXPECT_EQ(why, (std::map<std::string, std::string>{{"sum", "a structure as a parameter"},
                                                     {"make", "a structure as a result"},
                                                     {"at", "a pointer as a parameter"},
                                                     {"to", "a pointer as a result"},
                                                     {"old", "a promoted parameter"},
                                                     {"real", "a promoted parameter"},
                                                     {"wide", ""},
                                                     {"now", ""},
                                                     {"plain", ""},
                                                     {"work", ""},
                                                     {"init", ""},
                                                     {"plc1", ""},
                                                     {"plc2", ""}}));
  for (const ir::ReferenceFunction& function : described.reference.functions) {
    EXPECT_EQ(function.result.has_value(), function.name == "make") << function.name;
    if (function.result) {
      EXPECT_EQ(function.result->bytes, 3U);
    }
  }
}

TEST(HncReference, VariablesAreTheBytesThatTheyHave) {
  Described described;
  Describe(described,
           "int n; const long kept = 5; unsigned char bytes[3];\nvoid work() { static int count; count++; { static int "
           "count; count++; } n = kept + bytes[n & 1]; }\n" +
               std::string(kWorkingEntries));
  std::map<std::string, std::string> variables;
  std::map<std::string, uint32_t> begins;
  for (const ir::ReferenceVariable& variable : described.reference.variables) {
    EXPECT_FALSE(variables.contains(variable.name)) << variable.name;
    variables[variable.name] = std::to_string(variable.at.bytes) + (variable.is_constant ? " constant" : "") +
                               (variable.is_table ? " table" : "");
    begins[variable.name] = variable.at.offset;
  }
  // 5.1: the areas with each of their views; 9.2: the periods.
  for (const auto& [area, bytes] : std::vector<std::pair<std::string, std::string>>{{"X", "128"},
                                                                                    {"Y", "128"},
                                                                                    {"R", "768"},
                                                                                    {"P", "200"},
                                                                                    {"B", "200"},
                                                                                    {"F", "512 table"},
                                                                                    {"G", "512 table"}}) {
    for (const char* view : {"", "_uc", "_c", "_ui", "_i", "_ul", "_l"}) {
      EXPECT_EQ(variables[area + view], bytes) << area << view;
      EXPECT_EQ(begins[area + view], 0U) << area << view;
    }
  }
  EXPECT_EQ(variables["plc1_time"], "2");
  EXPECT_EQ(variables["plc2_time"], "2");
  // One after the other in the order of their declarations.
  EXPECT_EQ(begins["kept"], begins["n"] + 2);
  EXPECT_EQ(begins["bytes"], begins["n"] + 6);
  EXPECT_EQ(variables["n"], "2");
  EXPECT_EQ(variables["kept"], "4 constant");
  EXPECT_EQ(variables["bytes"], "3");
  EXPECT_EQ(variables["work.count"], "2");
}

// Not the numbers that are kept as locals of the routine, nor pointers, which Clang keeps in another form.
TEST(HncReference, LocalsInMemoryAreDescribed) {
  Described described;
  Describe(described,
           "struct pair { int a; char b; };\nint sum(struct pair p, int n, int k) { int *q; int list[4]; int plain; "
           "static int kept; q = &n; plain = *q + k; list[p.a & 3] = plain; kept = list[1]; return kept; }\n"
           "void work() { struct pair p; p.a = 1; p.b = 2; R[0] = sum(p, 3, 4); }\n" +
               std::string(kWorkingEntries));
  for (const ir::ReferenceFunction& function : described.reference.functions) {
    std::vector<std::string> locals;
    for (const ir::ReferenceLocal& local : function.locals) {
      locals.push_back(local.name + " " + std::to_string(local.at.bytes) + (local.is_parameter ? " parameter" : ""));
    }
    if (function.name == "sum") {
      EXPECT_THAT(locals, ElementsAre("p 3 parameter", "n 2 parameter", "list 8"));
    } else if (function.name == "work") {
      EXPECT_THAT(locals, ElementsAre("p 3"));
    } else {
      EXPECT_THAT(locals, ElementsAre()) << function.name;
    }
  }
}

// 6.8: `asm cli` sets the flag and calls the host, `asm sti` clears it; disable() and enable() mean the same.
TEST(HncReference, CriticalSectionsAreStoresOfTheirFlag) {
  const auto effects = [](const std::string& text) {
    Described described;
    Describe(described, text + std::string(kWorkingEntries));
    std::vector<std::string> found;
    for (const ir::ReferenceEffect& effect : described.reference.effects) {
      if (!effect.stores_at) continue;
      EXPECT_EQ(effect.stores_at->bytes, 1U);
      EXPECT_EQ(effect.mask, 1);
      EXPECT_TRUE(effect.host.valid());
      EXPECT_TRUE(effect.arguments.empty());
      found.push_back(std::to_string(effect.value));
    }
    return found;
  };
  EXPECT_THAT(effects("void work() { asm cli; R[0]++; asm sti; }\n"), ElementsAre("1", "1", "0", "0"));
  EXPECT_THAT(effects("void work() { R[0]++; }\n"), ElementsAre());
}

TEST(HncReference, WhatTheControlHasIsCalledByName) {
  const std::string text =
      "void work() { set_axis_step(1, 200L); set_axis_jog(0, get_axis_den(2)); handwheel(0, 1, 10); }\n" +
      std::string(kWorkingEntries);
  const auto callees = [&](const std::map<std::string, std::string>& options) {
    Described described;
    Describe(described, text, options);
    std::vector<std::string> found;
    for (const ir::ReferenceCallee& callee : described.reference.callees) {
      EXPECT_NE(callee.routine.valid(), callee.host.valid()) << callee.name;
      found.push_back(callee.name + (callee.host.valid() ? " host" : ""));
    }
    return found;
  };
  EXPECT_THAT(callees({}), ElementsAre("get_axis_den", "get_handwheel", "handwheel", "set_axis_jog", "set_axis_step"));
  EXPECT_THAT(callees({{"sysfunc", "host"}}),
              ElementsAre("get_axis_den host", "handwheel host", "set_axis_jog host", "set_axis_step host"));
}

// What C leaves undefined, too: a division that faults, an access outside its object. The end of a loop that was
// annotated is this language's own.
TEST(HncReference, FaultsOfCAreNamed) {
  Described described;
  Describe(described, "void work() { R[0] = R[1] / R[2]; }\n" + std::string(kWorkingEntries));
  EXPECT_TRUE(described.reference.fault.valid());
  EXPECT_THAT(described.reference.undefined_faults, ElementsAre(1, 2));
}

}  // namespace
}  // namespace plcxx::hnc
