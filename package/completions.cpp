#include <algorithm>

#include "option_table.hpp"

namespace ligne {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::vector<std::string> command_names(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> names;
  for (const CommandEntry& command : commands) {
    if (!command.name.empty()) names.push_back(command.name);
  }
  return names;
}

std::vector<std::string> option_names(const CommandEntry& command) {
  std::vector<std::string> names;
  for (const OptionEntry& option : command.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

/// What a help text says before it goes into details.
std::string short_help(const OptionEntry& option) { return option.help.substr(0, option.help.find(": ")); }

}  // namespace

std::string bash_completion(const std::vector<CommandEntry>& commands) {
  std::string text = "# bash completion of ligne; made from its tables of options\n_ligne() {\n";
  text += "  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=\n";
  text += "  [[ $current == = ]] && current=\n";
  text += "  [[ $before == = ]] && before=${COMP_WORDS[COMP_CWORD-2]}\n";
  text += "  COMPREPLY=()\n  [[ $COMP_CWORD -eq 1 ]] && command=\n";
  text += "  case \"$command $before\" in\n";
  for (const CommandEntry& command : commands) {
    for (const OptionEntry& option : command.options) {
      if (option.kind.empty() && option.words.empty()) continue;
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) patterns.push_back("'" + command.name + " " + name + "'");
      text += "    " + joined(patterns, "|") + ") ";
      if (option.is_file) {
        text += "compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$current\"); return ;;\n";
      } else if (option.words.empty() || option.may_stand_alone) {
        text += option.may_stand_alone ? ";;\n" : "return ;;\n";
      } else {
        text += "words='" + joined(option.words, " ") + "' ;;\n";
      }
    }
  }
  text += "  esac\n  if [[ -z $words && ( $current == -* || $COMP_CWORD -eq 1 ) ]]; then\n    case $command in\n";
  for (const CommandEntry& command : commands) {
    text += "      '" + command.name + "') words='";
    if (command.name.empty()) text += joined(command_names(commands), " ") + " ";
    text += joined(option_names(command), " ") + "' ;;\n";
  }
  text += "    esac\n  fi\n";
  text += "  if [[ -n $words ]]; then\n    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$current\")\n";
  text += "  else\n    compopt -o filenames\n    mapfile -t COMPREPLY < <(compgen -f -- \"$current\")\n  fi\n}\n";
  return text + "complete -F _ligne ligne\n";
}

std::string zsh_completion(const std::vector<CommandEntry>& commands) {
  const auto quoted = [](const std::string& text) {
    std::string safe = replaced(text, "'", "'\\''");
    for (const char* c : {"[", "]", ":"}) safe = replaced(safe, c, std::string("\\") + c);
    return safe;
  };
  const auto arguments = [&](const CommandEntry& command) {
    std::string text;
    for (const OptionEntry& option : command.options) {
      for (const std::string& name : option.names) {
        text += " \\\n        '";
        if (option.repeatable) text += "*";
        text += name + "[" + quoted(short_help(option)) + "]";
        if (!option.kind.empty()) {
          text += std::string(option.may_stand_alone ? "::" : ":") + quoted(option.kind) + ":";
          if (option.is_file) text += "_files";
          if (!option.words.empty()) text += "(" + joined(option.words, " ") + ")";
        }
        text += "'";
      }
    }
    return text;
  };
  std::string text =
      "#compdef ligne\n# zsh completion of ligne; made from its tables of options\n_ligne() {\n  local -a commands=(\n";
  for (const CommandEntry& command : commands) {
    if (!command.name.empty()) text += "    '" + command.name + ":" + quoted(command.help) + "'\n";
  }
  text += "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n";
  text += "    _arguments" + arguments(commands.front()) + "\n    return\n  fi\n  local command=$words[2]\n";
  text += "  shift words\n  (( CURRENT-- ))\n  case $command in\n";
  for (const CommandEntry& command : commands) {
    if (command.name.empty()) continue;
    text += "    " + command.name + ")\n      _arguments" + arguments(command) + " \\\n        '*:file:_files'\n      ;;\n";
  }
  return text + "  esac\n}\n_ligne \"$@\"\n";
}

std::string fish_completion(const std::vector<CommandEntry>& commands) {
  const auto quoted = [](const std::string& text) { return replaced(replaced(text, "\\", "\\\\"), "'", "\\'"); };
  std::string text = "# fish completion of ligne; made from its tables of options\n";
  for (const CommandEntry& command : commands) {
    const std::string when = command.name.empty() ? "__fish_use_subcommand" : "__fish_seen_subcommand_from " + command.name;
    if (!command.name.empty()) {
      text += "complete -c ligne -n __fish_use_subcommand -f -a " + command.name + " -d '" + quoted(command.help) + "'\n";
    }
    for (const OptionEntry& option : command.options) {
      text += "complete -c ligne -n '" + when + "'";
      for (const std::string& name : option.names) {
        text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      }
      if (!option.kind.empty() && !option.may_stand_alone) text += option.is_file ? " -r" : " -x";
      if (!option.words.empty()) text += " -a '" + joined(option.words, " ") + "'";
      text += " -d '" + quoted(short_help(option)) + "'\n";
    }
  }
  return text;
}

}  // namespace ligne
