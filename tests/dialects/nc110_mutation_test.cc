// Random sequences of tokens: whatever the text, the tree is whole, in order, and nothing crashes.
#include <cstdint>

#include "tests/dialects/nc110_parsing.h"

namespace plcxx::nc110 {
namespace {

constexpr const char* kPieces[] = {
    "U4A0", "=",     "I0A0", "W1K0", "*",     "+",   "&",     "-",    "/",        "(",
    ")",    "[",     "]",    "<",    ">",     ",",   ":",     "DOF",  "DOE",      "ENDF",
    "ENDE", "END F", "DOW",  "ENDW", "MUX",   "ENC", "SGN",   "ABS",  "T5I",      "C5I",
    "C5W",  "P6",    "MSG",  "5",    "\"A\"", "\"",  "!",     "!X",   "$",        "\n",
    ";c\n", "%",     "А",    "FOO",  "END",   "256", "I99A0", "0FFH", "T5I(30)=", "W1K0=MUX(W1K0),(I0A0)"};

/// The same numbers on every machine.
class Numbers {
 public:
  explicit Numbers(uint64_t seed) : state_(seed) {}
  uint32_t Below(size_t limit) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<uint32_t>((state_ >> 33) % limit);
  }

 private:
  uint64_t state_;
};

void ExpectWhole(const Parsed& parsed, const std::string& text) {
  const Program& program = parsed.program;
  source::Offset last = 0;
  uint32_t comments = 0;
  for (const Item& item : program.items) {
    ASSERT_GE(item.range.begin, last) << text;
    ASSERT_GT(item.range.end, item.range.begin) << text;
    ASSERT_TRUE(!item.faulty || parsed.diagnostics.HasErrors()) << text;
    last = item.range.end;
    comments += item.comment_count;
  }
  for (const SourceFile& file : program.files) {
    comments += file.header.count + file.rest.count;
  }
  ASSERT_EQ(comments, program.comments.size()) << text;
  for (uint32_t i = 0; i < program.exprs.size(); ++i) {
    const Expr& expr = program.exprs[ExprId(i)];
    ASSERT_TRUE(!expr.left.valid() || expr.left.index < i) << text;
    ASSERT_TRUE(!expr.right.valid() || expr.right.index < i) << text;
    ASSERT_LE(expr.range.begin, expr.range.end) << text;
  }
  for (const Assignment& assignment : program.assignments) {
    ASSERT_NE(assignment.value.valid(), assignment.mux.valid()) << text;
  }
}

TEST(Nc110Mutations, TheTreeIsAlwaysWhole) {
  Numbers numbers(1);
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::string> files(2);
    for (std::string& text : files) {
      for (uint32_t count = numbers.Below(60); count > 0; --count) {
        text += kPieces[numbers.Below(std::size(kPieces))];
        text += numbers.Below(3) == 0 ? "" : " ";
      }
    }
    ParseOptions options;
    options.enable_dow = numbers.Below(2) == 0;
    options.strict_case = numbers.Below(5) == 0;
    options.accept_homoglyphs = numbers.Below(2) == 0;
    Parsed parsed;
    ParseInto(parsed, files, options);
    ExpectWhole(parsed, files[0] + "\n----\n" + files[1]);
    EXPECT_FALSE(PrintSyntax(parsed.sources, parsed.program).empty());
  }
}

}  // namespace
}  // namespace plcxx::nc110
