// Random programs with every kind of region, way out, local and storage: the generated code computes what the
// simulator computes, whatever was cut into functions and files.

#include <functional>

#include "tests/emit/emitted_program.h"
#include "tests/volume.h"
#include "transpiler/emit/legalize/legalize.h"

namespace plcxx::emit {
namespace {

constexpr std::string_view kRandomMemory = R"(space m 8 volatile little host_visible
space f 24 volatile big host_visible
space k 8 retentive little host_visible
space r 24 routine little
place a bit m[0].0
place b bit m[0].1
place c bit m[1].0
place d bit m[2].5
place x i8 m[3]
place y i8 m[4]
place w i16 m[5]
place z i8 m[2]
place v i16 f[1]
place u i16 f[4]
place q i32 f[3]
place fb bit f[5].6
place row i16 f[8] stride 2 low 8 high 20 indexed
place row8 i8 f[12] stride 1 low 8 high 20 indexed
place kw i16 k[1]
place kd i32 k[2]
place s bit r[0].0
place ax i16 r[2]
place rounds i32 r[4]
place got i32 r[8]
host fault (kind : i8 = (LOW, HIGH), index : i32)
host nc_read (width : i8) -> bit out value : i32
host port (at : i8) -> bit
state C5 decade_counter
state C6 decade_counter
place count5 i16 field C5 value
place count6 i16 field C6 value
place gone bit r[12].0
routine Gone subroutine -> bit gone {
  stmt s1
  %0 = load x
  %1 = const i8 7
  %2 = ult.i8 %0 %1
  store gone %2
  %3 = add.i8 %0 %1
  store x %3
}
)";

/// Writes the body of one routine. Values are numbered through, so that none is used twice by mistake.
class Writer {
 public:
  Writer(std::mt19937& random, uint32_t first_statement, std::vector<std::string> callees)
      : random_(random), statement_(first_statement), callees_(std::move(callees)) {}

  std::string Body(uint32_t statements) {
    out_.clear();
    Region(statements, 0);
    return out_;
  }
  uint32_t statements() const { return statement_; }

 private:
  struct Target {
    std::string label;
    bool budget;
  };

  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  std::string New() { return "%" + std::to_string(++value_); }
  void Line(const std::string& line) { out_ += line + "\n"; }
  template <size_t kCount>
  std::string OneOf(const char* const (&names)[kCount]) {
    return names[Below(kCount)];
  }

  /// A step or a call, for its value or for none.
  std::string Effect() {
    const uint32_t what = Below(4);
    const std::string operand = what < 2 ? Bit() : what == 2 ? Word8() : "", value = New();
    if (what < 2) {
      Line(value + " = step." + (what == 0 ? "count_up C5 " : "count_down C6 ") + operand);
    } else {
      Line(value + (what == 2 ? " = host port (" + operand + ")" : " = call Gone ()"));
    }
    return value;
  }

  /// Now and then one that the statement has already.
  std::string Bit() {
    if (!known_.empty() && Below(6) == 0) return known_[Below(static_cast<uint32_t>(known_.size()))];
    return NewBit();
  }
  std::string NewBit() {
    known_.push_back(Below(6) == 0 ? Effect() : PureBit());
    return known_.back();
  }
  std::string PureBit() {
    static constexpr const char* kBits[] = {"a", "b", "c", "d", "fb", "s"};
    const std::string value = New();
    switch (Below(6)) {
      case 0: {
        const std::string left = Word8(), right = New();
        Line(right + " = const i8 " + std::to_string(Below(20)));
        Line(value + " = ult.i8 " + left + " " + right);
        break;
      }
      case 1: {
        const std::string operand = Bit();
        Line(value + " = not.bit " + operand);
        break;
      }
      case 2: {
        const std::string left = Bit(), right = Bit();
        Line(value + " = " + (Below(2) == 0 ? "and" : "or") + ".bit " + left + " " + right);
        break;
      }
      default:
        Line(value + " = load " + OneOf(kBits));
    }
    return value;
  }
  std::string Word8() {
    static constexpr const char* kWords[] = {"x", "y", "z"};
    const std::string value = New();
    if (Below(4) == 0) {
      const std::string index = Index();
      Line(value + " = load row8[" + index + "]");
    } else {
      Line(value + " = load " + OneOf(kWords));
    }
    return value;
  }
  std::string Word16() {
    static constexpr const char* kWords[] = {"w", "v", "u", "kw", "ax"};
    const std::string value = New();
    switch (Below(5)) {
      case 0: {
        const std::string left = Word16(), right = Word16();
        Line(value + " = add.i16 " + left + " " + right);
        break;
      }
      case 1: {
        const std::string index = Index();
        Line(value + " = load row[" + index + "]");
        break;
      }
      default:
        Line(value + " = load " + OneOf(kWords));
    }
    return value;
  }
  std::string Index() {
    const std::string byte = New(), wide = New(), back = New(), value = New();
    Line(byte + " = load x");
    Line(wide + " = zext.i8.i32 " + byte);
    Line(back + " = const i32 " + (Below(2) == 0 ? "4294967292" : "0"));
    Line(value + " = add.i32 " + wide + " " + back);
    return value;
  }

