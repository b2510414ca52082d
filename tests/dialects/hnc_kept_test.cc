// Bodies that are taken over from the run before: after each of many edits the tree and the messages are those of a run
// that has nothing to take over.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/dialects/hnc_edited_program.h"
#include "transpiler/dialects/hnc/syntax/characters.h"

namespace plcxx::hnc {
namespace {

Texts SampleTexts() {
  Texts texts;
  const std::filesystem::path folder = std::string(PLCXX_ROOT) + "/samples/hnc/mill_xk7132";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".h") && name != "mill.cld") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    texts[name == "mill.cld" ? "main.cld" : name] = std::string(std::istreambuf_iterator<char>(file), {});
  }
  return texts;
}

constexpr const char* kDense = R"(#include "plc.h"
#include "types.h"
#define bit(g,b) (X[g]&(1<<(b)))
#define SAY(a) a
#define TWICE(f) f(); f()
typedef struct { int low; int high; } BOUNDS;
struct axis { unsigned char state; long at; BOUNDS bounds; unsigned flag : 3; };
union both { int i; unsigned char c[2]; };
enum mode { IDLE, RUN = 5, STOP };
struct axis axes[4];
enum mode mode;
static const char *const names[] = { "one", "two" };
extern int later;
int limited(v, most)
int v, most;
{
    return v > most ? most : v;  // at most
}
int plain() { return R[3]; }
static void count(struct axis *a, enum mode *m)
{
    static int n = 7;
    union both u;
    const char *text = "counted";  /* a text */
    u.i = n++;
    a->at += u.c[0] * 2L;
    a->flag = 3;
    *m = RUN;
    R[4] = text[1] + names[1][0];
}
void steps(void)
{
    int i, *p = &i;
    /*@loop_bound 8@*/
    for (i = 0; i < 4; i++) { axes[i].at = i; count(&axes[i], &mode); }
    while (bit(1, 2) && i > 0) i--;
    do i++; while (i < 9);
    switch (mode) {
    case IDLE: SAY(R[1] = 1); break;
    case RUN: { long q = 5; axes[1].at = q << 3; }
    default: mode = STOP;
    }
again:
    if (*p == 100) { *p += 1; goto again; }
    asm cli
    F_ui;
    *F_ui[3] |= 0x10;
    asm sti
    TWICE(plain);
    later = abs(i) + (unsigned char)i + 'A' + 1.5 * i;
}
int later = 12;
void init() { plc1_time = 16; plc2_time = 32; set_mst_func(0, 'M', on_m); }
void plc1() { steps(); R[0] = bounded(limited(R[1], 9)); }
void plc2() { double d = 1; R[9] |= 1; mode = R[9] ? IDLE : RUN; d *= 2; }
)";
constexpr const char* kTypes = R"(#ifndef TYPES
#define TYPES
typedef unsigned char BYTE;
int bounded(int v) { return v < 0 ? 0 : v; }
void on_m(int channel) { BYTE code = 3; R[100] = code + channel; }
#endif
)";

/// What is said once in a program, or declared in one body for others, and what of it is in which function.
constexpr const char* kShared = R"(#include "plc.h"
#define CALL(f) f()
extern int never_defined;
extern int missing_function(int);
struct point { int x; };
struct { int y; } nameless;
typedef struct { char c; } NAMED;
NAMED named[2];
int old(a) char a; { return a; }
void a1(void) { R[1] = R[2]; }
void a2(void) { never_defined = 1; R[1] = 3; }
void a3(void) { never_defined = 2; missing_function(1); }
void a4(void) { missing_function(2); gone(3); }
void a5(void) { gone(4); R[2] = 1; }
void a6(void) { extern int shared; shared = 1; }
void a7(void) { R[1] = 2; }
void a8(void) { struct point p; p.x = nameless.y; R[1] = p.x; }
void a9(void) { static NAMED n = { 3 }; named[1] = n; n.c++; }
int b1(void) { R[1] = CALL(a1); return old('c'); }
void b2(void) { const char *s = "s"; R[1] = s[0]; }
int later() { return 1; }
void b3(void) { old(1); later(); F_ui; P_ui[2] = 7; }
void b4(void) { byte q; q = 2; }
void b5(void) { q = 3; a1(); }
void b6(void) { float f = 1; unsigned char **pp; enum { E = 3 } e = E; R[1] = e; }
void init() { plc1_time = 16; plc2_time = 32; a1(); a2(); a3(); a4(); a5(); }
void plc1() { a6(); a7(); a8(); a9(); b1(); b2(); b3(); b4(); b5(); b6(); }
void plc2() { }
)";

