#pragma once
/// The options of the command as a table, from which man pages and completions are made.

#include <string>
#include <vector>

namespace ligne {

struct OptionEntry {
  std::vector<std::string> names;  ///< "--output", "-o"
  std::string kind;                ///< what stands for the value; empty for a flag
  std::string standard;            ///< what holds when it is not given; may be empty
  std::string help, group;
  std::vector<std::string> words;  ///< values that can be completed
  bool is_file = false;            ///< the value is a file
  bool may_stand_alone = false;    ///< the value can be left out
  bool repeatable = false;
};

struct CommandEntry {
  std::string name;  ///< empty: the program itself
  std::string help, footer;
  std::vector<OptionEntry> positionals, options;
};

/// The program and its commands.
std::vector<CommandEntry> command_table();

/// A page of section 1 for the program, and one for each command, as troff.
std::string man_page(const CommandEntry& command, const std::vector<CommandEntry>& all, const std::string& version);

std::string bash_completion(const std::vector<CommandEntry>& commands);
std::string zsh_completion(const std::vector<CommandEntry>& commands);
std::string fish_completion(const std::vector<CommandEntry>& commands);

}  // namespace ligne
