// Random programs of dialect hnc, printed twice from one tree: as it is, and written in another way.
#include <memory>
#include <utility>

#include "tests/pairs/pair.h"

namespace plcxx::pairs {
namespace {

struct Node;
using NodeList = std::vector<std::shared_ptr<const Node>>;

enum class Kind : uint8_t {
  // expressions
  kName,
  kNumber,
  kUnary,
  kBinary,
  kChoice,
  kCast,
  kCall,
  // conditions
  kCompare,
  kBoth,
  kEither,
  kNot,
  kTruth,
  // statements
  kAssign,
  kIf,
  kCount,
  kRepeat,
  kSwitch
};

struct Node {
  Kind kind{};
  std::string text;  // the name, number, operator or type
  NodeList parts;    // operands; of kIf: the condition, then `yes` statements, then those for no
  size_t yes = 0;
};
using Tree = std::shared_ptr<const Node>;

Tree Make(Kind kind, std::string text, NodeList parts = {}, size_t yes = 0) {
  return std::make_shared<const Node>(
      Node{.kind = kind, .text = std::move(text), .parts = std::move(parts), .yes = yes});
}

class Generator {
 public:
  explicit Generator(Random& random) : random_(random) {}

  Tree Expression(int depth) {
    if (depth == 0 || Below(random_, 4) == 0) {
      if (Below(random_, 4) == 0) return Make(Kind::kNumber, Number());
      return Make(Kind::kName, Readable());
    }
    switch (Below(random_, 10)) {
      case 0: {
        static const std::vector<std::string> kUnary{"~", "-", "!"};
        return Make(Kind::kUnary, Pick(kUnary), {Expression(depth - 1)});
      }
      case 1:
        return Make(Kind::kChoice, "", {Condition(depth - 1), Expression(depth - 1), Expression(depth - 1)});
      case 2: {
        static const std::vector<std::string> kTypes{"unsigned char", "int", "unsigned", "long", "char"};
        return Make(Kind::kCast, Pick(kTypes), {Expression(depth - 1)});
      }
      case 3: {
        static const std::vector<std::string> kOperators{"<<", ">>", "/", "%"};
        static const std::vector<std::string> kSmall{"1", "2", "3", "5", "7"};
        return Make(Kind::kBinary, Pick(kOperators), {Expression(depth - 1), Make(Kind::kNumber, Pick(kSmall))});
      }
      case 4:
        if (!in_function_)
          return Make(Kind::kCall, Below(random_, 2) == 0 ? "twice" : "mixed", {Expression(depth - 1)});
        [[fallthrough]];
      default: {
        static const std::vector<std::string> kOperators{"+", "-", "&", "|", "^", "*", "+", "&", "|"};
        return Make(Kind::kBinary, Pick(kOperators), {Expression(depth - 1), Expression(depth - 1)});
      }
    }
  }

  Tree Condition(int depth) {
    switch (Below(random_, depth == 0 ? 2 : 6)) {
      case 0:
        return Make(Kind::kTruth, "",
                    {Make(Kind::kBinary, "&", {Make(Kind::kName, Readable()), Make(Kind::kNumber, Mask())})});
      case 1: {
        static const std::vector<std::string> kRelations{"<", "<=", ">", ">=", "==", "!="};
        return Make(Kind::kCompare, Pick(kRelations), {Expression(depth / 2), Expression(0)});
      }
      case 2:
        return Make(Kind::kNot, "", {Condition(depth - 1)});
      case 3:
        return Make(Kind::kEither, "", {Condition(depth - 1), Condition(depth - 1)});
      default:
        return Make(Kind::kBoth, "", {Condition(depth - 1), Condition(depth - 1)});
    }
  }