  void Store() {
    static constexpr const char* kBits[] = {"a", "b", "c", "d", "fb", "s"};
    static constexpr const char* kWords8[] = {"x", "y", "z"};
    static constexpr const char* kWords16[] = {"w", "v", "u", "kw", "ax"};
    switch (Below(7)) {
      case 0: {
        const std::string value = Word8();
        Line("store " + OneOf(kWords8) + " " + value);
        break;
      }
      case 1: {
        const std::string value = Word16();
        Line("store " + OneOf(kWords16) + " " + value);
        break;
      }
      case 2: {
        const std::string old = New(), word = Word16(), wide = New(), sum = New();
        const std::string place = Below(2) == 0 ? "q" : "kd";
        Line(old + " = load " + place);
        Line(wide + " = sext.i16.i32 " + word);
        Line(sum + " = add.i32 " + old + " " + wide);
        Line("store " + place + " " + sum);
        break;
      }
      case 3: {
        const std::string index = Index(), value = Word16();
        Line("store row[" + index + "] " + value);
        break;
      }
      default: {
        const std::string value = Bit();
        Line("store " + OneOf(kBits) + " " + value);
      }
    }
  }

  void Call() {
    if (Below(4) == 0) {
      Effect();
      return;
    }
    if (!callees_.empty() && Below(2) == 0) {
      Line("call " + callees_[Below(static_cast<uint32_t>(callees_.size()))] + " ()");
      return;
    }
    const std::string width = Word8(), done = New(), got = New();
    if (Below(2) == 0) {
      Line(done + " = host nc_read (" + width + ") out got");
      Line("store b " + done);
      Line(got + " = load got");
      Line("store q " + got);
    } else {
      const std::string kind = New(), index = New();
      Line(kind + " = const i8 " + std::to_string(Below(2)));
      Line(index + " = const i32 " + std::to_string(Below(100)));
      Line("host fault (" + kind + ", " + index + ")");
    }
  }

  void Leave(uint32_t depth) {
    if (targets_.empty()) return Store();
    const Target& target = targets_[Below(static_cast<uint32_t>(targets_.size()))];
    const bool always = Below(6) == 0;
    const std::string condition = always ? "" : " if " + Bit();
    if (!target.budget || Below(2) == 0) return Line("exit " + target.label + condition);
    std::string line = "repeat " + target.label + condition;
    if (Below(2) == 0) return Line(line);
    Line(line + " refused {");
    const Scope scope(*this);
    if (Below(2) == 0) Call();
    if (Below(2) == 0) Line("exit " + targets_[Below(static_cast<uint32_t>(targets_.size()))].label);
    if (Below(3) == 0) Region(1, depth + 1);
    Line("}");
  }

  /// Where the block ends anyway; a value of the statement that it follows.
  void LeaveLast(const std::string& label) {
    const Scope scope(*this);
    Marker();
    Line("exit " + label + " if " + NewBit());
  }

  void Marker() {
    known_.clear();  // no value lives on
    char name[16];
    std::snprintf(name, sizeof name, "s%x", ++statement_);
    Line("stmt " + std::string(name));
  }

  std::string Enter(bool budget) {
    targets_.push_back({"@" + std::to_string(++label_), budget});
    return targets_.back().label;
  }

  void Nested(uint32_t depth) {
    const Scope scope(*this);
    // Sometimes with something of the outer statement in front.
    if (Below(4) == 0) Below(2) == 0 ? Store() : Leave(depth);
    Region(1 + Below(4), depth + 1);
  }

