// Each construct of C inside of each other one: what plcxx says of the program, and what it becomes, is as it was when
// it was kept. A program that somebody writes has the usual ones in the usual places; here stand a goto that leads into
// an arm, a case in an if, an array as a condition, a record that a function gives as an index. Kept are hashes.
#include <gtest/gtest.h>

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "tests/printed/hashes.h"
#include "tests/printed/printed.h"

namespace plcxx::printed {
namespace {

const fs::path kHashes = fs::path(PLCXX_ROOT) / "tests/printed/nested.txt";
constexpr Phase kSaidOfNested{"said", SaidOf, ""};

// '@' is what stands inside, '#' a number for the names of an outer and an inner construct.
constexpr std::array kStatements = {
    std::string_view("@"),
    std::string_view("if (b) @"),
    std::string_view("if (u < 8) { n = u; @ table[n & 15] = 2; }"),
    std::string_view("if (u > 7) a = 1; else { @ table[u] = 1; }"),
    std::string_view("while (a < 5) { a++; @ }"),
    std::string_view("do { a++; @ } while (a < 5);"),
    std::string_view("for (i# = 0; i# < 8; i#++) { @ table[i#] = 1; }"),
    std::string_view("for (;;) { a = 2; @ break; }"),
    std::string_view("for (;;) { @ }"),
    std::string_view("while (1) { if (X[1]) break; @ }"),
    std::string_view("do { @ } while (0);"),
    std::string_view("while (0) { @ }"),
    std::string_view("switch (X[2]) { case 1: a = 1; case 2: @ break; default: a = 3; }"),
    std::string_view("switch (n) { a = 5; default: a = 4; break; case 3: case 4: @ table[n] = 1; }"),
    std::string_view("switch (X[2]) @"),
    std::string_view("switch (X[2]) if (b) { case 1: @ } else case 2: b = 3;"),
    std::string_view("if (b) goto l#; a = 1; l#: @"),
    std::string_view("l#: a++; @ if (a < 5) goto l#;"),
    std::string_view("a = 0; l#: if (a < 5) { a++; @ goto l#; }"),
    std::string_view("if (b) goto l#; if (u < 8) { n = u; @ l#: table[n & 15] = 2; } else a = 3;"),
    std::string_view("{ int v# = a; @ v#++; a = v#; }"),
    std::string_view("disable(); @ enable();"),
    std::string_view("return;"),
    std::string_view("break;"),
    std::string_view("continue;"),
    std::string_view("goto out;"),
    std::string_view("case 7: @"),
    std::string_view("{ int w; a = w; w = 1; }"),
    std::string_view("p = b ? &a : table; *p = 3;"),
    std::string_view("r = b ? t : record();"),
    std::string_view(";"),
};

constexpr std::array kOuter = {
    std::string_view("a = @;"),
    std::string_view("u = @;"),
    std::string_view("l = @;"),
    std::string_view("c = @;"),
    std::string_view("f = @;"),
    std::string_view("p = @;"),
    std::string_view("r = @;"),
    std::string_view("s.three = @;"),
    std::string_view("s.four = @;"),
    std::string_view("@;"),
    std::string_view("if (@) b = 1; table[u] = 1;"),
    std::string_view("if (!(@)) return; table[u] = 1;"),
    std::string_view("table[@] = 1;"),
    std::string_view("a = (@) + 1;"),
    std::string_view("l = 5 - (@);"),
    std::string_view("a = (@) * 3;"),
    std::string_view("a = (@) / 3 + 7 / (@);"),
    std::string_view("a = (@) % 8;"),
    std::string_view("a = (@) << 2;"),
    std::string_view("a = (@) >> 2;"),
    std::string_view("a = 1 << (@);"),
    std::string_view("table[(@) & 15] = 3;"),
    std::string_view("a = (@) < 5;"),
    std::string_view("a = 200 >= (@);"),
    std::string_view("a = (@) == 0;"),
    std::string_view("if ((@) != c) b = 2;"),
    std::string_view("a = -(@);"),
    std::string_view("l = ~(@);"),
    std::string_view("a = (@) && b;"),
    std::string_view("if (b || (@)) a = 1;"),
    std::string_view("a = b ? (@) : c;"),
    std::string_view("a = (@) ? b++ : c--;"),
    std::string_view("a = (b++, (@));"),
    std::string_view("a += @;"),
    std::string_view("c -= @;"),
    std::string_view("l <<= @;"),
    std::string_view("f *= @;"),
    std::string_view("p += @; *p = 1;"),
    std::string_view("(@)++;"),
    std::string_view("--(@);"),
    std::string_view("@ = 3;"),
    std::string_view("*(@) = 1;"),
    std::string_view("(@)[1] = 2;"),
    std::string_view("a = (@).x;"),
    std::string_view("a = give(@);"),
    std::string_view("take(@, @);"),
    std::string_view("a = sum(@).x;"),
    std::string_view("memset(@, 0, 2);"),
    std::string_view("a = memcmp(table, @, 4);"),
    std::string_view("u = (unsigned char)(@);"),
    std::string_view("l = (long)(@);"),
    std::string_view("switch (@) { case 1: a = 1; break; case 70000: a = 2; }"),
    std::string_view("while (@) { a++; break; }"),
    std::string_view("for (i1 = 0; i1 < (@); i1++) b++;"),
    std::string_view("for (i1 = (@); i1 > 0; i1--) table[i1] = 1;"),
    std::string_view("p = (@) + 1; a = *p;"),
    std::string_view("a = (@) - p;"),
    std::string_view("a = (@) == p;"),
    std::string_view("a = abs(@);"),
};

constexpr std::array kInner = {
    std::string_view("a"),          std::string_view("c"),         std::string_view("u"),
    std::string_view("l"),          std::string_view("f"),         std::string_view("3"),
    std::string_view("0"),          std::string_view("-1"),        std::string_view("70000"),
    std::string_view("1.5"),        std::string_view("\"ab\""),    std::string_view("table"),
    std::string_view("&a"),         std::string_view("p"),         std::string_view("*p"),
    std::string_view("q + 1"),      std::string_view("table[2]"),  std::string_view("table[a & 15]"),
    std::string_view("r"),          std::string_view("r.x"),       std::string_view("s.three"),
    std::string_view("s.four"),     std::string_view("X[1]"),      std::string_view("P_i[2]"),
    std::string_view("a++"),        std::string_view("--c"),       std::string_view("a = 5"),
    std::string_view("u += 2"),     std::string_view("give(a)"),   std::string_view("point()"),
    std::string_view("record()"),   std::string_view("nothing()"), std::string_view("u > 8"),
    std::string_view("u < 8 && b"), std::string_view("b ? u : 9"), std::string_view("b ? &a : table"),
    std::string_view("b ? p : 0"),  std::string_view("(b++, c)"),  std::string_view("p - q"),
    std::string_view("p == &a"),    std::string_view("!a"),        std::string_view("~c"),
    std::string_view("(char)l"),    std::string_view("sizeof r"),  std::string_view("nowhere"),
    std::string_view("EIGHT"),      std::string_view("&table[3]"), std::string_view("(int *)0x1234"),
    std::string_view("words[1]"),   std::string_view("k"),
};

constexpr std::array kResults = {
    std::string_view("void"),  std::string_view("int"),   std::string_view("char"),     std::string_view("long"),
    std::string_view("float"), std::string_view("int *"), std::string_view("struct s"), std::string_view("unsigned"),
};
constexpr std::array kBodies = {
    std::string_view(""),
    std::string_view("return;"),
    std::string_view("if (b) return; return a;"),
    std::string_view("if (b) return 7;"),
    std::string_view("return a ? c : l;"),
    std::string_view("return f;"),
    std::string_view("return &a;"),
    std::string_view("if (b) return p; return 0;"),
    std::string_view("return table + 1;"),
    std::string_view("int own = 3; return &own;"),
    std::string_view("static int own; own++; return &own;"),
    std::string_view("int own[4]; own[1] = 2; return own;"),
    std::string_view("struct s own; own.x = 2; own.y = a; return own;"),
    std::string_view("return r;"),
    std::string_view("return record();"),
    std::string_view("return nowhere;"),
    std::string_view("for (;;) { if (b) return 4; break; } return 5;"),
    std::string_view("switch (X[1]) { case 1: return 4; default: return 6; }"),
    std::string_view("l: if (b) return 4; b++; goto l;"),
};

constexpr std::string_view kBefore =
    "#include <string.h>\n#include <stdlib.h>\n#include \"plc.h\"\nenum { EIGHT = 8 };\n"
    "int a, b, n, i1, i2, *p = &a, *q, table[8]; unsigned u; long l; unsigned char c; float f; const int k = 6;\n"
    "char *const words[] = { \"on\", \"off\" };\nstruct s { int x, y; } r, t; struct { unsigned three : 3; int four : "
    "4; } s;\n"
    "int give(int v) { return v > 9 ? 9 : v; }\nint *point() { return b ? &a : table; }\nstruct s record() { return t; "
    "}\n"
    "void nothing() { }\nvoid take(int v, int *w) { a = v; *w = 1; }\nstruct s sum(int v) { t.x = v; return t; }\n";
constexpr std::string_view kBehind =
    "\nvoid init() { plc1_time = 16; plc2_time = 32; q = &table[2]; }\nvoid plc2() { nothing(); take(1, &b); sum(2); "
    "}\n";

std::string Replaced(std::string_view text, char mark, std::string_view with) {
  std::string out;
  for (const char c : text) {
    if (c == mark) {
      out += with;
    } else {
      out += c;
    }
  }
  return out;
}

std::string Plc1(std::string_view statement) { return "void plc1() { " + std::string(statement) + " a = b; out: ; }"; }

std::string Statement(size_t outer, size_t inner) {
  const std::string within = Replaced(Replaced(kStatements[inner], '@', "b = a;"), '#', "2");
  return Plc1(Replaced(Replaced(kStatements[outer], '#', "1"), '@', within));
}
std::string Expression(size_t outer, size_t inner) { return Plc1(Replaced(kOuter[outer], '@', kInner[inner])); }
std::string Function(size_t outer, size_t inner) {
  const std::string result(kResults[outer]);
  return result + " made() { " + std::string(kBodies[inner]) + " }\n" +
         Plc1(result == "void"       ? "made();"
              : result == "int *"    ? "p = made(); *p = 1;"
              : result == "struct s" ? "r = made();"
                                     : "a = made();");
}

/// Of one outer construct the programs with each inner one, or with each second one.
void ExpectKeptOf(const std::string& name, size_t count, size_t step, std::string (*program)(size_t, size_t),
                  size_t outer) {
  HashRow now{name + '_' + std::to_string(outer), {}};
  const auto text = [&](size_t inner) { return std::string(kBefore) + program(outer, inner) + std::string(kBehind); };
  for (size_t inner = outer % step; inner < count; inner += step) {
    Input input;
    input.request.dialect = "hnc";
    input.request.sources = {"p.cld"};
    input.request.texts = {{"p.cld", text(inner)}};
    now.hashes.push_back(HashOf(OwnTextOf(kSaidOfNested, input)));
  }
  ExpectKept(kHashes, now, [&](size_t number) { return program(outer, outer % step + number * step); });
}

class NestedStatements : public testing::TestWithParam<size_t> {};
TEST_P(NestedStatements, AreAsKept) { ExpectKeptOf("statement", kStatements.size(), 1, Statement, GetParam()); }
INSTANTIATE_TEST_SUITE_P(hnc, NestedStatements, testing::Range<size_t>(0, kStatements.size()));

class NestedExpressions : public testing::TestWithParam<size_t> {};
TEST_P(NestedExpressions, AreAsKept) { ExpectKeptOf("expression", kInner.size(), 2, Expression, GetParam()); }
INSTANTIATE_TEST_SUITE_P(hnc, NestedExpressions, testing::Range<size_t>(0, kOuter.size()));

class NestedReturns : public testing::TestWithParam<size_t> {};
TEST_P(NestedReturns, AreAsKept) { ExpectKeptOf("function", kBodies.size(), 1, Function, GetParam()); }
INSTANTIATE_TEST_SUITE_P(hnc, NestedReturns, testing::Range<size_t>(0, kResults.size()));

}  // namespace
}  // namespace plcxx::printed
