// Compiled code as the tool sees it: what it is executed on, and what comes out. The border to the module that reads
// LLVM's bitcode (llvm_ir/, lib/plcxx_verify.so).
//
// An execution works on a row of slots: first the bytes of State, one term of 8 bits each; behind them as many more as
// its surroundings ask for (what hosts have been told), of any width. Branches are joined with Ite, loops are unrolled
// as far as they are not known to end, calls of defined functions are followed, others are the host's.
// What the language leaves open (undef, poison, a shift by too much, a read outside of an object) is a variable that
// nothing else depends on; what must not happen at all (division by zero, a write outside) is an Obligation.
// Not its job: what the bytes mean, and whether the outcome is right (verify.h).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/prove/terms/terms.h"

namespace plcxx::prove {

/// The slots on the path that executes.
class CodeMemory {
 public:
  CodeMemory() = default;
  CodeMemory(const CodeMemory&) = delete;
  CodeMemory& operator=(const CodeMemory&) = delete;
  virtual ~CodeMemory() = default;
  virtual TermId Read(uint32_t slot) = 0;
  virtual void Write(uint32_t slot, TermId value) = 0;
};

struct HostArgument {
  enum class Kind : uint8_t { kValue, kHost, kMemory };
  Kind kind = Kind::kValue;
  TermId value;       // kValue
  uint32_t slot = 0;  // kMemory: where the bytes begin that it points to
};

/// A call of a function that the code declares and does not define.
struct HostRequest {
  std::string_view function;  // as the source calls it: "lathe::fault"
  std::span<const HostArgument> arguments;
  uint8_t result_width = 0;  // 0: none
};

class CodeSurroundings {
 public:
  CodeSurroundings() = default;
  CodeSurroundings(const CodeSurroundings&) = delete;
  CodeSurroundings& operator=(const CodeSurroundings&) = delete;
  virtual ~CodeSurroundings() = default;
  /// What a slot holds before anything wrote it; asked once.
  virtual TermId Initial(uint32_t slot) = 0;
  /// Does what the host does to `memory`, and gives its result. A reason in `refusal` ends the execution.
  virtual TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) = 0;
};

/// A call of a partition from outside: its arguments are State, `arguments`, Host.
struct CodeRun {
  std::string function;  // "lathe::fast"
  uint32_t state_bytes = 0;
  uint32_t further_slots = 0;
  std::vector<TermId> arguments;
  uint32_t most_rounds = 4096;       // of one loop
  uint32_t most_terms = 20'000'000;  // that the execution may make
};

/// A condition of width 1 that no state and input may make 1.
struct Obligation {
  TermId never;
  std::string text;  // "a division by zero"
};

struct CodeOutcome {
  std::string refusal;        // why it was given up, with the instruction's name; empty: it was not
  std::vector<TermId> slots;  // after it
  TermId result;              // none when the function has none
  std::vector<Obligation> obligations;
  uint64_t instructions = 0;  // executed, loops and calls as often as they were
};

class CompiledCode {
 public:
  CompiledCode() = default;
  CompiledCode(const CompiledCode&) = delete;
  CompiledCode& operator=(const CompiledCode&) = delete;
  virtual ~CompiledCode() = default;
  virtual CodeOutcome Execute(Terms& terms, CodeSurroundings& surroundings, const CodeRun& run) = 0;
};

struct LoadedCode {
  std::unique_ptr<CompiledCode> code;
  std::string reason;  // why there is none; lower case, no full stop
};

/// The program of these bitcode files (contents, one for each .cpp file).
LoadedCode LoadCode(std::span<const std::string> bitcode);

/// SHA-256 in hexadecimal digits; empty where the module is missing.
std::string Sha256(std::string_view bytes);

/// The functions of the module; the reason is empty where it gives code.
using ReadCodeFunction = CompiledCode*(std::span<const std::string> bitcode, std::string& reason);
using Sha256Function = void(std::string_view bytes, std::string& digits);
inline constexpr const char* kVerifyModule = "plcxx_verify.so";
inline constexpr const char* kReadCode = "plcxx_read_code";
inline constexpr const char* kSha256 = "plcxx_sha256";

}  // namespace plcxx::prove
