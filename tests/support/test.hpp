// A guard by name, because this header is precompiled. GCC recognizes a file with "#pragma once" by its bytes, while ccache
// returns the header that was precompiled before a comment changed.
#ifndef LIGNE_TESTS_SUPPORT_TEST_HPP
#define LIGNE_TESTS_SUPPORT_TEST_HPP
/// The head of every test: GoogleTest, the standard library and GLM, precompiled once for all test programs; and what tests
/// of any area do with files and errors.

#include <gtest/gtest.h>

#include "support/standard.hpp"

namespace ligne::test {

/// The bytes of a file; none where there is no such file.
inline std::string bytes_of_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The bytes of a number as they lie in memory.
template <class Number>
std::string raw(const Number& number) {
  return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// The message of the call's failure; empty when it does not fail.
template <std::invocable Call>
std::string failure_of(const Call& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

/// Each of the parts stands in the text; none of them does.
inline void expect_parts(std::string_view text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts)
    EXPECT_NE(text.find(part), text.npos) << "\"" << part << "\" is not in: " << text;
}
inline void expect_no_parts(std::string_view text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) EXPECT_EQ(text.find(part), text.npos) << "\"" << part << "\" is in: " << text;
}

/// A test is named by its parameter, which is a file.
inline constexpr auto kNameOfFile = [](const auto& info) {
  std::string name = std::filesystem::path(info.param).filename().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  return name;
};

/// A new folder that goes when the test is over.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "ligne-test-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": can not be made");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  operator const std::filesystem::path&() const { return path_; }
  std::string string() const { return path_.string(); }
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }
  /// Writes a file into it and gives its path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view bytes) const {
    std::ofstream(path_ / name, std::ios::binary) << bytes;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

}  // namespace ligne::test

#endif
