#include <algorithm>

#include "option_table.hpp"

namespace ligne {
namespace {

/// Text as troff reads it: no escapes, no requests.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
      out += c;
    }
  }
  return out;
}

std::string page_name(const CommandEntry& command) { return command.name.empty() ? "ligne" : "ligne-" + command.name; }

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

std::string paragraph(const OptionEntry& option) {
  std::string text = ".TP\n";
  for (std::size_t i = 0; i < option.names.size(); ++i)
    text += (i > 0 ? ", " : "") + ("\\fB" + roff(option.names[i]) + "\\fR");
  if (!option.kind.empty()) text += " \\fI" + roff(option.kind) + "\\fR";
  text += "\n" + roff(option.help);
  if (!option.standard.empty()) text += " (default: " + roff(option.standard) + ")";
  return text + "\n";
}

std::string examples(const std::string& footer) {
  const std::size_t begin = footer.find("  ligne");
  if (begin == std::string::npos) return "";
  return ".SH EXAMPLES\n.nf\n" + roff(footer.substr(begin)) + "\n.fi\n";
}

}  // namespace

std::string man_page(const CommandEntry& command, const std::vector<CommandEntry>& all, const std::string& version) {
  const std::string name = page_name(command);
  std::string page = ".TH " + upper(roff(name)) + " 1 \"\" \"ligne " + version + "\" \"Ligne Claire\"\n";
  page += ".SH NAME\n" + roff(name + " - " + command.help) + "\n.SH SYNOPSIS\n.B ligne";
  page += command.name.empty() ? "\n.I COMMAND\n" : " " + command.name + "\n";
  page += "[\\fIOPTIONS\\fR]";
  for (const OptionEntry& positional : command.positionals) page += " \\fI" + roff(positional.names.front()) + "\\fR";
  page += "\n";
  if (command.name.empty()) {
    page += ".SH COMMANDS\n";
    for (const CommandEntry& other : all) {
      if (!other.name.empty()) page += ".TP\n\\fB" + other.name + "\\fR\n" + roff(other.help) + "\n";
    }
  }
  page += ".SH OPTIONS\n";
  for (const OptionEntry& positional : command.positionals) page += paragraph(positional);
  std::vector<std::string> groups;  // in the order in which they come up
  for (const OptionEntry& option : command.options) {
    if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) groups.push_back(option.group);
  }
  for (const std::string& group : groups) {
    page += ".SS " + group + "\n";
    for (const OptionEntry& option : command.options) {
      if (option.group == group) page += paragraph(option);
    }
  }
  page += examples(command.footer);
  page +=
      ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n1\nthe input or the work failed\n.TP\n2\nthe command line is wrong\n.SH SEE ALSO\n";
  std::string also;
  for (const CommandEntry& other : all) {
    if (other.name != command.name) also += (also.empty() ? "" : ",\n") + (".BR " + roff(page_name(other)) + " (1)");
  }
  return page + also + "\n";
}

}  // namespace ligne