Texts SharedTexts() { return {{"main.cld", kShared}}; }
Texts DenseTexts() { return {{"main.cld", kDense}, {"types.h", kTypes}}; }

/// What a person types, and what makes another program of all that follows.
const std::vector<std::string>& Pieces() {
  static const auto* const pieces = new std::vector<std::string>{" ",
                                                                 ";",
                                                                 "\n",
                                                                 "(",
                                                                 ")",
                                                                 "{",
                                                                 "}",
                                                                 "1",
                                                                 "x",
                                                                 "0",
                                                                 "=",
                                                                 "+ 1",
                                                                 "/*",
                                                                 "*/",
                                                                 "//",
                                                                 "\"",
                                                                 "'",
                                                                 "\\\n",
                                                                 "#\n",
                                                                 "\n#define bit(g,b) (R[g])\n",
                                                                 "\n#undef bit\n",
                                                                 "\n#if 0\n",
                                                                 "\n#endif\n",
                                                                 "\n#pragma plcxx loop_bound(4)\n",
                                                                 "\n#line 7 \"other.c\"\n",
                                                                 "\n#include \"types.h\"\n",
                                                                 "extern int later;",
                                                                 "extern int elsewhere(int);",
                                                                 "int plain(int);",
                                                                 "int limited();",
                                                                 "plain();",
                                                                 "plai();",
                                                                 "unknown(1, 2);",
                                                                 "unknown = 3;",
                                                                 "byte b;",
                                                                 "b = 1;",
                                                                 "struct q { int a; } v; v.a = 1;",
                                                                 "enum { A1, B1 = 7 };",
                                                                 "typedef int T; T t;",
                                                                 "static int n;",
                                                                 "int i;",
                                                                 "R[__LINE__] = 1;",
                                                                 "goto again;",
                                                                 "again: ;",
                                                                 "asm cli",
                                                                 "asm nop",
                                                                 "near",
                                                                 "register int k; k = 3;",
                                                                 "if (R[1]) ",
                                                                 "else ",
                                                                 "return 1;",
                                                                 "return;",
                                                                 "break;",
                                                                 "case 3: ",
                                                                 "/*@loop_bound 5@*/",
                                                                 "\"two\" ",
                                                                 "const char *s = \"new\"; R[7] = s[0];",
                                                                 "unsigned char **pp;",
                                                                 "float f; f = 2;",
                                                                 "axes[2].bounds.low++;",
                                                                 "void inner() { }",
                                                                 "int more[3] = {1, 2, 3};",
                                                                 "\xEF\xBC\x9B",
                                                                 "$",
                                                                 "_Pragma(\"x\")",
                                                                 "SAY(plain());",
                                                                 "a_name_with_more_letters_than_thirty_two = 1;",
                                                                 "void f(void) { R[3] = 3; }\n",
                                                                 "later = 3;",
                                                                 "X0.1",
                                                                 "limited(1);",
                                                                 "limited(1, 2L);",
                                                                 "*F_ui[2] = 5;",
                                                                 "Y[3] = 1;",
                                                                 "set_axis_stop(1);",
                                                                 "printf(\"x\");",
                                                                 "do ;"};
  return *pieces;
}

