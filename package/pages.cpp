/// Writes the man pages and the completions of the command.  ligne_pages FOLDER

#include <exception>
#include <filesystem>
#include <iostream>

#include "option_table.hpp"
#include "plotting/writers/output_file.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: ligne_pages FOLDER\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    const auto commands = ligne::command_table();
    for (const ligne::CommandEntry& command : commands) {
      const std::string name = command.name.empty() ? "ligne.1" : "ligne-" + command.name + ".1";
      ligne::write_output(folder / name, ligne::man_page(command, commands, LIGNE_VERSION));
    }
    ligne::write_output(folder / "ligne.bash", ligne::bash_completion(commands));
    ligne::write_output(folder / "_ligne", ligne::zsh_completion(commands));
    ligne::write_output(folder / "ligne.fish", ligne::fish_completion(commands));
  } catch (const std::exception& e) {
    std::cerr << "ligne_pages: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
