#include "cli/text.hpp"

#include <array>
#include <charconv>
#include <cstdio>

#include "files/message_text.hpp"

namespace ligne {
namespace {

std::string print(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

}  // namespace

std::string shortest(double value) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string rounded(double value, int digits) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, value);
  return buffer.data();
}

std::string duration(double seconds) { return seconds < 1 ? print("%.2f ms", seconds * 1000) : print("%.2f s", seconds); }

void say(std::string_view text) {
  const std::string line = "ligne: " + message_line(text) + "\n";
  std::fwrite(line.data(), 1, line.size(), stderr);
}

}  // namespace ligne
