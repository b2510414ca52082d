// Snippets of C++, compiled by Clang and executed on symbols, against the same computed here: memory, branches, loops,
// indices, calls and the host; and what must be refused.
#include "transpiler/prove/verify/compiled_code.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "transpiler/compile/target.h"
#include "transpiler/compile/toolchain.h"
#include "transpiler/prove/verify/bitcode.h"
#include "transpiler/symbolic/solver/solver.h"
#include "transpiler/symbolic/terms/evaluate.h"

namespace plcxx::prove {
namespace {

constexpr uint32_t kBytes = 32;
using Bytes = std::array<uint8_t, kBytes>;
constexpr int kSamples = 200;
constexpr uint32_t kSolverMs = 10'000;

constexpr const char* kHead = R"(#include <stdint.h>
namespace t {
struct Host;
struct State { uint8_t b[16]; uint32_t w[4]; };
uint32_t ask(Host& host, uint32_t what) noexcept;
void tell(Host& host, bool yes) noexcept;
void both(Host& host, uint32_t& second) noexcept;
)";

/// Remembers calls; answers what it was asked, plus 1.
class EchoHost : public verify::CodeEnvironment {
 public:
  explicit EchoHost(terms::Terms& terms) : terms_(terms) {}
  terms::TermId Initial(uint32_t slot) override {
    return slot < kBytes ? terms_.Variable("b" + std::to_string(slot), 8) : terms_.Const(0, 64);
  }
  terms::TermId CallHost(verify::CodeMemory& memory, const verify::HostRequest& request,
                         std::string& refusal) override {
    memory.Write(kBytes, terms_.Add(memory.Read(kBytes), terms_.Const(1, 64)));
    if (request.function == "t::ask" && request.arguments.size() == 2)
      return terms_.Add(request.arguments[1].value, terms_.Const(1, 32));
    if (request.function == "t::both" && request.arguments.size() == 2) {
      for (uint32_t i = 0; i < 4; ++i) memory.Write(request.arguments[1].slot + i, terms_.Const(i + 1, 8));
      return {};
    }
    if (request.function != "t::tell") refusal = "unknown: " + std::string(request.function);
    return {};
  }

 private:
  terms::Terms& terms_;
};

class CompiledCodeTest : public ::testing::Test {
 protected:
  verify::CodeOutcome Execute(const std::string& body, const std::string& level = "2",
                              const std::vector<std::string>& flags = {}) {
    auto found = compile::FindToolchain(compile::Targets().front(), verify::kVerifyCompiler);
    if (std::holds_alternative<compile::MissingTool>(found)) return {.refusal = "no compiler"};
    const auto& toolchain = std::get<compile::Toolchain>(found);
    const std::vector<emit::OutputFile> files = {{.name = "t.cpp", .text = kHead + body + "\n}\n"}};
    std::vector<std::string> further = {"-Wno-everything"};
    further.insert(further.end(), flags.begin(), flags.end());
    auto compiled =
        verify::CompileToBitcode({.toolchain = &toolchain, .level = level, .files = &files, .further_flags = further});
    if (const auto* failure = std::get_if<verify::BitcodeFailure>(&compiled)) return {.refusal = failure->output};
    verify::LoadedCode loaded = verify::LoadCode(std::get<verify::Bitcode>(compiled).files);
    if (loaded.code == nullptr) return {.refusal = loaded.reason};
    EchoHost host(terms_);
    verify::CodeRun run{
        .function = "t::f", .state_bytes = kBytes, .further_slots = 1, .arguments = {}, .most_rounds = 64};
    run.arguments.push_back({.kind = verify::CodeArgument::Kind::kState, .name = "m", .value = {}});
    run.arguments.push_back({.kind = verify::CodeArgument::Kind::kHost, .name = "host", .value = {}});
    return loaded.code->Execute(terms_, host, run);
  }

