#pragma once
/// Texts held against files of tests/golden/. Run with LIGNE_UPDATE_GOLDENS=1 to write them anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

namespace ligne {

inline std::string golden_file(const std::string& name) { return LIGNE_SOURCE_DIR "/tests/golden/" + name; }

/// An empty text, or what is different.
inline std::string difference(const std::string& name, const std::string& text) {
  std::ifstream in(golden_file(name), std::ios::binary);
  if (!in) return name + " is missing";
  const std::string wanted{std::istreambuf_iterator<char>(in), {}};
  if (wanted == text) return "";
  const auto at =
      static_cast<std::size_t>(std::mismatch(wanted.begin(), wanted.end(), text.begin(), text.end()).first - wanted.begin());
  return name + " differs at byte " + std::to_string(at) + ": " + text.substr(at, 60);
}

inline void expect_golden(const std::string& name, const std::string& text) {
  if (std::getenv("LIGNE_UPDATE_GOLDENS")) std::ofstream(golden_file(name), std::ios::binary) << text;
  EXPECT_EQ(difference(name, text), "");
}

}  // namespace ligne
