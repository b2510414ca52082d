// The front end of hnc against Clang: programs that it has understood are proved equal to Clang's own compilation, and
// what a wrong lowering would make of them is different. The typed IR is changed in one place each time, as a fault of
// the lowering would change it; unchanged it is proved, so that what differs differs by the change.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "tests/temporary_directory.h"
#include "transpiler/compilation/compilation.h"
#include "transpiler/dialects/references.h"
#include "transpiler/emit/legalize/legalize.h"
#include "transpiler/ir/builder.h"
#include "transpiler/prove/verify/front_end/front_end.h"

namespace plcxx::prove::verify::front_end {
namespace {

using verify::ProofResult;

constexpr std::string_view kVariables = R"(#include "plc.h"
int n, m; char c; unsigned u; long l; unsigned long ul; unsigned char uc; int t[4]; double d; float f;
struct { unsigned a : 3, b : 5; int s : 4; } s;
int two(int a, int b) { return 10 * a - b; }
void init() { plc1_time = 16; plc2_time = 32; }
void plc2() { }
)";

class Subject {
 public:
  explicit Subject(std::string_view body, std::string_view functions = "") {
    directory_.Write(
        "mill.cld", std::string(kVariables) + std::string(functions) + "void plc1() {\n" + std::string(body) + "\n}\n");
    compilation::CompilationRequest request;
    request.sources = {directory_.File("mill.cld")};
    compilation_ = compilation::Compile(request);
  }

  bool ok() const { return compilation_.ok(); }
  ir::Program& program() { return compilation_.program; }

  verify::RoutineProof Compare() { return Compare("plc1"); }
  verify::RoutineProof Compare(std::string_view name) {
    dialects::Request request = compilation_.MakeRequest();
    const ir::Reference reference = dialects::ReferenceOf(*compilation_.dialect)(request);
    const emit::Emittable emittable = emit::legalize::Legalize(compilation_.program, {.name = "mill"});
    const front_end::Comparison comparison = front_end::Compare(emittable, reference, verify::VerifyLimits());
    EXPECT_EQ(comparison.reason, "");
    for (const front_end::FunctionProof& function : comparison.functions) {
      if (function.proof.routine != name) continue;
      verify::RoutineProof proof = function.proof;
      if (!function.not_compared.empty()) proof.reason = "not compared: " + function.not_compared;
      return proof;
    }
    return {};
  }

  /// The instructions of a function, in the order of the program.
  template <class Change>
  bool ChangeFirst(Change&& change, std::string_view name = "plc1") {
    bool changed = false;
    for (const ir::Routine& routine : program().routines) {
      if (routine.name != name) continue;
      ir::ForEachInst(program(), routine.body, [&](ir::InstId id) { changed = changed || change(program()[id]); });
    }
    return changed;
  }