  /// Executes f at several levels of optimization and compares with `expected` for random states.
  void Check(const std::string& body, const std::function<uint64_t(Bytes&)>& expected) {
    for (const char* level : {"1", "2", "s"}) {
      terms_ = terms::Terms();
      const verify::CodeOutcome outcome = Execute(body, level);
      ASSERT_EQ(outcome.refusal, "") << "-O" << level;
      ASSERT_EQ(outcome.slots.size(), kBytes + 1);
      std::mt19937 random(1);
      for (int sample = 0; sample < kSamples; ++sample) {
        Bytes bytes;
        std::vector<uint64_t> variables(terms_.variable_count());
        for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random() % (sample % 2 == 0 ? 256 : 4));
        for (uint64_t& value : variables) value = random();
        for (uint32_t v = 0; v < variables.size(); ++v) {
          const std::string& name = terms_.VariableName(v);
          if (name[0] == 'b') variables[v] = bytes[std::stoul(name.substr(1))];
        }
        const std::vector<uint64_t> values = terms::EvaluateAll(terms_, variables, terms::TermId(terms_.size() - 1));
        const uint64_t calls = expected(bytes);
        for (uint32_t i = 0; i < kBytes; ++i)
          ASSERT_EQ(values[outcome.slots[i].index], bytes[i]) << "-O" << level << ", byte " << i;
        ASSERT_EQ(values[outcome.slots[kBytes].index], calls) << "-O" << level;
        for (const verify::Obligation& obligation : outcome.obligations)
          ASSERT_EQ(values[obligation.never.index], 0U) << "-O" << level << ": " << obligation.text;
      }
    }
  }

  terms::Terms terms_;
};

uint32_t Word(const Bytes& bytes, int number) {
  const size_t at = 16 + 4 * static_cast<size_t>(number);
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | static_cast<uint32_t>(bytes[at + 3]) << 24;
}
void SetWord(Bytes& bytes, int number, uint32_t value) {
  for (size_t i = 0; i < 4; ++i) bytes[16 + 4 * static_cast<size_t>(number) + i] = static_cast<uint8_t>(value >> 8 * i);
}

TEST_F(CompiledCodeTest, Arithmetic) {
  Check(R"(void f(State& m, Host&) noexcept {
    m.w[0] = m.w[1] * 3u - (m.w[2] >> (m.b[0] & 31u));
    m.b[1] = static_cast<uint8_t>((m.b[2] << 3) ^ ~m.b[3]);
    m.w[3] = static_cast<uint32_t>(static_cast<int32_t>(m.w[3]) >> 4);
  })",
        [](Bytes& b) -> uint64_t {
          SetWord(b, 0, Word(b, 1) * 3U - (Word(b, 2) >> (b[0] & 31U)));
          b[1] = static_cast<uint8_t>((b[2] << 3) ^ ~b[3]);
          SetWord(b, 3, static_cast<uint32_t>(static_cast<int32_t>(Word(b, 3)) >> 4));
          return 0;
        });
}

TEST_F(CompiledCodeTest, BranchesJoin) {
  Check(R"(void f(State& m, Host& host) noexcept {
    if (m.b[0] > 2) {
      m.b[1] = 7;
      if (m.b[2] == 3 || m.b[3] == 1) { m.b[1]++; tell(host, true); }
    } else if (m.b[4] & 1) {
      m.b[1] = m.b[5]; return;
    }
    m.b[6] = static_cast<uint8_t>(m.b[1] + m.b[6]);
  })",
        [](Bytes& b) -> uint64_t {
          uint64_t calls = 0;
          if (b[0] > 2) {
            b[1] = 7;
            if (b[2] == 3 || b[3] == 1) {
              b[1]++;
              ++calls;
            }
          } else if ((b[4] & 1) != 0) {
            b[1] = b[5];
            return calls;
          }
          b[6] = static_cast<uint8_t>(b[1] + b[6]);
          return calls;
        });
}

/// The compiler lets all four ways meet at once: their values are chosen branch by branch all the same, as the program
/// chooses them, and not each under all that leads to it.
TEST_F(CompiledCodeTest, BranchesInBranchesJoinFromInside) {
  const std::string body = R"(void f(State& m, Host& host) noexcept {
    uint8_t value = 0;
    if (m.b[0] & 1) {
      if (m.b[1] & 1) {
        tell(host, true);
        value = m.b[2];
      } else if (m.b[3] & 1) {
        tell(host, false);
        value = m.b[4];
      } else {
        tell(host, m.b[5] & 1);
        value = m.b[6];
      }
    }
    m.b[7] = value;
  })";
  const verify::CodeOutcome outcome = Execute(body);
  ASSERT_EQ(outcome.refusal, "");
  const auto byte = [&](size_t at) { return outcome.slots[at]; };
  const auto bit = [&](size_t at) { return terms_.Extract(byte(at), 0, 1); };
  const terms::TermId inner = terms_.Ite(bit(3), byte(4), byte(6));
  EXPECT_EQ(byte(7), terms_.Ite(bit(0), terms_.Ite(bit(1), byte(2), inner), terms_.Const(0, 8)));
  Check(body, [](Bytes& b) -> uint64_t {
    const bool calls = (b[0] & 1) != 0;
    b[7] = !calls ? 0 : (b[1] & 1) != 0 ? b[2] : (b[3] & 1) != 0 ? b[4] : b[6];
    return calls ? 1 : 0;
  });
}

