/// Files of a run: what was read is never written over, and what is written comes all together or not at all.

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "program.hpp"

namespace ligne::test {
namespace {

constexpr std::string_view kPens = "[[pen]]\nnumber = 1\nrest = true\n";
constexpr std::string_view kDevice =
    "name = \"own\"\ntitle = \"Own\"\nlanguage = \"hpgl\"\nstep = 0.025\nlimits = [0, 0, 1000, 1000]\ntravel = \"U{x},{y};\"\n"
    "draw = \"D{points};\"\ndot = \"D;\"\nspeed_down = 10\nspeed_up = 20\nlift_seconds = 1\npen_change_seconds = 1\n";

/// A triangle; the second buffer is of an image, which no drawing reads.
constexpr std::string_view kGltf = R"({"asset": {"version": "2.0"},
 "buffers": [{"byteLength": 36, "uri": "model%20part.bin"}, {"byteLength": 4, "uri": "picture.bin"}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]})";

class Files : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    write("model.gltf", kGltf);
    write("model part.bin", {reinterpret_cast<const char*>(corners), sizeof corners});
    write("picture.bin", "pixl");
    write("pens.toml", kPens);
    write("device.toml", kDevice);
    write("grid.txt", "1 2 3\n4 5 7\n");
    write("lines.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='50mm' viewBox='0 0 50 50'>"
          "<path d='M5 5L40 40' stroke='black' fill='none'/></svg>");
    std::filesystem::create_symlink("pens.toml", file("link.toml"));
    std::filesystem::create_hard_link(file("device.toml"), file("hard.toml"));
    std::filesystem::create_directory(file("folder"));
    names_ = names();
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<std::string> names_;
};

TEST_F(Files, WhatWasReadIsNotWrittenOver) {
  const struct {
    std::vector<std::string> arguments;
    const char* option;
    const char* output;
  } cases[] = {
      {{"draw", "model.gltf", "--format", "svg", "-o", "model part.bin"}, "--output", "model part.bin"},
      {{"draw", "model.gltf", "--format", "svg", "-o", "folder/../picture.bin"}, "--output", "picture.bin"},
      {{"draw", "cube.obj", "model.gltf", "-o", "x.svg", "--stats-json", "model part.bin"},
       "--stats-json",
       "model part.bin"},
      {{"info", "model.gltf", "-o", "model part.bin"}, "--output", "model part.bin"},
      {{"draw", "cube.obj", "--pens", "pens.toml", "--format", "svg", "-o", "pens.toml"}, "--output", "pens.toml"},
      {{"draw", "cube.obj", "--pens", "pens.toml", "--format", "svg", "-o", "link.toml"}, "--output", "pens.toml"},
      {{"draw", "cube.obj", "--pens", "link.toml", "-o", "x.svg", "--stats-json", "pens.toml"}, "--stats-json", "pens.toml"},
      {{"draw", "cube.obj", "--device-file", "device.toml", "-o", "x.hpgl", "--preview", "hard.toml"},
       "--preview",
       "hard.toml"},
      {{"plot", "lines.svg", "--device-file", "device.toml", "-o", "x.hpgl", "--stats-json", "device.toml"},
       "--stats-json",
       "device.toml"},
      {{"plot", "lines.svg", "-o", "x.svg", "--stats-json", "lines.svg"}, "--stats-json", "lines.svg"},
      {{"plot", "lines.svg", "-o", "./lines.svg"}, "--output", "lines.svg"},
      {{"surface", "--grid", "grid.txt", "-o", "x.svg", "--preview", "./grid.txt"}, "--preview", "grid.txt"},
      {{"surface", "--grid", "grid.txt", "-o", "x.svg", "--pens", "pens.toml", "--stats-json", "pens.toml"},
       "--stats-json",
       "pens.toml"},
      {{"surface", "--grid", "grid.txt", "--as-mesh", "-o", "x.obj", "--stats-json", "grid.txt"},
       "--stats-json",
       "grid.txt"},
  };
  for (const auto& c : cases) {
    const std::string before = contents(file(c.output));
    const Outcome outcome = run(c.arguments);
    const std::string line = std::string("ligne: ") + c.option + ": ";
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with(line)) << outcome.err;
    EXPECT_NE(outcome.err.find(" is an input too"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_EQ(contents(file(c.output)), before) << c.output;
    EXPECT_EQ(names(), names_);
  }
}

TEST_F(Files, OneFileHasOneOutput) {
  for (const char* other : {"./x.svg", "folder/../x.svg"}) {
    const Outcome outcome = run({"draw", "cube.obj", "-o", "x.svg", "--stats-json", other});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.err, std::string("ligne: --stats-json: ") + other + " is the output file too\n");
  }
  const Outcome outcome = run({"plot", "lines.svg", "-o", "x.svg", "--preview", "a", "--stats-json", "./a"});
  EXPECT_EQ(outcome.err, "ligne: --stats-json: ./a is the file of --preview too\n");
  EXPECT_EQ(names(), names_);
}

