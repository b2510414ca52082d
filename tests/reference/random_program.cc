#include "tests/reference/random_program.h"

#include "tests/reference/capricious_control.h"

namespace plcxx::reference {
namespace {

void Append(const std::vector<Piece>& pieces, std::string& text) {
  const auto line = [&text](const std::string& words) {
    if (words.empty()) return;
    text += words;
    text += '\n';
  };
  for (const Piece& piece : pieces) {
    line(piece.text);
    Append(piece.body, text);
    line(piece.end);
  }
}

}  // namespace

std::vector<RenderedFile> Render(const RandomProgram& program, const std::string& dialect) {
  std::vector<RenderedFile> files;
  std::string sources;
  for (const RandomFile& file : program.files) {
    RenderedFile& rendered = files.emplace_back(file.name, "");
    std::string text;
    Append(file.pieces, text);
    rendered.text = file.head;
    for (const char c : text) {
      if (c == '\n') {
        rendered.text += file.line_end;
      } else {
        rendered.text += c;
      }
    }
    rendered.text += file.tail;
    if (file.is_source) sources += (sources.empty() ? "" : ", ") + file.name;
  }
  std::string scenario = "dialect: " + dialect + "\nsources: [" + sources + "]\n";
  if (program.caprices) scenario += CapriciousLine(*program.caprices);
  if (!program.options.empty()) {
    scenario += "options:\n";
    for (const auto& [key, value] : program.options) scenario += "  " + key + ": '" + value + "'\n";
  }
  scenario += "steps:\n";
  for (const std::string& step : program.steps) scenario += "  - " + step + "\n";
  files.push_back({"scenario.yaml", scenario});
  return files;
}

}  // namespace plcxx::reference