  Tree Statement(int depth) {
    switch (Below(random_, depth == 0 ? 3 : 8)) {
      case 3:
      case 4: {
        NodeList parts{Condition(2)};
        const size_t yes = 1 + Below(random_, 2), no = Below(random_, 2);
        for (size_t i = 0; i < yes + no; ++i) parts.push_back(Statement(depth - 1));
        return Make(Kind::kIf, "", std::move(parts), yes);
      }
      case 5: {
        static const std::vector<std::string> kTimers{"t0", "t1", "t2"};
        static const std::vector<std::string> kLimits{"3", "5", "10", "40"};
        return Make(Kind::kCount, Pick(kTimers), {Condition(1), Make(Kind::kNumber, Pick(kLimits))});
      }
      case 6: {
        static const std::vector<std::string> kOperators{"+", "^", "|"};
        return Make(Kind::kRepeat, Pick(kOperators), {Make(Kind::kName, Writable()), Make(Kind::kNumber, Number())},
                    2 + Below(random_, 3));
      }
      case 7: {
        NodeList parts{Expression(1)};
        for (int i = 0; i < 3; ++i) parts.push_back(Assignment());
        return Make(Kind::kSwitch, "", std::move(parts));
      }
      default:
        return Assignment();
    }
  }

  Tree Assignment() { return Make(Kind::kAssign, Writable(), {Expression(3)}); }
  void InFunction(bool is_in) { in_function_ = is_in; }

 private:
  const std::string& Pick(const std::vector<std::string>& list) { return list[Below(random_, list.size())]; }
  std::string Number() {
    static const std::vector<std::string> kAwkward{"0", "255", "256", "32767", "-1", "0x80", "1000"};
    return Below(random_, 3) == 0 ? Pick(kAwkward) : std::to_string(Below(random_, 20));
  }
  std::string Mask() { return std::to_string(1U << Below(random_, 8)); }
  std::string Readable() {
    static const std::vector<std::string> kNames{"X[0]", "X[1]", "X[2]", "X[5]", "R[3]", "R[4]", "a0",  "a1",
                                                 "u0",   "l0",   "c0",   "c1",   "t0",   "Y[0]", "Y[1]"};
    return in_function_ && Below(random_, 2) == 0 ? "p" : Pick(kNames);
  }
  std::string Writable() {
    static const std::vector<std::string> kNames{"Y[0]", "Y[1]", "Y[2]", "Y[3]", "R[3]", "R[4]",
                                                 "a0",   "a1",   "u0",   "l0",   "c0",   "c1"};
    return Pick(kNames);
  }

  Random& random_;
  bool in_function_ = false;
};

/// Writes a tree; in another way now and then, when there are random numbers for it.
class Writer {
 public:
  explicit Writer(Random* random, Tree mixed) : random_(random), mixed_(std::move(mixed)) {}

  std::string Expression(const Tree& tree) {
    const Node& node = *tree;
    switch (node.kind) {
      case Kind::kName:
        return Renamed(node.text);
      case Kind::kNumber:
        return node.text.starts_with("-") ? "(" + node.text + ")" : node.text;
      case Kind::kUnary:
        if (node.text == "~" && Otherwise()) return "(-(" + Expression(node.parts[0]) + ") - 1)";
        return node.text + "(" + Expression(node.parts[0]) + ")";
      case Kind::kBinary: {
        const bool commutes = std::string("+&|^*").find(node.text) != std::string::npos;
        std::string one = Expression(node.parts[0]), other = Expression(node.parts[1]);
        if (commutes && Otherwise()) std::swap(one, other);
        return "(" + one + " " + node.text + " " + other + ")";
      }
      case Kind::kChoice:
        if (Otherwise())
          return "(" + Not(Condition(node.parts[0])) + " ? " + Expression(node.parts[2]) + " : " +
                 Expression(node.parts[1]) + ")";
        return "(" + Condition(node.parts[0]) + " ? " + Expression(node.parts[1]) + " : " + Expression(node.parts[2]) +
               ")";
      case Kind::kCast:
        return "((" + node.text + ")(" + Expression(node.parts[0]) + "))";
      case Kind::kCall: {
        const std::string argument = "((int)(" + Expression(node.parts[0]) + "))";
        if (!Otherwise()) return node.text + "(" + argument + ")";
        if (node.text == "twice")
          return Otherwise() ? "(" + argument + " + " + argument + ")" : "(2 * " + argument + ")";
        const std::string outer = std::exchange(parameter_, argument);
        std::string body = "((int)(" + Expression(mixed_) + "))";
        parameter_ = outer;
        return body;
      }
      case Kind::kCompare:
      case Kind::kBoth:
      case Kind::kEither:
      case Kind::kNot:
      case Kind::kTruth:
        return Condition(tree);
      case Kind::kAssign:
      case Kind::kIf:
      case Kind::kCount:
      case Kind::kRepeat:
      case Kind::kSwitch:
        break;
    }
    return "0";
  }