/// As many branches in one another as a program of rungs with jumps has.
TEST_F(CompiledCodeTest, VeryDeepBranchesJoin) {
  std::string body = "void f(State& m, Host& host) noexcept {\n";
  for (int i = 0; i < 400; ++i)
    body += "if (((m.b[" + std::to_string(i % 16) + "] ^ " + std::to_string(i) +
            ") & 63) == 0) { m.w[1] = " + std::to_string(i % 251) + "; tell(host, true); return; }\n";
  Check(body + "m.w[1] = 255; }", [](Bytes& b) -> uint64_t {
    for (size_t i = 0; i < 400; ++i) {
      if (((b[i % 16] ^ i) & 63) != 0) continue;
      SetWord(b, 1, static_cast<uint32_t>(i % 251));
      return 1;
    }
    SetWord(b, 1, 255);
    return 0;
  });
}

TEST_F(CompiledCodeTest, SwitchRunsOn) {
  Check(R"(void f(State& m, Host&) noexcept {
    switch (m.b[0] & 7) {
      case 0: m.b[1] = 1;
      case 1: m.b[2] = 2; break;
      case 3: case 5: m.b[3] = 3; break;
      default: m.b[4] = 4;
    }
  })",
        [](Bytes& b) -> uint64_t {
          const int n = b[0] & 7;
          if (n == 0) b[1] = 1;
          if (n <= 1) b[2] = 2;
          if (n == 3 || n == 5) b[3] = 3;
          if (n == 2 || n == 4 || n > 5) b[4] = 4;
          return 0;
        });
}

TEST_F(CompiledCodeTest, LoopsUnroll) {
  Check(R"(void f(State& m, Host&) noexcept {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < 10; ++i) {
      if (m.b[i] == 3) break;
      for (uint32_t k = 0; k < (m.b[15] & 3u); ++k) sum += m.b[i] + k;
    }
    m.w[0] = sum;
  })",
        [](Bytes& b) -> uint64_t {
          uint32_t sum = 0;
          for (uint32_t i = 0; i < 10; ++i) {
            if (b[i] == 3) break;
            for (uint32_t k = 0; k < (b[15] & 3U); ++k) sum += b[i] + k;
          }
          SetWord(b, 0, sum);
          return 0;
        });
}

TEST_F(CompiledCodeTest, Indices) {
  Check(R"(static const uint16_t kTable[] = {5, 700, 9, 1000};
  void f(State& m, Host&) noexcept {
    const uint32_t i = m.b[0];
    if (i < 12) { m.b[i + 2] = m.b[1]; m.w[1] = m.w[i & 3]; }
    m.b[15] = m.b[m.b[14] & 7];
    m.w[0] = kTable[m.b[3] & 3];
    uint8_t* p = m.b[4] & 1 ? &m.b[5] : reinterpret_cast<uint8_t*>(&m.w[3]);
    *p = 0x5A;
  })",
        [](Bytes& b) -> uint64_t {
          constexpr uint16_t kTable[] = {5, 700, 9, 1000};
          const uint32_t i = b[0];
          if (i < 12) {
            b[i + 2] = b[1];
            SetWord(b, 1, Word(b, static_cast<int>(i & 3)));
          }
          b[15] = b[b[14] & 7];
          SetWord(b, 0, kTable[b[3] & 3]);
          b[(b[4] & 1) != 0 ? 5 : 28] = 0x5A;
          return 0;
        });
}

