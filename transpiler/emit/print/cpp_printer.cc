#include "transpiler/emit/print/cpp_printer.h"

#include <utility>

#include "transpiler/emit/print/print.h"

namespace plcxx::emit::print {
namespace {

/// Characters that would end a line, hide text or turn its direction (compilers warn of the latter).
bool IsHarmful(unsigned code) {
  return code < 0x20 || code == 0x7F || (code >= 0x80 && code < 0xA0) || code == 0x61C ||
         (code >= 0x200E && code <= 0x200F) || (code >= 0x2028 && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069) || code == 0xFEFF;
}

}  // namespace

std::string CommentText(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    if (i + length > text.size()) length = text.size() - i;
    unsigned code = lead < 0x80 ? lead : lead & (0xFFu >> (length + 1));
    for (size_t k = 1; k < length; ++k) code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
    constexpr unsigned kUndecodable = 0xFFFD;
    if (code == '\t' || code == '\n') {
      out += ' ';
    } else if (code == kUndecodable) {
      out += '?';
    } else if (!IsHarmful(code)) {
      out.append(text, i, length);
    }
    i += length;
  }
  const size_t begin = out.find_first_not_of(' ');
  if (begin == std::string::npos) return "";
  out.erase(0, begin);
  while (out.back() == ' ') out.pop_back();
  // A backslash would join the next line to the comment, and so would the trigraph for one.
  if (out.back() == '\\' || out.ends_with("?\?/")) out += '.';
  return out;
}

std::string CppString(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    // Two question marks may begin a trigraph, which some standards replace and all compilers warn of.
    if (c == '"' || c == '\\' || (c == '?' && out.back() == '?')) out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out + "\"";
}

std::string CppBytes(std::string_view bytes) {
  std::string out;
  for (const char c : CppString(bytes)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      out += c;
      continue;
    }
    out += '\\';  // three digits of 8 end by themselves, whatever follows
    for (const int shift : {6, 3, 0}) out += static_cast<char>('0' + (byte >> shift & 7));
  }
  return out;
}

std::vector<OutputFile> PrintCpp(const Emittable& emittable, const source::SourceManager& sources) {
  const std::string& name = emittable.options.name;
  std::vector<OutputFile> files;
  files.push_back({name + ".hpp", PrintHeader(emittable)});
  for (uint32_t part = 0; part < emittable.parts.size(); ++part) {
    OutputFile file = PrintPart(emittable, sources, part);
    if (emittable.options.line_directives) file = WithLineDirectives(file, *emittable.program, sources);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace plcxx::emit::print