  std::string Condition(const Tree& tree) {
    const Node& node = *tree;
    if (OneIn(8)) return "!" + Not(ConditionAsItIs(node));
    return ConditionAsItIs(node);
  }

  std::string Statements(const NodeList& list, size_t begin, size_t end, const std::string& indent) {
    std::string text;
    for (size_t i = begin; i < end; ++i) {
      if (OneIn(10)) text += indent + "/* another comment */\n";
      text += Statement(*list[i], indent);
    }
    return text;
  }

  bool Otherwise() { return OneIn(3); }
  std::string Renamed(const std::string& name) {
    if (name == "p" && !parameter_.empty()) return parameter_;
    return renames_ && name.size() == 2 && std::string("aulct").find(name[0]) != std::string::npos ? name + "_new"
                                                                                                   : name;
  }
  void RenameAll() { renames_ = true; }

 private:
  bool OneIn(uint32_t count) { return random_ != nullptr && Below(*random_, count) == 0; }
  static std::string Not(const std::string& condition) { return "(!" + condition + ")"; }

  std::string ConditionAsItIs(const Node& node) {
    switch (node.kind) {
      case Kind::kTruth:
        return Otherwise() ? "(" + Expression(node.parts[0]) + " != 0)" : Expression(node.parts[0]);
      case Kind::kNot:
        return Not(Condition(node.parts[0]));
      case Kind::kCompare: {
        static const std::map<std::string, std::string> kMirrored{{"<", ">"},   {"<=", ">="}, {">", "<"},
                                                                  {">=", "<="}, {"==", "=="}, {"!=", "!="}};
        static const std::map<std::string, std::string> kOpposite{{"<", ">="}, {"<=", ">"},  {">", "<="},
                                                                  {">=", "<"}, {"==", "!="}, {"!=", "=="}};
        const std::string one = Expression(node.parts[0]), other = Expression(node.parts[1]);
        if (Otherwise()) return "(" + other + " " + kMirrored.at(node.text) + " " + one + ")";
        if (Otherwise()) return Not("(" + one + " " + kOpposite.at(node.text) + " " + other + ")");
        return "(" + one + " " + node.text + " " + other + ")";
      }
      case Kind::kBoth:
      case Kind::kEither: {
        const bool is_both = node.kind == Kind::kBoth;
        std::string one = Condition(node.parts[0]), other = Condition(node.parts[1]);
        if (Otherwise()) std::swap(one, other);
        if (Otherwise()) return Not("(" + Not(one) + (is_both ? " || " : " && ") + Not(other) + ")");
        return "(" + one + (is_both ? " && " : " || ") + other + ")";
      }
      default:
        return "(" + std::string("0") + ")";
    }
  }

