#include "cli/messages.hpp"

#include <cstdio>

#include "files/message_text.hpp"

namespace ligne {

void say(std::string_view text) {
  const std::string line = "ligne: " + message_line(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

void warn(const std::string& place, const std::string& text) { say(place + ": warning: " + text); }

void warn(const std::string& place, const Warnings& warnings, bool with_areas) {
  for (const std::string& line : warnings.lines(with_areas)) warn(place, line);
}

}  // namespace ligne