TEST_F(CompiledCodeTest, CallsAndHost) {
  Check(R"([[gnu::noinline]] static uint32_t g(State& m, uint32_t& n, Host& host) {
    n += 2;
    return m.b[0] > 1 ? ask(host, n) : n;
  }
  void f(State& m, Host& host) noexcept {
    uint32_t n = m.w[0], second = 9;
    m.w[1] = g(m, n, host) + g(m, n, host);
    m.w[0] = n;
    both(host, second);
    m.w[2] = second;
  })",
        [](Bytes& b) -> uint64_t {
          const uint32_t n = Word(b, 0), more = b[0] > 1 ? 1 : 0;
          SetWord(b, 1, n + 2 + more + n + 4 + more);
          SetWord(b, 0, n + 4);
          SetWord(b, 2, 0x04030201);
          return 1 + 2 * more;
        });
}

TEST_F(CompiledCodeTest, Intrinsics) {
  Check(R"(void f(State& m, Host&) noexcept {
    m.w[0] = m.w[1] > m.w[2] ? m.w[1] - m.w[2] : 0;
    m.b[0] = static_cast<uint8_t>(m.b[1] << 3 | m.b[1] >> 5);
    const int8_t s = static_cast<int8_t>(m.b[2]);
    m.b[2] = static_cast<uint8_t>(s < 0 ? -s : s);
    m.b[3] = static_cast<uint8_t>(__builtin_popcount(m.w[3]) + __builtin_clz(m.w[3] | 1) + __builtin_ctz(m.w[3] | 0x100));
    m.w[1] = __builtin_bswap32(m.w[1]);
    uint32_t sum; if (__builtin_add_overflow(m.w[2], m.w[3], &sum)) sum = 0xFFFFFFFF;
    m.w[2] = sum;
  })",
        [](Bytes& b) -> uint64_t {
          SetWord(b, 0, Word(b, 1) > Word(b, 2) ? Word(b, 1) - Word(b, 2) : 0);
          b[0] = static_cast<uint8_t>(b[1] << 3 | b[1] >> 5);
          const auto s = static_cast<int8_t>(b[2]);
          b[2] = static_cast<uint8_t>(s < 0 ? -s : s);
          b[3] = static_cast<uint8_t>(__builtin_popcount(Word(b, 3)) + __builtin_clz(Word(b, 3) | 1) +
                                      __builtin_ctz(Word(b, 3) | 0x100));
          const uint32_t old = Word(b, 1);
          SetWord(b, 1, __builtin_bswap32(old));
          const uint64_t sum = uint64_t{Word(b, 2)} + Word(b, 3);
          SetWord(b, 2, sum > 0xFFFFFFFF ? 0xFFFFFFFF : static_cast<uint32_t>(sum));
          return 0;
        });
}

/// What C++ leaves undefined: the statement, the same behind a guard, and what an obligation says of the first.
struct Undefined {
  const char* name;
  const char* bare;
  const char* guarded;
  const char* text;
};