 private:
  testing_support::TemporaryDirectory directory_;
  compilation::Compilation compilation_;
};

struct Mutation {
  std::string_view name, body;
  enum class Kind : uint8_t { kOperation, kConstant, kSwap } kind;
  ir::OpKind from, to;                 // kOperation; kSwap: `from`
  uint64_t constant = 0, instead = 0;  // kConstant
};
using Kind = Mutation::Kind;
using Op = ir::OpKind;

constexpr Mutation Operation(std::string_view name, std::string_view body, Op from, Op to) {
  return {name, body, Kind::kOperation, from, to};
}
constexpr Mutation Number(std::string_view name, std::string_view body, uint64_t constant, uint64_t instead) {
  return {name, body, Kind::kConstant, Op::kConst, Op::kConst, constant, instead};
}
constexpr Mutation Swap(std::string_view name, std::string_view body, Op op) {
  return {name, body, Kind::kSwap, op, op};
}

constexpr Mutation kMutations[] = {
    Operation("sign_of_a_char", "n = c;", Op::kSignExtend8To16, Op::kWiden8To16),
    Operation("sign_of_an_unsigned_char", "n = X[1];", Op::kWiden8To16, Op::kSignExtend8To16),
    Operation("sign_of_an_int", "l = n;", Op::kSignExtend16To32, Op::kWiden16To32),
    Operation("sign_of_an_unsigned", "l = u;", Op::kWiden16To32, Op::kSignExtend16To32),
    Operation("compared_without_sign", "m = n < 5;", Op::kSignedLess16, Op::kLess16),
    Operation("compared_with_sign", "m = u < 5u;", Op::kLess16, Op::kSignedLess16),
    Operation("less_or_equal", "m = n < u;", Op::kLess16, Op::kLessEqual16),
    Operation("shift_without_sign", "n = m >> 2;", Op::kArithmeticShiftRight16, Op::kShiftRight16),
    Operation("shift_with_sign", "n = u >> 3;", Op::kShiftRight16, Op::kArithmeticShiftRight16),
    Operation("shift_of_a_long", "l = l >> 5;", Op::kArithmeticShiftRight32, Op::kShiftRight32),
    Operation("other_half", "n = l;", Op::kLowHalf32, Op::kHighHalf32),
    Operation("other_byte", "uc = n;", Op::kLowByte16, Op::kHighByte16),
    Operation("quotient_without_sign", "n = m / 3;", Op::kSignedDiv16, Op::kUnsignedDiv16),
    Operation("rest_without_sign", "n = m % 7;", Op::kSignedRem16, Op::kUnsignedRem16),
    Operation("rest_for_quotient", "u = u / 7u;", Op::kUnsignedDiv16, Op::kUnsignedRem16),
    Operation("or_for_and", "n = m & 0x1234;", Op::kAnd16, Op::kOr16),
    Operation("or_for_sum", "n = m + 5;", Op::kAdd16, Op::kOr16),
    Operation("sum_for_difference", "n = m - u;", Op::kSub16, Op::kAdd16),
    Operation("equal_for_not_equal", "n = m != u;", Op::kNotEqual16, Op::kEqual16),
    Operation("product_of_sign", "l = (long)n * m;", Op::kSignExtend16To32, Op::kWiden16To32),
    Operation("rotated_right", "if (X[1] & 4) n = m * 2; else n = m * 4;", Op::kMul16, Op::kAdd16),
    Operation("sum_of_doubles", "d = d + f;", Op::kAddF64, Op::kMulF64),
    Operation("less_or_equal_of_doubles", "n = d < 1.5;", Op::kLessF64, Op::kLessEqualF64),
    Swap("operands_swapped", "n = m - u;", Op::kSub16),
    Swap("divisor_swapped", "if (m) n = u / 3u - 1;", Op::kSub16),
    Number("constant", "n = m + 300;", 300, 301),
    Number("mask_of_a_bit_field", "s.b = X[1];", 0xF8, 0xF0),
    Number("shift_of_a_bit_field", "n = s.b;", 3, 2),
    Number("loop_step", "for (n = 0; n < 6; n += 2) m += n;", 2, 3),
    Number("loop_bound", "for (n = 0; n < 6; n++) m += n;", 6, 5),
    Number("case", "switch (n) { case 1: m = 2; break; case 3: m = 40; break; default: m = 6; }", 40, 41),
    Number("argument", "n = two(m, 77);", 77, 76),
    Number("bit_of_a_word", "*axis_ctrl(1) |= 0x40;", 0x40, 0x80),
    Number("guard_of_an_index", "n = t[m];", 3, 2),
    Number("index", "t[n & 3] = 9;", 3, 1),
};

bool Apply(const Mutation& mutation, ir::Inst& inst) {
  switch (mutation.kind) {
    case Kind::kOperation:
      if (inst.op != mutation.from) return false;
      inst.op = mutation.to;
      return true;
    case Kind::kSwap:
      if (inst.op != mutation.from) return false;
      std::swap(inst.a, inst.b);
      return true;
    case Kind::kConstant:
      if (inst.op != ir::OpKind::kConst || ir::ConstantValue(inst) != mutation.constant) return false;
      inst.a = static_cast<uint32_t>(mutation.instead);
      return true;
  }
  return false;
}

class FrontEndMutation : public ::testing::TestWithParam<Mutation> {};

TEST_P(FrontEndMutation, IsDifferent) {
  Subject subject(GetParam().body);
  ASSERT_TRUE(subject.ok());
  const verify::RoutineProof right = subject.Compare();
  ASSERT_EQ(right.result, ProofResult::kProved) << right.reason;
  ASSERT_TRUE(subject.ChangeFirst([](ir::Inst& inst) { return Apply(GetParam(), inst); }));
  const verify::RoutineProof wrong = subject.Compare();
  EXPECT_EQ(wrong.result, ProofResult::kDifferent) << wrong.reason;
}

INSTANTIATE_TEST_SUITE_P(All, FrontEndMutation, ::testing::ValuesIn(kMutations),
                         [](const auto& mutation) { return std::string(mutation.param.name); });

struct Program {
  std::string_view name, body;
  std::string_view functions = "";
};
constexpr Program kProved[] = {
    {"what_faults", "n = m / u; t[n] = l % m; n = t[u];"},
    {"shifts_by_any_count", "n = m << u; u = u >> n; l = l >> c; ul = ul << n; n = m >> u;"},
    {"local_in_memory", "int a[3]; a[n & 1] = m; n = a[0] + a[2];"},
    {"least_long_by_minus_1", "if (l) m = ul / l; if (n) l = l / (long)n;"},
    {"odd_addresses", "*(unsigned *)&R[301] = u; n = *(int *)&R[303];"},
    {"library", "n = abs(m); u = abs(c);"},
    {"critical_section", "asm cli\nn++;\nasm sti\n"},
    {"annotated_loop", "/*@loop_bound 9@*/\nwhile (n != X[0]) n++;"},
    {"control", "set_axis_home(1, n); l = get_axis_pos(2);"},
    {"control_that_gives_a_bit", "l = get_axis_den(n); uc = get_axis_pos(0) > get_axis_den(0);"},
    {"order_of_arguments", "n = two(n++, n++);"},
    {"pointers_as_parameters", "swap(&n, &m); swap(&t[n & 3], n > 5 ? &m : &n);",
     "void swap(int *a, int *b) { int c = *a; *a = *b; *b = c; }\n"},
    {"structures_as_parameters_and_results", "p = turned(turned(p)); n = turned(p).y;",
     "struct pair { int x, y; } p;\n"
     "struct pair turned(struct pair a) { struct pair b; b.x = a.y; b.y = a.x; a.x = 0; return b; }\n"},
    {"promoted_parameters", "n = low(m, f);", "int low(k, r) unsigned char k; float r; { return k + (r > 1.5); }\n"},
    {"floats_to_integers", "n = d; u = f * 2.5; l = n - 0.5; c = d; ul = f; uc = d;"},
    {"integers_to_floats", "f = l; d = ul; f--; ++f; n = f;"},
    {"constant_shift_counts", "n = m << 16; u = u >> 17; l = l >> 40; ul = ul << 32;"},
    // Clang has these in unsigned, and they are the same.
    {"stepped_bit_field_as_it_is", "n = s.b++ < 31 && s.a-- + 1 > 3; l = s.b++; d = s.a--; uc /= s.a++ + 1;"},
    {"stepped_bit_field_in_sums", "n = s.b++ - m; m = ~s.a-- * n; n += -s.b++; u = s.a++ - 9 < u;"},
    {"stepped_bit_field_chosen", "n = m ? s.a++ - 9 : n; t[(s.b++ - 3) & 1] = m >> (s.b-- - 9);"},
    {"stepped_bit_field_in_a_switch", "switch (s.b++ - 5) { case -1: n = 3; break; case 7: n = 2; }"},
    {"stepped_bit_field_with_sign", "l = s.s++ - 5; n = s.s-- < m;"},
    {"stepped_bit_field_before", "l = ++s.a - 5; n = --s.b < m;"},
    {"stepped_bit_field_beside_unsigned", "l = s.a++ - u; n = s.b-- - u > 5u;"},
};

class FrontEndProgram : public ::testing::TestWithParam<Program> {};

TEST_P(FrontEndProgram, IsProved) {
  Subject subject(GetParam().body, GetParam().functions);
  ASSERT_TRUE(subject.ok());
  const verify::RoutineProof proof = subject.Compare();
  EXPECT_EQ(proof.result, ProofResult::kProved) << proof.reason;
}

INSTANTIATE_TEST_SUITE_P(All, FrontEndProgram, ::testing::ValuesIn(kProved),
                         [](const auto& program) { return std::string(program.param.name); });

/// A function with pointers is compared in its callers, and what it does wrong is different there.
TEST(FrontEnd, ComparesInCallers) {
  Subject subject("add(&n, m); add(&m, 3);", "void add(int *a, int b) { *a += b; }\n");
  ASSERT_TRUE(subject.ok());
  EXPECT_EQ(subject.Compare("add").result, ProofResult::kProved);
  bool changed = false;
  ASSERT_TRUE(subject.ChangeFirst(
      [&](ir::Inst& inst) {
        if (inst.op != Op::kAdd16 || changed) return false;
        inst.op = Op::kSub16;
        return changed = true;
      },
      "add"));
  EXPECT_EQ(subject.Compare().result, ProofResult::kDifferent);
  EXPECT_EQ(subject.Compare("add").result, ProofResult::kNotDecided);
}

/// What cannot be compared is named, never passed over.
TEST(FrontEnd, SaysWhatIsNotCompared) {
  Subject pointer("int *p; p = t; n = *p;");
  EXPECT_EQ(pointer.Compare().result, ProofResult::kProved);
  Subject move("memcmp(t, R, 4);");
  EXPECT_FALSE(move.ok());
}

constexpr Program kReadOtherwise[] = {
    {"compared", "n = s.a++ < m;"},
    {"compared_from_the_left", "n = -1 < s.a++;"},
    {"difference_compared", "n = s.a-- - 6 < 0;"},
    {"widened", "l = s.a++ - 5;"},
    {"cast", "l = (long)(-s.a++);"},
    {"as_a_double", "d = s.a++ - 5;"},
    {"chosen_and_widened", "l = m ? s.a++ : n;"},
    {"behind_a_comma", "l = (m++, s.a++) - 5;"},
    {"divided", "n = (s.a++ - 9) / 3;"},
    {"divisor", "n = m % (s.a++ | 1);"},
    {"shifted", "n = (s.a++ - 5) >> 1;"},
    {"divisor_of_an_assignment", "n /= s.a++ | 1;"},
    {"in_a_callee_with_a_pointer", "less(&m);", "void less(int *p) { n = s.a++ < *p; }\n"},
};

class FrontEndReadOtherwise : public ::testing::TestWithParam<Program> {};

/// The program is right, and Clang's code has another result.
TEST_P(FrontEndReadOtherwise, IsNotCompared) {
  Subject subject(GetParam().body, GetParam().functions);
  ASSERT_TRUE(subject.ok());
  const verify::RoutineProof proof = subject.Compare();
  EXPECT_THAT(proof.reason, ::testing::StartsWith("not compared: the value of a bit-field after a postfix"));
  EXPECT_EQ(subject.Compare("init").result, ProofResult::kProved);
}

INSTANTIATE_TEST_SUITE_P(All, FrontEndReadOtherwise, ::testing::ValuesIn(kReadOtherwise),
                         [](const auto& program) { return std::string(program.param.name); });

constexpr std::string_view kStructures = R"(struct pair { int a, b; } p;
struct pair make() { p.a = 50; return p; }
int change() { p.a = 50; return 7; }
int right(int k, struct pair x) { return x.a + k; }
int left(struct pair x, int k) { return x.a + k; }
int both(struct pair x, struct pair y) { return x.a + y.b; }
)";