  void Owner(uint32_t depth) {
    switch (Below(6)) {
      case 0:
      case 1: {
        const std::string early = Bit(), label = Enter(false);
        Line("block " + label + " {");
        if (Below(3) == 0) Line("exit " + label + " if " + early);
        Nested(depth);
        if (Below(3) == 0) LeaveLast(label);
        Line("}");
        targets_.pop_back();
        break;
      }
      case 2: {
        const std::string label = Enter(true);
        Line("loop " + label + " budget 0 rounds {\nbody {");
        Nested(depth);
        Line("}\n}");
        targets_.pop_back();
        break;
      }
      case 3: {
        const std::string label = Enter(false);
        Line("loop " + label + " guard " + std::to_string(1 + Below(4)) + " {");
        if (Below(2) == 0) {
          Line("condition {");
          const Scope scope(*this);
          NewBit();
          Line("}");
        }
        Line("body {");
        Nested(depth);
        Line("}");
        if (Below(2) == 0) {
          Line("exhausted {");
          const Scope scope(*this);
          Call();
          Line("}");
        }
        Line("}");
        targets_.pop_back();
        break;
      }
      case 4: {
        const std::string selector = Word8();
        Line("switch " + selector + " {");
        Line("case 0 1 {");
        Nested(depth);
        Line(Below(2) == 0 ? "}\ncase 2 falls_through {" : "}\ncase 2 {");
        Nested(depth);
        Line("}\ndefault {");
        Nested(depth);
        Line("}\n}");
        break;
      }
      default: {
        static constexpr const char* kOrigins[] = {"", " jumps", " stays"};
        const std::string condition = Bit();
        Line("if " + condition + OneOf(kOrigins) + " {");
        Nested(depth);
        if (Below(2) == 0) {
          Line("} else {");
          Nested(depth);
        }
        Line("}");
      }
    }
  }

  void Region(uint32_t statements, uint32_t depth) {
    const Scope scope(*this);
    for (uint32_t i = 0; i < statements; ++i) {
      Marker();
      for (uint32_t k = 0; k <= Below(2); ++k) {
        const uint32_t what = Below(12);
        if (what < 6) {
          Store();
        } else if (what < 7) {
          Call();
        } else if (what < 10) {
          Leave(depth);
        } else if (depth < 5) {
          Owner(depth);
        }
      }
    }
  }

  /// What is computed in a region is known in it alone; behind another statement nothing is known.
  class Scope {
   public:
    explicit Scope(Writer& writer) : writer_(writer), statement_(writer.statement_), known_(writer.known_) {}
    ~Scope() { writer_.known_ = writer_.statement_ == statement_ ? known_ : std::vector<std::string>{}; }
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;

   private:
    Writer& writer_;
    const uint32_t statement_;
    const std::vector<std::string> known_;
  };

  std::mt19937& random_;
  uint32_t statement_;
  std::vector<std::string> callees_;
  std::string out_;
  uint32_t value_ = 0;
  uint32_t label_ = 0;
  std::vector<Target> targets_;
  std::vector<std::string> known_;  // bits that the statement has computed
};

std::string RandomProgram(uint32_t seed, const std::vector<uint32_t>& sizes) {
  std::mt19937 random(seed);
  std::string text(kRandomMemory);
  std::vector<std::string> names;
  uint32_t statement = 2;
  std::string routines;
  for (size_t i = 0; i < sizes.size(); ++i) {
    Writer writer(random, statement, names);
    const std::string name = "R" + std::to_string(i);
    routines += "routine " + name + " subroutine {\n" + writer.Body(sizes[i]) + "}\n";
    names = i % 3 == 2 ? std::vector<std::string>{} : std::vector<std::string>{name};  // chains of three
    statement = writer.statements();
  }
  text += routines + "routine period schedule {\n  %0 = const i32 40\n  store rounds %0\n";
  for (size_t i = 0; i < sizes.size(); ++i) text += "  call R" + std::to_string(i) + " ()\n";
  return text + "}\nschedule period period\n";
}

const std::vector<std::string> kRandomInputs = {"a", "b", "d", "x", "y", "w", "u", "q", "kd"};

TEST(EmitRandom, SmallRoutines) {
  for (uint32_t seed = 1; seed <= testing_support::Volume(1U, 4U); ++seed) {
    SCOPED_TRACE(seed);
    const EmittedProgram program(RandomProgram(seed, std::vector<uint32_t>(24, 5)), kRandomInputs, seed);
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated(seed);
    if (HasFailure()) return;
  }
}

TEST(EmitRandom, LongRoutinesAreCut) {
  for (uint32_t seed = 1; seed <= testing_support::Volume(1U, 2U); ++seed) {
    SCOPED_TRACE(seed);
    const EmittedProgram program(RandomProgram(seed, {150, 120}), kRandomInputs, seed);
    const Emittable emittable = legalize::Legalize(program.program(), {.name = "p"});
    EXPECT_GT(emittable.chunks.size(), 1u);
    program.ExpectRunsAsSimulated();
    program.ExpectDebugsAsSimulated(seed);
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace plcxx::emit
