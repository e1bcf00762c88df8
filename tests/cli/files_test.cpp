/// Files of a run: what was read is never written over, and what is written comes all together or not at all.

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <functional>
#include <random>

#include "program.hpp"

namespace ligne::test {
namespace {

constexpr std::string_view kPens = "[[pen]]\nnumber = 1\nrest = true\n";
constexpr std::string_view kDevice =
    "name = \"own\"\ntitle = \"Own\"\nlanguage = \"hpgl\"\nstep = 0.025\nlimits = [0, 0, 1000, 1000]\ntravel = "
    "\"U{x},{y};\"\n"
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
    Words all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_)) all.push_back(entry.path().string());
    std::sort(all.begin(), all.end());
    return all;
  }

  std::vector<std::string> names_;
};

TEST_F(Files, WhatWasReadIsNotWrittenOver) {
  const struct {
    Words arguments;
    const char* option;
    const char* output;
  } cases[] = {
      {"draw model.gltf --format svg -o 'model part.bin'", "--output", "model part.bin"},
      {"draw model.gltf --format svg -o folder/../picture.bin", "--output", "picture.bin"},
      {"draw cube.obj model.gltf -o x.svg --stats-json 'model part.bin'", "--stats-json", "model part.bin"},
      {"info model.gltf -o 'model part.bin'", "--output", "model part.bin"},
      {"draw cube.obj --pens pens.toml --format svg -o pens.toml", "--output", "pens.toml"},
      {"draw cube.obj --pens pens.toml --format svg -o link.toml", "--output", "pens.toml"},
      {"draw cube.obj --pens link.toml -o x.svg --stats-json pens.toml", "--stats-json", "pens.toml"},
      {"draw cube.obj --device-file device.toml -o x.hpgl --preview hard.toml", "--preview", "hard.toml"},
      {"plot lines.svg --device-file device.toml -o x.hpgl --stats-json device.toml", "--stats-json", "device.toml"},
      {"plot lines.svg -o x.svg --stats-json lines.svg", "--stats-json", "lines.svg"},
      {"plot lines.svg -o ./lines.svg", "--output", "lines.svg"},
      {"surface --grid grid.txt -o x.svg --preview ./grid.txt", "--preview", "grid.txt"},
      {"surface --grid grid.txt -o x.svg --pens pens.toml --stats-json pens.toml", "--stats-json", "pens.toml"},
      {"surface --grid grid.txt --as-mesh -o x.obj --stats-json grid.txt", "--stats-json", "grid.txt"},
  };
  for (const auto& c : cases) {
    const std::string before = contents(file(c.output));
    const Outcome outcome = run(c.arguments);
    const std::string line = std::string("ligne: ") + c.option + ": ";
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with(line)) << outcome.err;
    expect_parts(outcome.err, {" is also an input file"});
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
  const Outcome outcome = run("plot lines.svg -o x.svg --preview a --stats-json ./a");
  EXPECT_EQ(outcome.err, "ligne: --stats-json: ./a is the file of --preview too\n");
  EXPECT_EQ(names(), names_);
}

TEST_F(Files, AllOutputsOrNone) {
  write("old.svg", "old");
  names_ = names();
  for (const Words arguments :
       {"draw cube.obj -o old.svg --stats-json none/stats.json",
        "draw cube.obj -o none/new.svg --stats-json stats.json --preview preview.svg",
        "draw cube.obj -o new.svg --preview none/preview.svg", "draw cube.obj -o new.svg --stats-json /dev/full",
        "plot lines.svg -o old.svg --stats-json none/stats.json", "surface x*y -o old.svg --stats-json none/stats.json",
        "surface x*y --as-mesh -o new.obj --stats-json none/stats.json",
        "info cube.obj -o info.txt --stats-json none/stats.json"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_EQ(names(), names_) << outcome.err;
    EXPECT_EQ(contents(file("old.svg")), "old");
  }
  const Outcome outcome = run("draw cube.obj -o - --format svg --stats-json none/stats.json");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "") << "nothing goes to standard output either";
  run_well("draw cube.obj -o old.svg --stats-json s.json --preview p.svg");
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
      expect_parts(name, {"/.ligne-"});
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
    for (const Words& arguments : {Words{"draw", input, "-o", "x.svg"},
                                   {"surface", "--grid", input, "-o", "x.svg"},
                                   {"plot", input, "-o", "x.svg"},
                                   {"draw", "cube.obj", "--pens", input, "-o", "x.svg"},
                                   {"draw", "cube.obj", "--device-file", input, "-o", "x.hpgl"}}) {
      const Outcome outcome = run(arguments);
      EXPECT_EQ(outcome.status, 1) << outcome.err;
      EXPECT_EQ(outcome.err,
                "ligne: " + input +
                    (input == "pipe" ? ": is a pipe without a writer\n" : ": is a device or a socket, not a file\n"));
    }
  }
}

