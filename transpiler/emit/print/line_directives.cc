// #line directives: compilers and debuggers name the statement of the source.
//
//   m[a] = m[b];   ->   #line 3 "lamp.plc"
//                       m[a] = m[b];

#include <utility>

#include "transpiler/emit/print/cpp_printer.h"

namespace plcxx::emit::print {
namespace {

struct Origin {
  std::string file;
  uint32_t line = 0;

  bool operator==(const Origin&) const = default;
};

/// Copies a file line by line, and says where a line comes from wherever that is not what follows from the line before.
class Directives {
 public:
  Directives(const OutputFile& file, const ir::Program& program, const source::SourceManager& sources)
      : file_(file), program_(program), sources_(sources) {}

  OutputFile Run();

 private:
  Origin OriginOf(ir::StatementId statement) const;
  void Line(std::string_view line);

  const OutputFile& file_;
  const ir::Program& program_;
  const source::SourceManager& sources_;
  std::string out_;
  uint32_t written_ = 0;   // lines
  ir::StatementId owner_;  // of the next line
  Origin implied_;         // what a compiler takes the next line for
};

/// Where a statement is in the source; else, the generated file itself: the next line, after a directive.
Origin Directives::OriginOf(ir::StatementId statement) const {
  if (statement.valid()) {
    const source::Position at = sources_.Locate(program_.statements[statement].range.begin);
    if (at.file.valid()) return {sources_.Get(at.file).path, at.line};
  }
  return {file_.name, written_ + 2};
}

void Directives::Line(std::string_view line) {
  const size_t first = line.find_first_not_of(' ');
  const bool is_code = first != std::string_view::npos && !line.substr(first).starts_with("//");
  Origin origin = OriginOf(owner_);
  // Of the file's own lines nothing is said where nothing was said of others before.
  const bool own = origin.file == file_.name;
  const bool follows = own ? implied_ == Origin{file_.name, written_ + 1} : implied_ == origin;
  if (is_code && !follows) {
    out_ += "#line " + std::to_string(origin.line) + " " + CppString(origin.file) + "\n";
    ++written_;
    implied_ = std::move(origin);
  }
  out_.append(line) += '\n';
  ++written_;
  ++implied_.line;
}

OutputFile Directives::Run() {
  implied_ = {file_.name, 1};
  size_t next_owner = 0, next_loop = 0;
  OutputFile result{
      .name = file_.name, .text = {}, .loops = file_.loops, .owners = file_.owners, .locals = file_.locals};
  uint32_t number = 0;
  for (size_t begin = 0; begin < file_.text.size();) {
    const size_t end = file_.text.find('\n', begin);
    ++number;
    const size_t first_owner = next_owner;
    for (; next_owner < file_.owners.size() && file_.owners[next_owner].line <= number; ++next_owner)
      owner_ = file_.owners[next_owner].statement;
    Line(std::string_view(file_.text).substr(begin, end - begin));
    for (size_t i = first_owner; i < next_owner; ++i) result.owners[i].line = written_;
    for (; next_loop < file_.loops.size() && file_.loops[next_loop].line == number; ++next_loop)
      result.loops[next_loop].line = written_;
    begin = end + 1;
  }
  result.text = std::move(out_);
  return result;
}

}  // namespace

OutputFile WithLineDirectives(const OutputFile& file, const ir::Program& program,
                              const source::SourceManager& sources) {
  return Directives(file, program, sources).Run();
}

}  // namespace plcxx::emit::print
