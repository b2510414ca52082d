// Manual pages, in the roff that man reads.
#include <string>
#include <string_view>
#include <vector>

#include "transpiler/driver/completion.h"

namespace plcxx::driver {
namespace {

/// A text as roff prints it: no line begins a request, and '-' can be typed as it is shown.
std::string Roff(std::string_view text) {
  std::string roff;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool begins = i == 0 || text[i - 1] == '\n';
    if (begins && (text[i] == '.' || text[i] == '\'')) roff += "\\&";
    if (text[i] == '\\') {
      roff += "\\e";
    } else if (text[i] == '-') {
      roff += "\\-";
    } else {
      roff += text[i];
    }
  }
  return roff;
}

std::string Verbatim(const std::string& text) { return text.empty() ? "" : ".nf\n" + Roff(text) + "\n.fi\n"; }

std::string OptionText(const OptionRow& option) {
  std::string heading;
  for (const std::string& name : option.names)
    heading += (heading.empty() ? "" : ", ") + std::string("\\fB") + Roff(name) + "\\fR";
  if (option.names.empty()) heading = "\\fI" + Roff(option.placeholder) + "\\fR";
  if (!option.names.empty() && option.takes_value) heading += " \\fI" + Roff(option.placeholder) + "\\fR";
  std::string text = ".TP\n" + heading + "\n" + Roff(option.meaning) + "\n";
  if (!option.values.empty()) {
    std::string values;
    for (const std::string& value : option.values) values += (values.empty() ? "" : ", ") + value;
    text += "(" + Roff(values) + ")\n";
  }
  return text;
}

}  // namespace

std::string ManualPage(const CommandRow& command, const std::vector<CommandRow>& table) {
  const bool whole = command.name.empty();
  const std::string title = whole ? "plcxx" : "plcxx-" + command.name;
  std::string page = ".TH " + Roff(title) + " 1 \"\" plcxx plcxx\n.SH NAME\n" + Roff(title) + " \\- " +
                     Roff(command.meaning) + "\n.SH SYNOPSIS\n\\fBplcxx" + (whole ? "" : " " + Roff(command.name)) +
                     "\\fR [\\fIOPTION\\fR]...";
  for (const OptionRow& option : command.options) {
    if (option.names.empty()) page += " [\\fI" + Roff(option.placeholder) + "\\fR]...";
  }
  page += "\n";
  if (whole) {
    page += ".SH COMMANDS\n";
    for (const CommandRow& one : table) {
      if (!one.name.empty()) page += ".TP\n\\fBplcxx\\-" + Roff(one.name) + "\\fR(1)\n" + Roff(one.meaning) + "\n";
    }
  }
  std::vector<std::string> groups;  // in the order of their first options
  for (const OptionRow& option : command.options) {
    bool known = false;
    for (const std::string& group : groups) known = known || group == option.group;
    if (!known) groups.push_back(option.group);
  }
  page += ".SH OPTIONS\n";
  for (const std::string& group : groups) {
    if (groups.size() > 1) page += ".SS " + Roff(group) + "\n";
    for (const OptionRow& option : command.options) {
      if (option.group == group) page += OptionText(option);
    }
  }
  if (!command.footer.empty()) page += ".SH MORE\n" + Verbatim(command.footer);
  return page + ".SH SEE ALSO\n" + (whole ? "The guide in the folder of plcxx's documents.\n" : "\\fBplcxx\\fR(1)\n");
}

}  // namespace plcxx::driver