/// Whatever stands in a file or on the command line, an error or a warning is one line of bounded length.

constexpr std::size_t kLongestLine = 500;

/// Pieces of text that make lines long or odd.
std::vector<std::string> oddities() {
  return {std::string(500'000, 'x'),          std::string(500'000, '9'),   "two\nlines",
          "two\\nlines\\u0007\\u2028",        "\x1b[31mred\x07\x7f",       "\xff\xfe\xc3(",
          "\xe2\x80\xae\xc2\x85\xe2\x80\xa8", std::string(200'000, '\xc3')};
}

class Messages : public ProgramTest {
 protected:
  void is_one_line(const Words& arguments, const std::string& what) const {
    const Outcome outcome = run(arguments);
    EXPECT_TRUE(outcome.status == 1 || outcome.status == 2 || outcome.status == 0) << what;
    EXPECT_TRUE(outcome.status == 0 || outcome.error_lines() == 1) << what << ": " << outcome.err.substr(0, 2000);
    for (std::size_t begin = 0; begin < outcome.err.size();) {
      const std::size_t end = outcome.err.find('\n', begin);
      ASSERT_NE(end, std::string::npos) << what;
      const std::string line = outcome.err.substr(begin, end - begin);
      EXPECT_LT(line.size(), kLongestLine) << what << ": " << line.substr(0, 100);
      EXPECT_TRUE(line.starts_with("ligne: ")) << what << ": " << line.substr(0, 100);
      for (const char c : line) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 && c != 0x7f) << what;
      EXPECT_EQ(line.find("\xff"), std::string::npos) << what;
      EXPECT_EQ(line.find("\xe2\x80\xae"), std::string::npos) << what;
      begin = end + 1;
    }
  }
};

/// A place for an oddity, marked @, in a file that is right but for it.
const std::pair<const char*, const char*> kPlaces[] = {
    {"a.obj", "v 0 0 @\n"},
    {"b.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 @\n"},
    {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 @\n"},
    {"b.stl", "solid a\n@\n"},
    {"a.ply", "ply\n@\n"},
    {"b.ply", "ply\nformat @ 1.0\n"},
    {"c.ply", "ply\nformat ascii 1.0\nelement @ 3\nproperty @ x\n"},
    {"d.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float @\nend_header\n"},
    {"a.gltf", R"({"asset": {"version": "@"}})"},
    {"b.gltf", R"({"asset": {"version": "2.0"}, "accessors": [{"componentType": 5126, "count": 3, "type": "@"}]})"},
    {"c.gltf", R"({"asset": {"version": "2.0"}, "extensionsRequired": ["@"]})"},
    {"d.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 3, "uri": "@"}],
      "bufferViews": [{"buffer": 0, "byteLength": 3}], "accessors": [{"bufferView": 0, "componentType": 5121, "count": 1, "type": "VEC3"}],
      "meshes": [{"name": "@", "primitives": [{"attributes": {"POSITION": 0}}]}], "nodes": [{"mesh": 0}]})"},
    {"e.gltf", R"({"asset": @)"},
    {"a.json", R"({"format": "ligne-scene", "version": 1, "@": 1, "objects": []})"},
    {"b.json", R"({"format": "@", "version": 1, "objects": []})"},
    {"c.json", R"({"format": "ligne-scene", "version": 1, "up": "@", "objects": []})"},
    {"d.json", R"({"format": "ligne-scene", "version": 1, "objects": [@)"},
    {"e.json", R"({"format": "ligne-scene", "version": 1, "objects": [], "lights": [{"kind": "@"}]})"},
    {"a.asc", "Named object: \"@\"\nTri-mesh, Vertices: @\n"},
    {"b.asc", "Named object: \"@\"\nTri-mesh, Vertices: 3 Faces: 1\nVertex list:\nVertex @\n"},
    {"a.grid", "1 2\n3 @\n"},
    {"b.grid", "ncols 2\nnrows @\n"},
    {"c.grid", "P2 2 @\n"},
    {"a.svg", "<svg width='9mm' height='9mm'><@/></svg>"},
    {"b.svg", "<svg width='9mm' height='9mm'><path stroke='@' d='M0 0L1 1'/></svg>"},
    {"c.svg", "<svg width='@' height='9mm'/>"},
    {"d.svg", "<svg width='9mm' height='9mm'><g transform='@'/></svg>"},
    {"e.svg", "<svg width='9mm' height='9mm'><path stroke='#000' d='@'/></svg>"},
    {"a.drawing", R"({"format": "@"})"},
    {"a.pens", "[[pen]]\nnumber = 1\ncolor = \"@\"\n"},
    {"b.pens", "[[pen]]\nnumber = 1\n\"@\" = 1\n"},
    {"c.pens", "[[pen]]\nnumber = @\n"},
    {"d.pens", "[[pen]]\nnumber = 1\nclasses = [\"@\"]\n[[pen]]\nnumber = 2\nclasses = [\"@\"]\n"},
    {"a.device", "name = \"@\"\nlanguage = \"@\"\n"},
    {"b.device",
     "name = \"@\"\ntitle = \"@\"\nlanguage = \"hpgl\"\nstep = 0.025\nlimits = [0, 0, 1, 1]\ntravel = \"U{x},{y};\"\n"
     "draw = \"D{points};\"\ndot = \"D;\"\nspeed_down = 1\nspeed_up = 1\nlift_seconds = 1\npen_change_seconds = 1\n"},
    {"c.device",
     "name = \"a\"\ntitle = \"a\"\nlanguage = \"hpgl\"\nstep = 1\nlimits = [0, 0, 1, 1]\ntravel = \"U{x},{y}{@}\"\n"
     "draw = \"D{points};\"\ndot = \"D;\"\nspeed_down = 1\nspeed_up = 1\nlift_seconds = 1\npen_change_seconds = 1\n"},
};

TEST_F(Messages, FilesWithLongAndOddTexts) {
  for (const auto& [name, pattern] : kPlaces) {
    const std::string suffix = std::filesystem::path(name).extension().string();
    for (const std::string& odd : oddities()) {
      std::string text = pattern;
      for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + odd.size()))
        text.replace(at, 1, odd);
      write(name, text);
      const std::string what = std::string(name) + " with " + odd.substr(0, 20);
      if (suffix == ".grid") {
        is_one_line({"surface", "--grid", name, "-o", "x.svg"}, what);
      } else if (suffix == ".svg" || suffix == ".drawing") {
        is_one_line({"plot", name, "-o", "x.svg"}, what);
      } else if (suffix == ".pens") {
        is_one_line({"draw", "cube.obj", "--pens", name, "-o", "x.svg"}, what);
      } else if (suffix == ".device") {
        is_one_line({"draw", "cube.obj", "--device-file", name, "-o", "x.hpgl"}, what);
      } else {
        is_one_line({"draw", name, "-o", "x.svg"}, what);
      }
    }
  }
}