/// What may stand in the place of a word outside of bodies, or in front of a line.
const std::vector<std::string>& OutsidePieces() {
  static const auto* const pieces = new std::vector<std::string>{"int",
                                                                 "long",
                                                                 "char",
                                                                 "unsigned char",
                                                                 "float",
                                                                 "double",
                                                                 "struct axis",
                                                                 "union both",
                                                                 "BYTE",
                                                                 "BOUNDS",
                                                                 "NAMED",
                                                                 "const",
                                                                 "static",
                                                                 "extern",
                                                                 "typedef",
                                                                 "mode",
                                                                 "axes",
                                                                 "axis",
                                                                 "both",
                                                                 "later",
                                                                 "plain",
                                                                 "limited",
                                                                 "bounded",
                                                                 "count",
                                                                 "steps",
                                                                 "names",
                                                                 "named",
                                                                 "nameless",
                                                                 "point",
                                                                 "bit",
                                                                 "SAY",
                                                                 "TWICE",
                                                                 "CALL",
                                                                 "a1",
                                                                 "a7",
                                                                 "b1",
                                                                 "old",
                                                                 "low",
                                                                 "high",
                                                                 "at",
                                                                 "state",
                                                                 "flag",
                                                                 "IDLE",
                                                                 "RUN",
                                                                 "STOP",
                                                                 "x",
                                                                 "y",
                                                                 "c",
                                                                 "v",
                                                                 "R",
                                                                 "X",
                                                                 "plc1",
                                                                 "plc2",
                                                                 "0",
                                                                 "1",
                                                                 "5",
                                                                 "7",
                                                                 "12",
                                                                 "*",
                                                                 "[3]",
                                                                 "(",
                                                                 ")",
                                                                 ";",
                                                                 "= 3",
                                                                 "void",
                                                                 "enum mode",
                                                                 "",
                                                                 "int later;",
                                                                 "extern long later;",
                                                                 "int plain();",
                                                                 "int plain(int);",
                                                                 "static int plain(void);",
                                                                 "int axes;",
                                                                 "struct axis { int at; };",
                                                                 "struct axis;",
                                                                 "enum mode { IDLE, RUN = 6, STOP };",
                                                                 "typedef int BOUNDS;",
                                                                 "typedef char BYTE;",
                                                                 "struct { struct point { long x; } p; } holder;",
                                                                 "enum { MOST = 3 };",
                                                                 "const int MOST = 4;",
                                                                 "#define bit(g,b) (X[g]&(2<<(b)))",
                                                                 "#undef bit",
                                                                 "#define R X",
                                                                 "#define MOST 9",
                                                                 "#define at state",
                                                                 "#define SAY(a) a; a",
                                                                 "#define int long",
                                                                 "#define TWICE(f) f ## f()",
                                                                 "#pragma option -K",
                                                                 "int limited();",
                                                                 "extern int bounded(int);",
                                                                 "int missing_function(int v) { return v; }",
                                                                 "int never_defined = 3;",
                                                                 "int q;",
                                                                 "void gone(int v) { R[7] = v; }",
                                                                 "int abs(int v) { return v; }",
                                                                 "int i;",
                                                                 "char text;",
                                                                 "extern char P_ui;",
                                                                 "int fresh(void) { return IDLE + R[8]; }",
                                                                 "#if 0",
                                                                 "#endif",
                                                                 "#include \"types.h\"",
                                                                 "/* open",
                                                                 "*/",
                                                                 "{",
                                                                 "}"};
  return *pieces;
}

class Edits {
 public:
  Edits(const Texts& texts, uint32_t seed) : originals_(texts), random_(seed) {
    for (const auto& [name, text] : texts) names_.push_back(name);
  }

  /// One more change; every few of them the program is as it was.
  void Apply(EditedProgram& program) {
    if (IsUndone(program)) return;
    const std::string& name = names_[Below(names_.size())];
    std::string text = program.texts().at(name);
    const size_t at = Below(text.size() + 1);
    switch (Below(8)) {
      case 0:
        text.erase(at, Below(3) + 1);
        break;
      case 1:
        text.erase(at, Below(40));
        break;
      case 2:
        text.insert(AtLine(text, at), Pieces()[Below(Pieces().size())]);
        break;
      case 3:  // another place of the same text
        text.insert(at, text.substr(Below(text.size() + 1), Below(30)));
        break;
      default:
        text.insert(BehindStatement(text, at), Pieces()[Below(Pieces().size())]);
    }
    program.Set(name, std::move(text));
  }

  /// The same for what stands outside of bodies: a word, a line, two lines.
  void ApplyOutside(EditedProgram& program) {
    if (IsUndone(program)) return;
    const std::string& name = names_[Below(names_.size())];
    std::string text = program.texts().at(name);
    const std::vector<source::Range> lines = LinesOutside(text);
    if (lines.empty()) return;
    const source::Range line = lines[Below(lines.size())];
    const std::string written = text.substr(line.begin, line.end - line.begin);
    switch (Below(8)) {
      case 0:
        text.erase(line.begin, line.end - line.begin);
        break;
      case 1:  // it stands later, or twice
        text.insert(lines[Below(lines.size())].begin, written);
        break;
      case 2:
        text.insert(line.begin, OutsidePieces()[Below(OutsidePieces().size())] + "\n");
        break;
      default: {
        const std::vector<source::Range> words = WordsIn(text, line);
        if (words.empty()) return;
        const source::Range word = words[Below(words.size())];
        text.replace(word.begin, word.end - word.begin, OutsidePieces()[Below(OutsidePieces().size())]);
      }
    }
    program.Set(name, std::move(text));
  }