constexpr const char* kAddress = "an address that C++ leaves undefined";
constexpr const char* kWritten = "a write of a number that C++ leaves undefined";
constexpr Undefined kUndefined[] = {
    {"DivisionByZero", "m.w[0] = m.w[1] / m.w[2];", "m.w[0] = m.w[2] == 0 ? 0 : m.w[1] / m.w[2];",
     "a division by zero"},
    {"DivisionThatOverflows", "m.w[0] = int(m.w[1]) / -int(m.w[2] | 1);",
     "m.w[0] = int(m.w[1] >> 1) / -int(m.w[2] >> 1 | 1);", "a division that overflows"},
    {"WriteOutside", "m.b[m.b[0]] = 1;", "if (m.b[0] < 16) m.b[m.b[0]] = 1;", "a write outside of its object"},
    {"ReadOutside", "m.b[1] = m.b[m.b[0]];", "m.b[1] = m.b[m.b[0] & 15];", "a read outside of its object"},
    {"AddressOutside", "m.b[1] = (&m.b[0] + m.w[0])[16 - m.w[0]];", "m.b[1] = (&m.b[0] + (m.w[0] & 3))[m.w[1] & 3];",
     kAddress},
    {"SumWithSign", "m.w[0] = int(m.w[1]) + 1;", "m.w[0] = int(m.w[1] >> 1) + 0 * int(m.w[2]);", kWritten},
    {"SumOfTwo", "m.w[0] = int(m.w[1]) + int(m.w[2]);",
     "m.w[0] = m.w[1] < 100 && m.w[2] < 100 ? int(m.w[1]) + int(m.w[2]) : 0;", kWritten},
    {"DifferenceWithSign", "m.w[0] = int(m.w[1]) - int(m.w[2]);", "m.w[0] = int(m.w[1] >> 1) - int(m.w[2] >> 1);",
     kWritten},
    {"ProductWithSign", "m.w[0] = int(m.w[1]) * int(m.w[2]);", "m.w[0] = int(m.w[1] & 255) * int(m.w[2] & 255);",
     kWritten},
    {"WideProduct", "m.w[0] = uint32_t((long long)(int64_t(uint64_t(m.w[1]) << 32 | m.w[2])) * 1000 >> 32);",
     "m.w[0] = uint32_t((long long)(int64_t(m.w[1])) * 1000 >> 32);", kWritten},
    {"Shift", "m.w[0] = m.w[1] << m.w[2];", "m.w[0] = m.w[2] < 32 ? m.w[1] << m.w[2] : 0;", kWritten},
    {"ShiftToTheRight", "m.w[0] = int(m.w[1]) >> m.w[2];", "m.w[0] = int(m.w[1]) >> (m.w[2] & 31);", kWritten},
    {"Decision", "if (int(m.w[1]) + int(m.w[2]) > 5) tell(host, true);",
     "if (int(m.b[1]) + int(m.b[2]) > 5) tell(host, true);", "a decision by a number that C++ leaves undefined"},
    {"Argument", "m.w[0] = ask(host, int(m.w[1]) * 3);", "m.w[0] = ask(host, int(m.b[1]) * 3);",
     "an argument that C++ leaves undefined"},
    {"Assumption", "__builtin_assume(m.w[1] < 8); m.w[0] = m.w[1] + 1;",
     "if (m.w[1] < 8) { __builtin_assume(m.w[1] < 9); m.w[0] = m.w[1] + 1; }",
     "an assumption of the compiler that does not hold"},
    {"Alignment", "uint8_t* p = &m.b[m.b[0] & 7]; m.w[0] = *reinterpret_cast<uint32_t*>(p);",
     "uint8_t* p = &m.b[m.b[0] & 4]; m.w[0] = *reinterpret_cast<uint32_t*>(p);",
     "an access at an address that is not aligned"},
    {"CopyOntoAPartOfItself", "__builtin_memcpy(&m.b[m.b[0] & 3], &m.b[2], 12);",
     "__builtin_memcpy(&m.b[m.b[0] & 1], m.w, 12);", "a copy onto a part of itself"},
    {"Truth", "m.b[1] = *reinterpret_cast<bool*>(&m.b[0]) ? 4 : 5;",
     "m.b[1] = m.b[0] < 2 && *reinterpret_cast<bool*>(&m.b[0]) ? 4 : 5;",
     "a read of a number that its type does not have"},
    {"NumberBeyondAnInteger", "m.w[0] = int(__builtin_bit_cast(float, m.w[1]));",
     "const float x = __builtin_bit_cast(float, m.w[1]); "
     "m.w[0] = x >= -2147483648.0F && x < 2147483648.0F ? int(x) : 0;",
     kWritten},
    {"NumberBeyondAnUnsignedInteger", "m.w[0] = uint32_t(double(__builtin_bit_cast(float, m.w[1])));",
     "const double x = __builtin_bit_cast(float, m.w[1]); m.w[0] = x > -1.0 && x < 4294967296.0 ? uint32_t(x) : 0;",
     kWritten},
    {"CodeThatIsNotReached", "if (m.w[1] == 7) tell(host, true), __builtin_unreachable();",
     "if (m.w[1] > 7 && m.w[1] < 7) tell(host, true), __builtin_unreachable();",
     "code behind a call that never returns"},
};

