#include "transpiler/dialects/hnc/control/editing.h"

#include <algorithm>
#include <set>
#include <utility>

#include "transpiler/dialects/hnc/machine/machine.h"
#include "transpiler/dialects/hnc/parser/parser.h"
#include "transpiler/dialects/hnc/source/c_words.h"

namespace plcxx::hnc {
namespace {

using dialects::Definition;
using dialects::DefinitionKind;
using dialects::EditorToken;
using dialects::TokenRole;

std::vector<EditorToken> EditorTokens(dialects::Request& request, source::FileId file) {
  return CWords(request.sources->Get(file));
}

class NameCollector {
 public:
  NameCollector(const Unit& unit, const source::SourceManager& sources) : unit_(unit), sources_(sources) {}

  std::vector<Definition> Run() {
    for (const Macro& macro : unit_.macros) {
      if (macro.is_system) continue;
      Add(macro.name, macro.has_parameters ? DefinitionKind::kMacro : DefinitionKind::kConstant, macro.range,
          macro.range, MacroText(macro.range));
    }
    for (const Record& record : unit_.records) AddRecord(record);
    for (uint32_t i = 0; i < unit_.functions.size(); ++i) AddFunction(unit_.functions[FunctionId(i)]);
    for (const Variable& variable : unit_.variables) AddVariable(variable);
    return std::move(definitions_);
  }

 private:
  Definition* Add(const std::string& name, DefinitionKind kind, source::Range name_range, source::Range range,
                  std::string detail) {
    // What a macro's text declares has the place of the macro's use: nothing there spells the name.
    if (name.empty() || name_range.begin == 0 || sources_.Text(name_range) != name) return nullptr;
    definitions_.push_back({.name = name,
                            .kind = kind,
                            .name_range = name_range,
                            .range = range,
                            .scope = {},
                            .address = {},
                            .detail = std::move(detail),
                            .comment = CommentAt(name_range)});
    return &definitions_.back();
  }

  /// The rest of the line after the name of a #define.
  std::string MacroText(source::Range name) const {
    const source::Position at = sources_.Locate(name.begin);
    if (!at.file.valid()) return {};
    const source::File& file = sources_.Get(at.file);
    const size_t begin = name.end - file.base;
    const size_t end = std::min(file.text.find_first_of("\r\n", begin), file.text.size());
    std::string text = file.text.substr(begin, end - begin);
    text = text.substr(0, std::min(text.find("/*"), text.find("//")));
    const size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(" \t") + 1 - first);
  }

  /// The comment that begins on the line of a name, or the one that ends on the line above and is not about what stands
  /// in front of it there.
  std::string CommentAt(source::Range name) const {
    const source::Position at = sources_.Locate(name.begin);
    const auto next = std::ranges::lower_bound(unit_.comments, name.end, {},
                                               [](const Comment& comment) { return comment.range.begin; });
    if (next != unit_.comments.end()) {
      const source::Position place = sources_.Locate(next->range.begin);
      if (place.file == at.file && place.line == at.line) return next->text;
    }
    if (next == unit_.comments.begin()) return {};
    const Comment& above = *std::prev(next);
    const source::Position end = sources_.Locate(above.range.end);
    if (end.file != at.file || end.line + 1 != at.line) return {};
    const source::Position begin = sources_.Locate(above.range.begin);
    const source::File& file = sources_.Get(at.file);
    const source::Offset line = file.base + file.line_starts[begin.line - 1];
    const std::string_view before = sources_.Text({line, above.range.begin});
    return before.find_first_not_of(" \t") == std::string_view::npos ? above.text : std::string();
  }

  void AddRecord(const Record& record) {
    Add(record.name, DefinitionKind::kType, record.range, record.range, record.is_union ? "union" : "struct");
    for (const Member& member : record.members) {
      Add(member.name, DefinitionKind::kField, member.range, member.range, unit_.types[member.type].text);
    }
  }

  source::Range RangeOf(const Function& function) const {
    if (!function.is_defined || !function.body.valid()) return function.range;
    return {function.head.begin, std::max(function.head.end, unit_.statements[function.body].range.end)};
  }

