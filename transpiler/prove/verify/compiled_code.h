// Compiled code as the tool sees it: what it is executed on, and what comes out. The border to the module that reads
// LLVM's bitcode (llvm_ir/, lib/plcxx_verify.so).
//
// An execution works on a row of slots: first the bytes of State, one term of 8 bits each; after them as many more as
// its environment ask for (what hosts have been told), of any width. Branches are joined with Ite, loops are unrolled
// as far as they are not known to end, calls of defined functions are followed, others are the host's.
// What the language leaves open (undef, poison, a shift by too much, a read outside of an object) is a variable that
// nothing else depends on; what must not happen at all (division by zero, a write outside) is an Obligation.
// Not its job: what the bytes mean, and whether the outcome is right (verify.h).
#pragma once

#include <charconv>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/symbolic/terms/terms.h"

namespace plcxx::prove::verify {

/// The slots on the path that executes.
class CodeMemory {
 public:
  CodeMemory() = default;
  CodeMemory(const CodeMemory&) = delete;
  CodeMemory& operator=(const CodeMemory&) = delete;
  virtual ~CodeMemory() = default;
  virtual terms::TermId Read(uint32_t slot) = 0;
  virtual void Write(uint32_t slot, terms::TermId value) = 0;
  /// When execution comes here, as a term of width 1.
  virtual terms::TermId When() const = 0;
  /// `never` (width 1) becomes an Obligation of the execution: where it comes here, it must be 0.
  virtual void Require(terms::TermId never, const char* text) = 0;
};

struct HostArgument {
  enum class Kind : uint8_t { kValue, kHost, kMemory, kUnknownPointer };
  Kind kind = Kind::kValue;
  terms::TermId value;     // kValue
  uint32_t slot = 0;       // kMemory: where the bytes begin that it points to
  uint64_t bytes = 0;      // kMemory: from there to the end of the object
  std::string_view name;   // of the function's parameter; empty: it has none there
  bool is_unused = false;  // the code defines the function, and does nothing with it: compilers pass anything
};

/// A call that the environment answer: of a function that the code declares and does not define, or that they replace.
struct HostRequest {
  std::string_view function;  // as the source calls it: "lathe::fault"
  std::span<const HostArgument> arguments;
  uint8_t result_width = 0;  // 0: none
};

/// A loop as the execution came to its head, when it is not unrolled: see execute/loop_heads.h.
struct CodeLoop {
  std::string_view name;  // "PM22, for.cond"
  /// What is not the same in each round: values that the code keeps, and slots.
  struct Item {
    std::string_view name;  // empty: a slot
    uint32_t slot = 0;
  };
  std::span<const Item> items;
  struct Head {
    terms::TermId when;                 // execution comes here
    std::vector<terms::TermId> values;  // of the items
  };
  Head entry;
  std::vector<Head> samples;
};

class CodeEnvironment {
 public:
  CodeEnvironment() = default;
  CodeEnvironment(const CodeEnvironment&) = delete;
  CodeEnvironment& operator=(const CodeEnvironment&) = delete;
  virtual ~CodeEnvironment() = default;
  /// What a slot holds before anything wrote it; asked once.
  virtual terms::TermId Initial(uint32_t slot) = 0;
  /// Whether calls of a function that the code defines come to CallHost, too, instead of being followed.
  virtual bool Replaces(std::string_view) const { return false; }
  /// Does what the host does to `memory`, and gives its result. A reason in `refusal` ends the execution.
  virtual terms::TermId CallHost(CodeMemory& memory, const HostRequest& request, std::string& refusal) = 0;

  /// Whether a condition of width 1 is known never to hold: asked for each further round of a loop of which the terms
  /// alone do not say that it has ended.
  virtual bool NeverHolds(terms::TermId) { return false; }

  /// A loop begins that is not unrolled; loops inside it are opened and closed before it is closed.
  virtual void OpenLoop() {}
  /// What its items are at the head of any round. Asked again with more items where the round changes others.
  virtual std::vector<terms::TermId> AtHead(const CodeLoop&) { return {}; }
  /// `again`: since the head, whether another round follows, and the items then.
  virtual void CloseLoop(terms::TermId /*again*/, std::span<const terms::TermId> /*values*/) {}
  /// What may be taken for granted of loops that have ended; none: nothing.
  virtual terms::TermId Given() { return {}; }
};

/// One argument of a function as the source declares it.
struct CodeArgument {
  enum class Kind : uint8_t { kState, kHost, kValue, kMemory };
  Kind kind = Kind::kValue;
  std::string name;              // of the parameter
  terms::TermId value;           // kValue
  uint32_t slot = 0, bytes = 0;  // kMemory: a variable of the caller's, by reference
};

/// Of a parameter that is the value at a reference "s" at the time of the call, "s.4.val": how many bytes after it.
inline std::optional<uint32_t> PromotedOffset(std::string_view parameter, std::string_view reference) {
  constexpr std::string_view kEnd = ".val";
  if (!parameter.starts_with(reference) || !parameter.ends_with(kEnd)) return std::nullopt;
  parameter.remove_prefix(reference.size());
  if (parameter.size() < kEnd.size() + 2 || parameter.front() != '.') return std::nullopt;
  const std::string_view digits = parameter.substr(1, parameter.size() - kEnd.size() - 1);
  uint32_t offset = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), offset);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return offset;
}