class UndefinedTest : public CompiledCodeTest, public ::testing::WithParamInterface<Undefined> {
 protected:
  /// What may happen of what must not, as the solver finds.
  std::vector<std::string> MayHappen(const std::string& statement) {
    std::vector<std::string> texts;
    for (const char* level : {"1", "2", "s"}) {
      terms_ = terms::Terms();
      const verify::CodeOutcome outcome = Execute("void f(State& m, Host& host) noexcept { " + statement + " }", level);
      EXPECT_EQ(outcome.refusal, "") << statement;
      solver::LoadedSolver loaded = solver::LoadSolver(terms_);
      if (loaded.solver == nullptr) return {loaded.reason};
      for (const verify::Obligation& obligation : outcome.obligations) {
        if (loaded.solver->Check({&obligation.never, 1}, solver::Limit::Effort(kSolverMs)) != solver::Answer::kNever)
          texts.push_back(obligation.text);
      }
    }
    return texts;
  }
};

TEST_P(UndefinedTest, IsAnObligationThatAGuardMeets) {
  EXPECT_THAT(MayHappen(GetParam().bare), ::testing::Contains(GetParam().text));
  EXPECT_THAT(MayHappen(GetParam().guarded), ::testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, UndefinedTest, ::testing::ValuesIn(kUndefined),
                         [](const auto& undefined) { return undefined.param.name; });

/// The compiler may use the place of one local for another one.
TEST_F(CompiledCodeTest, LocalsThatAreGoneHaveNoValue) {
  const auto is_kept = [this](const std::string& statement) {
    terms_ = terms::Terms();
    const verify::CodeOutcome outcome = Execute(
        "[[gnu::noinline]] static void put(uint8_t& to, uint8_t value) { to = value; }\n"
        "void f(State& m, Host&) noexcept { uint8_t* kept; " +
        statement + " }");
    EXPECT_EQ(outcome.refusal, "");
    return outcome.slots[0] == outcome.slots[1];
  };
  EXPECT_TRUE(is_kept("uint8_t local; put(local, m.b[1]); kept = &local; m.b[0] = *kept;"));
  EXPECT_FALSE(is_kept("{ uint8_t local; put(local, m.b[1]); kept = &local; } m.b[0] = *kept;"));
}

TEST_F(CompiledCodeTest, Refusals) {
  const auto refusal = [this](const std::string& body, const std::vector<std::string>& flags = {}) {
    return Execute(body, "2", flags).refusal;
  };
  EXPECT_EQ(refusal("void g();"), "the code has no function t::f");
  EXPECT_EQ(refusal("void f(State&) noexcept {}"), "the parameters of t::f are others than expected");
  EXPECT_NE(refusal("uint32_t n; void f(State& m, Host&) noexcept { m.w[0] = n++; }").find("global variable"),
            std::string::npos);
  EXPECT_NE(refusal("void f(State& m, Host&) noexcept { asm volatile(\"\" : : \"r\"(m.w[0])); }").find("assembler"),
            std::string::npos);
  EXPECT_NE(refusal("void f(State& m, Host&) noexcept { m.w[0] = (unsigned __int128)m.w[1] * m.w[1] * m.w[1] >> 70; }")
                .find("too wide"),
            std::string::npos);
  EXPECT_NE(
      refusal("void f(State& m, Host&) noexcept { while (m.w[0] > 1) { m.w[1] ^= m.w[0] * 7; m.w[0] = m.w[0] & 1 ? "
              "3 * m.w[0] + 1 : m.w[0] / 2; } }")
          .find("go round more than"),
      std::string::npos);
  const std::string floats =
      "float x(uint32_t n) { float f; __builtin_memcpy(&f, &n, 4); return f; } void f(State& m, Host&) noexcept { "
      "m.b[0] = x(m.w[0]) * x(m.w[1]) + x(m.w[3]) > 2.0f; m.b[1] = x(m.w[2]) / x(m.w[1]) > 3.0f; }";
  EXPECT_EQ(refusal(floats), "");
  EXPECT_NE(refusal(floats, {"-ffast-math"}).find("-ffast-math"), std::string::npos);
  EXPECT_NE(refusal(floats, {"-freciprocal-math"}).find("-ffast-math"), std::string::npos);
  EXPECT_NE(refusal(floats, {"-ffp-contract=fast", "-mfma"}).find("need not be exact"), std::string::npos);
  EXPECT_EQ(refusal("void f(State&, Host& host) noexcept; void other(Host&); void f(State&, Host& host) noexcept { "
                    "other(host); }"),
            "unknown: t::other");
}

}  // namespace
}  // namespace plcxx::prove
