/// Standard input as a model. More mistakes of newcomers: scripts/mistakes.txt.

#include <fcntl.h>
#include <unistd.h>

#include "draw_program.hpp"

namespace ligne::test {
namespace {

class MistakesOfNewcomers : public DrawTest {
 protected:
  /// Standard input is what stands in a file, through a pipe.
  Outcome run_with_input(const std::string& bytes, const Words& arguments) const {
    int ends[2];
    EXPECT_EQ(pipe2(ends, O_CLOEXEC), 0);
    EXPECT_EQ(write_all(ends[1], bytes), bytes.size());
    close(ends[1]);
    const int before = dup(STDIN_FILENO);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    const Outcome outcome = run(arguments);
    dup2(before, STDIN_FILENO);
    close(before);
    return outcome;
  }

 private:
  static std::size_t write_all(int descriptor, const std::string& bytes) {
    return static_cast<std::size_t>(::write(descriptor, bytes.data(), bytes.size()));
  }
};

TEST_F(MistakesOfNewcomers, StandardInputIsAModel) {
  const std::string expected = contents(file("cube.obj"));
  const Outcome named = run("draw cube.obj -o - --format json");
  const Outcome piped = run_with_input(expected, "draw - -o - --format json");
  EXPECT_EQ(piped.status, kDone) << piped.err;
  EXPECT_EQ(json::parse(piped.out)["strokes"].size(), json::parse(named.out)["strokes"].size());
  const Outcome info = run_with_input(expected, "info -");
  EXPECT_EQ(info.out.substr(0, 15), "standard input\n") << info.err;
  EXPECT_EQ(run_with_input("", "draw - -o a.svg").err, "ligne: standard input: is empty\n");
  EXPECT_EQ(run_with_input("v 0 0 0\nf 1 2 9\n", "draw - -o a.svg").err.rfind("ligne: standard input:2: ", 0), 0u);
}

}  // namespace
}  // namespace ligne::test