TEST_F(Files, AllOutputsOrNone) {
  write("old.svg", "old");
  names_ = names();
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"draw", "cube.obj", "-o", "old.svg", "--stats-json", "none/stats.json"},
        {"draw", "cube.obj", "-o", "none/new.svg", "--stats-json", "stats.json", "--preview", "preview.svg"},
        {"draw", "cube.obj", "-o", "new.svg", "--preview", "none/preview.svg"},
        {"draw", "cube.obj", "-o", "new.svg", "--stats-json", "/dev/full"},
        {"plot", "lines.svg", "-o", "old.svg", "--stats-json", "none/stats.json"},
        {"surface", "x*y", "-o", "old.svg", "--stats-json", "none/stats.json"},
        {"surface", "x*y", "--as-mesh", "-o", "new.obj", "--stats-json", "none/stats.json"},
        {"info", "cube.obj", "-o", "info.txt", "--stats-json", "none/stats.json"}}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_EQ(names(), names_) << outcome.err;
    EXPECT_EQ(contents(file("old.svg")), "old");
  }
  const Outcome outcome = run({"draw", "cube.obj", "-o", "-", "--format", "svg", "--stats-json", "none/stats.json"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "") << "nothing goes to standard output either";
  EXPECT_EQ(run({"draw", "cube.obj", "-o", "old.svg", "--stats-json", "s.json", "--preview", "p.svg"}).status, 0);
  EXPECT_TRUE(exists("s.json") && exists("p.svg") && contents(file("old.svg")) != "old");
}

/// The drawing stands beside its place, and the program waits for somebody to read the pipe: nobody does.
TEST_F(Files, SignalsLeaveNothing) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  names_ = names();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const pid_t child = fork();
    if (child == 0) {
      std::signal(signal, SIG_DFL);  // a shell starts what runs in the background without SIGINT
      if (chdir(folder_.c_str()) == 0)
        execl(LIGNE_PROGRAM, "ligne", "draw", "cube.obj", "-o", "x.svg", "--stats-json", "pipe", nullptr);
      _exit(127);
    }
    int status = 0;
    while (names() == names_ && waitpid(child, &status, WNOHANG) == 0) usleep(1000);
    for (const std::string& name : names()) {
      if (std::find(names_.begin(), names_.end(), name) != names_.end()) continue;
      EXPECT_NE(name.find("/.ligne-"), std::string::npos) << name;
    }
    kill(child, signal);
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(names(), names_);
  }
}

TEST_F(Files, DevicesAndPipesAreToldQuickly) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  for (const std::string input : {"/dev/zero", "/dev/urandom", "pipe"}) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"draw", input, "-o", "x.svg"},
                                                      {"surface", "--grid", input, "-o", "x.svg"},
                                                      {"plot", input, "-o", "x.svg"},
                                                      {"draw", "cube.obj", "--pens", input, "-o", "x.svg"},
                                                      {"draw", "cube.obj", "--device-file", input, "-o", "x.hpgl"}}) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.status, 1) << outcome.err;
      EXPECT_EQ(outcome.err,
                "ligne: " + input +
                    (input == "pipe" ? ": is a pipe to which nobody writes\n" : ": is a device or a socket, not a file\n"));
    }
  }
}

}  // namespace
}  // namespace ligne::test