  void AddFunction(const Function& function) {
    if (function.system || !function.is_defined) return;
    std::string detail = unit_.types[function.result].text + " " + function.name + "(";
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      const Variable& parameter = unit_.variables[function.parameters[i]];
      detail += (i == 0 ? "" : ", ") + unit_.types[parameter.type].text + " " + parameter.name;
    }
    const source::Range range = RangeOf(function);
    Add(function.name, DefinitionKind::kRoutine, function.range, range, detail + ")");
    for (const LabelId id : function.labels) {
      const Label& label = unit_.labels[id];
      if (Definition* added = Add(label.name, DefinitionKind::kLabel, label.range, label.range, "label")) {
        added->scope = range;
      }
    }
  }

  void AddVariable(const Variable& variable) {
    if (variable.storage == Storage::kSystem || variable.storage == Storage::kUndefined) return;
    const bool is_parameter = variable.storage == Storage::kParameter;
    Definition* added = Add(variable.name, is_parameter ? DefinitionKind::kParameter : DefinitionKind::kVariable,
                            variable.range, variable.range, unit_.types[variable.type].text);
    if (added == nullptr) return;
    if (variable.function.valid()) {
      added->scope = RangeOf(unit_.functions[variable.function]);
    } else {
      added->address = variable.name;
    }
  }

  const Unit& unit_;
  const source::SourceManager& sources_;
  std::vector<Definition> definitions_;
};

std::vector<Definition> EditorDefinitions(dialects::Request& request) {
  Unit unit = Parse(request);
  std::vector<Definition> definitions = NameCollector(unit, *request.sources).Run();
  Keep(request, std::move(unit));
  return definitions;
}

/// "int", "long" of "void set_axis_step(int, long);".
std::vector<std::string> ParametersOf(std::string_view prototype) {
  std::vector<std::string> parameters;
  const size_t open = prototype.find('('), close = prototype.rfind(')');
  std::string_view rest = prototype.substr(open + 1, close - open - 1);
  while (!rest.empty() && rest != "void") {
    size_t end = 0;
    for (int depth = 0; end < rest.size() && (rest[end] != ',' || depth > 0); ++end) {
      depth += rest[end] == '(' ? 1 : rest[end] == ')' ? -1 : 0;
    }
    parameters.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    while (rest.starts_with(' ')) rest.remove_prefix(1);
  }
  return parameters;
}

std::vector<dialects::Word> EditorWords() {
  std::vector<dialects::Word> words;
  for (const FunctionRow& row : SystemFunctions()) {
    words.push_back({.name = std::string(row.name),
                     .role = TokenRole::kFunction,
                     .meaning = std::string(row.prototype),
                     .parameters = ParametersOf(row.prototype)});
  }
  for (const std::string_view word : CKeywords()) {
    words.push_back({.name = std::string(word), .role = TokenRole::kKeyword, .meaning = {}, .parameters = {}});
  }
  return words;
}

/// The names of the system header.
std::vector<dialects::ControlSignal> EditorSignals(const dialects::Request&) {
  std::vector<dialects::ControlSignal> signals;
  const auto add = [&signals](std::string name, std::string meaning) {
    signals.push_back(
        {.address = name, .name = std::move(name), .meaning = std::move(meaning), .has_name_in_programs = true});
  };
  for (const AreaRow& area : Areas()) {
    add(std::string(area.name), std::string(area.basic) + (area.table ? " *" : ""));
    for (const ViewRow& view : Views()) {
      add(std::string(area.name) + std::string(view.suffix), std::string(view.type) + (area.table ? " *" : ""));
    }
  }
#define HNC_POINTER(Name, Parameters, Table, Index) add(Name, Table "[" Index "]");
#define HNC_ADDRESS(Name, Parameters, Text) add(Name, Text);
#define HNC_CELL(Name, Number) add(Name, "*ch_mst_mod(ch, " #Number ")");
#define HNC_CONSTANT(Name, Text) add(Name, Text);
#include "transpiler/dialects/hnc/machine/machine.def"
  return signals;
}

std::string NameKey(std::string_view spelling) { return std::string(spelling); }
source::Range NamePart(source::Range range, std::string_view) { return range; }

}  // namespace

const dialects::Editing kEditing = {.tokens = EditorTokens,
                                    .definitions = EditorDefinitions,
                                    .key = NameKey,
                                    .name_part = NamePart,
                                    .words = EditorWords,
                                    .signals = EditorSignals,
                                    .opening = "(",
                                    .separators = ","};

}  // namespace plcxx::hnc
