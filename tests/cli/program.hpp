#pragma once
/// Runs the command in a folder of its own: in this process, or as a program where processes matter.

#include <nlohmann/json.hpp>

#include "support/test.hpp"

namespace ligne::test {

struct Outcome {
  int status = -1;  ///< exit status, or 128 + signal
  std::string out, err;

  std::size_t error_lines() const;
};

/// The words of a command line. A text is taken apart at its spaces, but for what stands in '...'.
class Words : public std::vector<std::string> {
 public:
  Words() = default;
  Words(const char* line);
  Words(std::initializer_list<std::string> words) : vector(words) {}
  Words(const std::vector<std::string>& words) : vector(words) {}

  Words& operator+=(const Words& more);
  friend Words operator+(Words words, const Words& more) { return words += more; }
};

inline constexpr int kDone = 0, kFailed = 1, kUsage = 2;  ///< exit statuses
inline constexpr double kMicrometre = 1e-3;               ///< in mm

/// How often `part` occurs in `text`.
std::size_t count_of(const std::string& text, const std::string& part);

/// Runs the command with these arguments in this process; the folder is its current one. A text that is given comes through
/// a pipe as standard input.
Outcome run_ligne(const std::filesystem::path& folder, const Words& arguments, const std::string* piped = nullptr);

/// Runs the built program. Standard output goes to the descriptor `out_fd`, which is closed, or else into the outcome.
Outcome run_program(const std::filesystem::path& folder, const Words& arguments, int out_fd = -1);

/// The bytes of a file.
std::string contents(const std::filesystem::path& file);

/// A fresh folder per test, with models in it: cube.obj (edge 20, y up), square.obj (open), and
/// broken.obj.
class ProgramTest : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  Outcome run(const Words& arguments) const { return run_ligne(folder_, arguments); }
  /// Runs, and expects that it is done.
  Outcome run_well(const Words& arguments) const;
  /// Runs, and looks at the status and at parts of what stands on standard error.
  void expect_outcome(const Words& arguments, int status, std::initializer_list<std::string_view> parts) const;
  void write(const std::string& name, std::string_view text) const;
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  bool exists(const std::string& name) const { return std::filesystem::exists(file(name)); }
  /// Names of the files that were not there at the start, sorted.
  std::vector<std::string> new_files() const;

  std::filesystem::path folder_;

 private:
  std::vector<std::string> files_at_start_;
};

using nlohmann::json;

/// Tests of `ligne draw`.
class DrawTest : public ProgramTest {
 protected:
  /// The JSON drawing of the arguments.
  json drawn(const Words& arguments) const {
    const Outcome outcome = run_well("draw" + arguments + "-o - --format json");
    EXPECT_EQ(outcome.err, "");
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
};

/// Numbers of strokes by class; hidden ones under "hidden".
inline std::map<std::string, int> strokes_by_class(const json& drawing) {
  std::map<std::string, int> counts;
  for (const json& stroke : drawing["strokes"])
    ++counts[stroke["visible"].get<bool>() ? stroke["class"].get<std::string>() : "hidden"];
  return counts;
}

}  // namespace ligne::test