/// A structure that is named behind what writes it is copied before that is evaluated; Clang copies it after.
TEST(FrontEnd, StructuresThatClangCopiesTooLate) {
  for (const std::string_view body :
       {"n = right(change(), p);", "n = right(p.a++, p);", "n = both(make(), p);", "n = m ? right(p.a = 5, p) : 0;"}) {
    Subject subject(body, kStructures);
    ASSERT_TRUE(subject.ok()) << body;
    EXPECT_THAT(subject.Compare().reason, ::testing::StartsWith("not compared: a structure is copied")) << body;
  }
  for (const std::string_view body :
       {"n = left(p, change());", "n = right(m, p);", "n = both(p, make());", "n = right(change(), make());"}) {
    Subject subject(body, kStructures);
    ASSERT_TRUE(subject.ok()) << body;
    const verify::RoutineProof proof = subject.Compare();
    EXPECT_EQ(proof.result, ProofResult::kProved) << body << ": " << proof.reason;
  }
}

/// What calls such a function is compared, whatever that does.
TEST(FrontEnd, ComparesCallersOfWhatIsReadOtherwise) {
  Subject subject("n = low(m) - u;", "int low(int k) { return s.a++ < k; }\n");
  ASSERT_TRUE(subject.ok());
  EXPECT_THAT(subject.Compare("low").reason, ::testing::StartsWith("not compared: "));
  const verify::RoutineProof right = subject.Compare();
  EXPECT_EQ(right.result, ProofResult::kProved) << right.reason;
  ASSERT_TRUE(subject.ChangeFirst([](ir::Inst& inst) { return Apply(Swap("", "", Op::kSub16), inst); }));
  EXPECT_EQ(subject.Compare().result, ProofResult::kDifferent);
}

/// What is multiplied and divided is chosen by what an axis says, which the two sides read in other ways.
TEST(FrontEnd, AProductOfWhatAnIndexChooses) {
  Subject subject("int a; for (a = 0; a < 3; a++) jog(a);",
                  "void jog(int a) {\n"
                  "  int d = X[2] >> a & 1 ? 1 : X[3] >> a & 1 ? -1 : 0;\n"
                  "  int speed = X[1] & 4 && *axis_stat(a) & 64 ? P_i[1] : P_i[0];\n"
                  "  if (d != 0) set_axis_jog(a, (int) ((long) speed * *ch_feedover(0) / 100) * d);\n"
                  "}\n");
  ASSERT_TRUE(subject.ok());
  const verify::RoutineProof proof = subject.Compare("jog");
  EXPECT_EQ(proof.result, ProofResult::kProved) << proof.reason;
}

}  // namespace
}  // namespace plcxx::prove::verify::front_end