 private:
  bool IsUndone(EditedProgram& program) {
    if (Below(3) != 0) return false;
    for (const auto& [name, text] : originals_) program.Set(name, text);
    return Below(3) == 0;
  }
  /// With their ends, those that begin outside of braces.
  static std::vector<source::Range> LinesOutside(const std::string& text) {
    std::vector<source::Range> lines;
    int depth = 0;
    for (size_t at = 0; at < text.size();) {
      const size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
      if (depth == 0) lines.push_back({static_cast<source::Offset>(at), static_cast<source::Offset>(end)});
      for (; at < end; ++at) depth += text[at] == '{' ? 1 : text[at] == '}' ? -1 : 0;
    }
    return lines;
  }
  static std::vector<source::Range> WordsIn(const std::string& text, source::Range line) {
    std::vector<source::Range> words;
    for (source::Offset at = line.begin; at < line.end; ++at) {
      if (!IsWord(text[at])) continue;
      const source::Offset begin = at;
      while (at < line.end && IsWord(text[at])) ++at;
      words.push_back({begin, at});
    }
    return words;
  }

  size_t Below(size_t limit) { return limit == 0 ? 0 : random_() % limit; }
  static size_t AtLine(const std::string& text, size_t at) { return std::min(text.find('\n', at), text.size()); }
  static size_t BehindStatement(const std::string& text, size_t at) {
    const size_t end = text.find(';', at);
    return end == std::string::npos ? at : end + 1;
  }

  Texts originals_;
  std::mt19937 random_;
  std::vector<std::string> names_;
};

std::string AllOf(const Texts& texts) {
  std::string all;
  for (const auto& [name, text] : texts) all += "\n--- " + name + "\n" + text;
  return all;
}

enum class Place : uint8_t { kAnywhere, kOutside };

void EditAndCompare(const Texts& texts, uint32_t seed, uint32_t count, Place place = Place::kAnywhere) {
  EditedProgram program(texts);
  Edits edits(texts, seed);
  ASSERT_EQ(program.Difference(), "");
  uint32_t runs_that_took_over = 0;
  for (uint32_t i = 0; i < count; ++i) {
    const Texts before = program.texts();
    place == Place::kOutside ? edits.ApplyOutside(program) : edits.Apply(program);
    ASSERT_EQ(program.Difference(), "") << "edit " << i << " of seed " << seed << AllOf(before)
                                        << "\n=== is now ===" << AllOf(program.texts());
    if (program.taken_over() > 0) ++runs_that_took_over;
  }
  EXPECT_GT(runs_that_took_over * 6, count) << "it is about what is taken over";
  if (std::getenv("PLCXX_KEPT_EDITS") != nullptr) std::printf("%u of %u\n", runs_that_took_over, count);
}

uint32_t EditCount(uint32_t usual) {
  const char* const wanted = std::getenv("PLCXX_KEPT_EDITS");
  return wanted == nullptr ? usual : static_cast<uint32_t>(std::atoi(wanted));
}

uint32_t Seed() {
  const char* const wanted = std::getenv("PLCXX_KEPT_SEED");
  return wanted == nullptr ? 1 : static_cast<uint32_t>(std::atoi(wanted));
}

TEST(HncKept, DenseProgram) { EditAndCompare(DenseTexts(), Seed(), EditCount(300)); }
TEST(HncKept, WhatIsSaidOnce) { EditAndCompare(SharedTexts(), Seed(), EditCount(300)); }
TEST(HncKept, OutsideOfBodies) {
  EditAndCompare(DenseTexts(), Seed(), EditCount(150), Place::kOutside);
  EditAndCompare(SharedTexts(), Seed(), EditCount(150), Place::kOutside);
}