/// A variable of the code that no function owns and that is not constant, and the slots that it is.
struct CodeGlobal {
  enum class Kind : uint8_t {
    kBytes,
    kTable  // its elements, 2 bytes each, are the addresses of the 2 bytes at the same place of the slots
  };
  std::string name;
  uint32_t slot = 0, bytes = 0;
  Kind kind = Kind::kBytes;
};

/// A call of a function of the code. Compilers may leave out parameters of functions that only the file itself calls,
/// and pass a variable's value instead of a reference: such parameters are found by their names.
struct CodeRun {
  std::string function;  // "lathe::fast"
  uint32_t state_bytes = 0;
  uint32_t further_slots = 0;
  std::vector<CodeArgument> arguments;
  uint32_t most_rounds = 4096;  // of one loop
  enum class Loops : uint8_t {
    kUnrolled,
    kAtHeads,     // where it is not known after `rounds` rounds whether they go on, they get their heads from outside
    kFirstRounds  // what goes round more often is left out
  };
  Loops loops = Loops::kUnrolled;
  uint32_t rounds = 4;
  uint32_t most_terms = 20'000'000;  // that the execution may make
  std::span<const CodeGlobal> globals = {};
  /// kSource: the least long divided by -1 is itself, and a null pointer is an address outside of all objects.
  enum class Language : uint8_t { kCpp, kSource } language = Language::kCpp;
};

/// A condition of width 1 that no state and input may make 1.
struct Obligation {
  terms::TermId never;
  std::string text;     // "a division by zero"
  terms::TermId given;  // of loops, CodeEnvironment::Given(); may be none
};

struct CodeOutcome {
  std::string refusal;               // why it was given up, with the instruction's name; empty: it was not
  std::vector<terms::TermId> slots;  // after it
  terms::TermId result;              // none when the function has none
  std::vector<Obligation> obligations;
  uint64_t instructions = 0;  // executed, loops and calls as often as they were
  terms::TermId left_out;     // when a loop would have gone round more often
};

/// So many numbers from `low` on, around the end of the width.
struct NumberRange {
  uint64_t low = 0, count = 0;
};

class CompiledCode {
 public:
  CompiledCode() = default;
  CompiledCode(const CompiledCode&) = delete;
  CompiledCode& operator=(const CompiledCode&) = delete;
  virtual ~CompiledCode() = default;
  virtual CodeOutcome Execute(terms::Terms& terms, CodeEnvironment& environment, const CodeRun& run) = 0;
  /// The same code for another thread: one is executed by one thread at a time.
  virtual std::unique_ptr<CompiledCode> Copy() const = 0;
  /// The names of the parameters that a function has after compilation (of one without name, empty); none: the code
  /// has no such function.
  virtual std::optional<std::vector<std::string>> Parameters(const std::string& function) const = 0;
  /// What the code says of a function's result, and its execution requires; none: nothing.
  virtual std::optional<NumberRange> ResultRange(const std::string& /*function*/) const { return std::nullopt; }
  /// What a global variable is initialised with, byte by byte, -1 where that is no number; empty: it is declared only.
  virtual std::vector<int16_t> InitialBytes(const std::string& global) const = 0;
};

struct LoadedCode {
  std::unique_ptr<CompiledCode> code;
  std::string reason;  // why there is none; lower case, no full stop
};

/// The program of these bitcode files (contents, one for each .cpp file).
LoadedCode LoadCode(std::span<const std::string> bitcode);

/// The sources' own language, as its compiler made code of it without optimizing.
struct SourceCode {
  std::string bitcode;
  std::string prefix;  // that its functions get in front of their names: "mill::"
  /// A variable of a function that becomes a global one.
  struct Local {
    std::string function, name;
    uint64_t bytes = 0;
    std::string global;
  };
  std::vector<Local> locals;  // of each function in the order of their declarations
  /// A call with these constant arguments (numbers, names of functions) is a store to bits of a byte, a call of another
  /// function without arguments, or nothing.
  struct Effect {
    std::string function;
    std::vector<std::string> arguments;
    std::string global, calls;  // empty: none
    uint8_t mask = 0xFF, value = 0;
  };
  std::vector<Effect> effects;
};
LoadedCode LoadSourceCode(const SourceCode& source);

/// The functions of the module; the reason is empty where they give code.
using ReadCodeFunction = CompiledCode*(std::span<const std::string> bitcode, std::string& reason);
using ReadSourceFunction = CompiledCode*(const SourceCode& source, std::string& reason);
inline constexpr const char* kVerifyModule = "plcxx_verify.so";
inline constexpr const char* kReadCode = "plcxx_read_code";
inline constexpr const char* kReadSource = "plcxx_read_source";

}  // namespace plcxx::prove::verify