  std::string Statement(const Node& node, const std::string& indent) {
    const std::string inner = indent + "  ";
    switch (node.kind) {
      case Kind::kAssign:
        return indent + Renamed(node.text) + " = " + Expression(node.parts[0]) + ";\n";
      case Kind::kIf: {
        const std::string yes = Statements(node.parts, 1, 1 + node.yes, inner),
                          no = Statements(node.parts, 1 + node.yes, node.parts.size(), inner);
        const Node& condition = *node.parts[0];
        if (no.empty() && condition.kind == Kind::kBoth && Otherwise())
          return indent + "if (" + Condition(condition.parts[0]) + ") if (" + Condition(condition.parts[1]) + ") {\n" +
                 yes + indent + "}\n";
        if (Otherwise())
          return indent + "if (" + Not(Condition(node.parts[0])) + ") {\n" + no + indent + "} else {\n" + yes + indent +
                 "}\n";
        return indent + "if (" + Condition(node.parts[0]) + ") {\n" + yes + indent + "}" +
               (no.empty() ? "" : " else {\n" + no + indent + "}") + "\n";
      }
      case Kind::kCount: {
        const std::string name = Renamed(node.text), limit = Expression(node.parts[1]);
        const std::string count =
            "if (" + name + " < " + limit + ") " + (Otherwise() ? name + " = " + name + " + 1;" : name + "++;");
        if (Otherwise())
          return indent + "if (" + Not(Condition(node.parts[0])) + ") " + name + " = 0; else { " + count + " }\n";
        return indent + "if (" + Condition(node.parts[0]) + ") { " + count + " } else " + name + " = 0;\n";
      }
      case Kind::kRepeat: {
        const std::string name = Expression(node.parts[0]), number = Expression(node.parts[1]);
        const std::string body = name + " = " + name + " " + node.text + " " + number;
        if (Otherwise()) {
          std::string text;
          for (size_t i = 0; i < node.yes; ++i) text += indent + body + " + (R[" + std::to_string(i) + "] & 3);\n";
          return text;
        }
        return indent + "for (i = 0; i < " + std::to_string(node.yes) + "; i++) " + body + " + (R[i] & 3);\n";
      }
      case Kind::kSwitch: {
        std::string text = indent + "switch (" + Expression(node.parts[0]) + " & 3) {\n";
        std::vector<size_t> order{1, 2, 3};
        if (Otherwise()) std::swap(order[1], order[2]);
        for (const size_t which : order) {
          text += inner + "case " + std::to_string(which - 1) + ":\n" + Statement(*node.parts[which], inner + "  ") +
                  inner + "  break;\n";
        }
        return text + indent + "}\n";
      }
      default:
        return {};
    }
  }

  Random* random_;
  Tree mixed_;
  std::string parameter_;
  bool renames_ = false;
};

struct HncProgram {
  Tree mixed;  // what the function computes
  NodeList fast, slow;
};

std::string Print(const HncProgram& program, Random* random, bool renames) {
  Writer writer(random, program.mixed);
  if (renames) writer.RenameAll();
  const auto name = [&](const std::string& of) { return writer.Renamed(of); };
  std::string text = "#include \"plc.h\"\n";
  text += "int " + name("a0") + ", " + name("a1") + ";\nunsigned " + name("u0") + ";\nlong " + name("l0") +
          ";\nunsigned char " + name("c0") + ", " + name("c1") + ";\nint " + name("t0") + ", " + name("t1") + ", " +
          name("t2") + ";\n";
  text += "int twice(int p) { return " + std::string(writer.Otherwise() ? "p + p" : "2 * p") + "; }\n";
  text += "int mixed(int p) { return " + writer.Expression(program.mixed) + "; }\n";
  text += "void init() { plc1_time = 8; plc2_time = 16; }\nvoid plc1() {\n  int i;\n";
  if (writer.Otherwise()) text += "  int unused;\n";
  text += writer.Statements(program.fast, 0, program.fast.size(), "  ");
  text += "}\nvoid plc2() {\n  int i;\n" + writer.Statements(program.slow, 0, program.slow.size(), "  ") + "}\n";
  return text;
}

}  // namespace

Pair RandomHncPair(Random& random) {
  Generator generator(random);
  HncProgram made;
  generator.InFunction(true);
  made.mixed = generator.Expression(2);
  generator.InFunction(false);
  for (uint32_t i = 2 + Below(random, 5); i > 0; --i) made.fast.push_back(generator.Statement(2));
  for (uint32_t i = Below(random, 5); i > 0; --i) made.slow.push_back(generator.Statement(2));
  Pair pair{.old_program = {.dialect = "hnc", .sources = {"p.cld"}, .files = {}, .options = {}, .scenario = {}},
            .new_program = {},
            .what = "written in another way",
            .alike = true,
            .renames = random.OneIn(4)};
  pair.new_program = pair.old_program;
  pair.old_program.files["p.cld"] = Print(made, nullptr, false);
  pair.new_program.files["p.cld"] = Print(made, &random, pair.renames);
  return pair;
}

}  // namespace plcxx::pairs