/// What is said outside of bodies, and what of them is read again.
TEST(HncKept, WhatIsSaidOfNames) {
  struct Case {
    const char *old_part, *new_part;
    uint32_t taken_over;  // of the seven bodies
  };
  const char* const text =
      "#define TWO 2\n#define FOUR (TWO * 2)\nstruct pair { int a; char b; } pair;\nenum { ONE = 1 };\nint used[4];\n"
      "int later(int v);\nvoid f(void) { pair.a = ONE; }\nvoid g(void) { used[1] = FOUR; }\n"
      "void h(void) { R[1] = later(3); }\nint later(int v) { return v; }\n";
  const Case cases[] = {
      {"used[4];", "used[4]; ", 7},
      {"used[4];", "used[4]; long other;", 7},
      {"used[4];", "used[8];", 6},
      {"TWO 2", "TWO 3", 6},
      {"int a; char b;", "int a; long b;", 6},
      {"ONE = 1", "ZERO, ONE", 7},
      {"ONE = 1", "ONE = 2", 6},
      {"later(int v);", "later(int w);", 7},
      {"later(int v);", "later();", 5},
      {"void h(void)", "int spare;\nvoid h(void)", 7},
      {"void h(void)", "void more(void) { used[2] = 1; }\nvoid h(void)", 7},
      {"void g(void)", "#define R X\nvoid g(void)", 6},
      {"int used[4];", "", 6},
      {"void g(void)", "I void g(void)", 6},
  };
  for (const Case& each : cases) {
    EditedProgram program({{"main.cld", Program(text)}});
    EXPECT_EQ(program.Difference(), "");
    std::string changed = Program(text);
    changed.replace(changed.find(each.old_part), std::string(each.old_part).size(), each.new_part);
    program.Set("main.cld", changed);
    EXPECT_EQ(program.Difference(), "") << changed;
    EXPECT_EQ(program.taken_over(), each.taken_over) << changed;
    program.Set("main.cld", Program(text));
    EXPECT_EQ(program.Difference(), "") << changed;
  }
}
/// One change in the first function, and what it means for the others.
TEST(HncKept, WhatOneBodySaysOfOthers) {
  struct Case {
    const char *text, *old_part, *new_part;
  };
  const Case cases[] = {
      {"int gone(int);\nvoid a(void) { gone(1); }\nvoid b(void) { gone(2); }\n", "gone(1)", "R[1] = 1"},
      {"extern int gone;\nvoid a(void) { gone = 1; }\nvoid b(void) { gone = 2; }\n", "gone = 1", "R[1] = 1"},
      {"void a(void) {\n#define A 1\n}\nvoid b(void) { R[1] = A; }\n", "A 1", "A 2"},
      {"void a(void) { R[2] = 1; }\nvoid b(void) { R[1] = __LINE__; }\n", "R[2]", "\nR[2]"},
      {"void a(void) { byte q; }\nvoid b(void) { q = 1; }\n", "byte q", "R[1] = 1"},
      {"void a(void) { gone(); }\nvoid b(void) { gone(); }\n", "gone()", "R[1] = 1"},
      {"void a(void) { R[1] = 1; }\nvoid b(void) { extern int more; more = 1; }\nint more;\n", "R[1] = 1",
       "extern long more"},
      {"void a(void) { R[1] = 1; }\nvoid b(void) { R[2] = 2; }\n", "R[1] = 1", "R[1] = 1; /* open"},
      {"void a(void) { R[1] = 1; }\nvoid b(void) { R[2] = 2; }\n", "R[1] = 1", "R[1] = 1; {"},
      {"int a_name_of_thirty_three_letters_xx1;\nvoid a(void) { R[1] = 1; }\nvoid b(void) { R[2] = 2; }\n", "R[1] = 1",
       "a_name_of_thirty_three_letters_xx2 = 1"},
  };
  for (const Case& each : cases) {
    std::string text = Program(each.text);
    EditedProgram program({{"main.cld", text}});
    EXPECT_EQ(program.Difference(), "") << each.text;
    text.replace(text.find(each.old_part), std::string(each.old_part).size(), each.new_part);
    program.Set("main.cld", text);
    EXPECT_EQ(program.Difference(), "") << text;
    program.Set("main.cld", Program(each.text));
    EXPECT_EQ(program.Difference(), "") << each.text;
  }
}
TEST(HncKept, Sample) { EditAndCompare(SampleTexts(), Seed(), EditCount(40)); }

TEST(HncKept, NothingChangedTakesAllOver) {
  EditedProgram program(SampleTexts());
  EXPECT_EQ(program.Difference(), "");
  EXPECT_EQ(program.taken_over(), 0U);
  EXPECT_EQ(program.Difference(), "");
  EXPECT_GT(program.taken_over(), 20U);
}

}  // namespace
}  // namespace plcxx::hnc
