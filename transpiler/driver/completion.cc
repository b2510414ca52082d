#include "transpiler/driver/completion.h"

namespace plcxx::driver {
namespace {

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string CommandNames(const std::vector<CommandRow>& table) {
  std::string names;
  for (const CommandRow& command : table) {
    if (!command.name.empty()) names += (names.empty() ? "" : " ") + command.name;
  }
  return names;
}

/// Without what ends a word in quotes of a shell, or means something to its completion.
std::string Plain(const std::string& text) {
  std::string plain;
  for (const char c : text) {
    if (c == '\'' || c == '`' || c == '"' || c == '$' || c == '\\') continue;
    plain += c == '[' ? '(' : c == ']' ? ')' : c == ':' ? ',' : c;
  }
  return plain;
}

std::string Bash(const std::vector<CommandRow>& table) {
  std::string values, options;
  for (const CommandRow& command : table) {
    std::string names;
    for (const OptionRow& option : command.options) {
      for (const std::string& name : option.names) {
        names += " " + name;
        if (!option.values.empty())
          values += "    " + command.name + ":" + name + ") words='" + Joined(option.values) + "' ;;\n";
        else if (option.takes_value)
          values += "    " + command.name + ":" + name + ") compopt -o default; return ;;\n";
      }
    }
    options += "    '" + command.name + "') words='" + (names.empty() ? "" : names.substr(1)) + "' ;;\n";
  }
  return "# bash completion of plcxx, made by plcxx completion bash\n"
         "_plcxx() {\n"
         "  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} command= words=\n"
         "  COMPREPLY=()\n"
         "  [ \"$COMP_CWORD\" -gt 1 ] && command=${COMP_WORDS[1]}\n"
         "  if [ \"$COMP_CWORD\" -eq 1 ] && [ \"${current#-}\" = \"$current\" ]; then\n"
         "    COMPREPLY=($(compgen -W '" +
         CommandNames(table) +
         "' -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$command:$previous\" in\n"
         "    explain:explain|completion:completion|print:print) ;;\n" +
         values +
         "  esac\n"
         "  if [ -n \"$words\" ]; then\n"
         "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
         "    return\n"
         "  fi\n"
         "  case \"$command\" in\n" +
         options +
         "  esac\n"
         "  case \"$current\" in\n"
         "    -*) COMPREPLY=($(compgen -W \"$words\" -- \"$current\")) ;;\n"
         "    *) compopt -o default ;;\n"
         "  esac\n"
         "}\n"
         "complete -F _plcxx plcxx\n";
}

std::string Zsh(const std::vector<CommandRow>& table) {
  std::string text =
      "#compdef plcxx\n"
      "# zsh completion of plcxx, made by plcxx completion zsh\n"
      "local -a commands\n"
      "commands=(\n";
  for (const CommandRow& command : table) {
    if (!command.name.empty()) text += "  '" + command.name + ":" + Plain(command.meaning) + "'\n";
  }
  text +=
      ")\n"
      "if (( CURRENT == 2 )); then\n"
      "  _describe 'command' commands\n"
      "  return\n"
      "fi\n"
      "local command=$words[2]\n"
      "shift words\n"
      "(( CURRENT-- ))\n"
      "case $command in\n";
  for (const CommandRow& command : table) {
    if (command.name.empty()) continue;
    text += command.name + ")\n  _arguments -S";
    for (const OptionRow& option : command.options) {
      for (const std::string& name : option.names) {
        text += " \\\n    '*" + name + (option.takes_value ? (name.starts_with("--") ? "=" : "+") : "") + "[" +
                Plain(option.meaning) + "]";
        if (option.takes_value) {
          text += ":" + Plain(option.placeholder) + ":" +
                  (option.values.empty() ? std::string("_files") : "(" + Plain(Joined(option.values)) + ")");
        }
        text += "'";
      }
    }
    text += " \\\n    '*:file:_files'\n  ;;\n";
  }
  return text + "esac\n";
}

std::string Fish(const std::vector<CommandRow>& table) {
  std::string text = "# fish completion of plcxx, made by plcxx completion fish\n";
  for (const CommandRow& command : table) {
    if (!command.name.empty()) {
      text +=
          "complete -c plcxx -n __fish_use_subcommand -f -a " + command.name + " -d '" + Plain(command.meaning) + "'\n";
    }
    for (const OptionRow& option : command.options) {
      if (option.names.empty()) continue;
      text += "complete -c plcxx -n " + (command.name.empty() ? std::string("__fish_use_subcommand")
                                                              : "'__fish_seen_subcommand_from " + command.name + "'");
      for (const std::string& name : option.names)
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (!option.values.empty())
        text += " -x -a '" + Joined(option.values) + "'";
      else if (option.takes_value)
        text += " -r";
      text += " -d '" + Plain(option.meaning) + "'\n";
    }
  }
  return text;
}

}  // namespace

std::optional<std::string> CompletionScript(std::string_view shell, const std::vector<CommandRow>& table) {
  if (shell == "bash") return Bash(table);
  if (shell == "zsh") return Zsh(table);
  if (shell == "fish") return Fish(table);
  return std::nullopt;
}

}  // namespace plcxx::driver