TEST_F(Messages, CommandLinesWithLongAndOddTexts) {
  for (std::string odd : oddities()) {
    odd.resize(std::min<std::size_t>(odd.size(), 100'000));  // the most that one argument may have is 128 KiB
    is_one_line({odd}, "command");
    is_one_line({"draw", odd, "-o", "x.svg"}, "model");
    is_one_line({"draw", "cube.obj", "-o", odd}, "output");
    is_one_line({"draw", "cube.obj", "-o", odd + ".svg/x.svg"}, "folder");
    is_one_line({"surface", odd, "-o", "x.svg"}, "formula");
    is_one_line({"surface", "x", "-x", odd, "-o", "x.svg"}, "range");
    is_one_line({"surface", "--grid", odd, "-o", "x.svg"}, "grid");
    for (const char* option :
         {"--view", "--direction", "--edges", "--method", "--page", "--margin", "--scale", "--unit", "--pen", "--device",
          "--device-file", "--pens", "--hatch", "--crease", "--threads", "--stats-json", "--preview", "--nonsense"}) {
      is_one_line({"draw", "cube.obj", option, odd, "-o", "x.svg"}, option);
    }
  }
}

/// Files with a few bytes changed. The seed is fixed.
TEST_F(Messages, MutatedFiles) {
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"name":"n"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
      R"("buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],)"
      R"("bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}]})";
  const std::string scene =
      R"({"format":"ligne-scene","version":1,"about":"a","up":"z","materials":[{"name":"m","color":[1,0,0],"opacity":0.5}],)"
      R"("objects":[{"name":"o","vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[{"outer":[0,1,2],"material":0}]}],"lights":[{"kind":"point","position":[0,0,1]}]})";
  std::mt19937 random(20);
  for (const std::string& text : {gltf, scene}) {
    for (int i = 0; i < 150; ++i) {
      std::string mutated = text;
      for (int k = 0; k <= i % 4; ++k) {
        const std::size_t at = random() % mutated.size();
        const char byte = static_cast<char>(random() % 256);
        switch (random() % 3) {
          case 0:
            mutated[at] = byte;
            break;
          case 1:
            mutated.insert(at, random() % 2 ? 1 : 3000, byte);
            break;
          default:
            mutated.erase(at, 1 + random() % 8);
        }
      }
      write("mutated.json", mutated);
      is_one_line("draw mutated.json -o x.svg", mutated.substr(0, 2000));
    }
  }
}

}  // namespace
}  // namespace ligne::test
