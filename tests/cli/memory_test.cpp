/// --max-memory, and values that ask for more than any machine has: a run is done, or ends soon with one line and no file.

#include <chrono>
#include <cmath>

#include "main/tier.hpp"
#include "program.hpp"

namespace ligne::test {
namespace {

/// The sanitizer's allocator ends the program in its own way. GCC tells of it by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kOwnAllocator = true;
#elif defined(__has_feature)
constexpr bool kOwnAllocator = __has_feature(address_sanitizer);
#else
constexpr bool kOwnAllocator = false;
#endif

/// A wavy sheet of 2 n^2 triangles.
std::string sheet(int n) {
  std::string text;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      text += "v " + std::to_string(i) + " " +
              std::to_string(std::lround(300 * std::sin(i * 0.2) * std::cos(j * 0.3)) / 100.0) + " " + std::to_string(j) +
              "\n";
    }
  }
  const auto corner = [n](int i, int j) { return " " + std::to_string(1 + i + j * (n + 1)); };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      text += "f" + corner(i, j) + corner(i + 1, j) + corner(i + 1, j + 1) + "\n";
      text += "f" + corner(i, j) + corner(i + 1, j + 1) + corner(i, j + 1) + "\n";
    }
  }
  return text;
}

/// A command that has memory for nothing at first and for everything in the end.
struct Hungry {
  const char* name;
  Words arguments;
  std::string output;
};

void PrintTo(const Hungry& hungry, std::ostream* out) { *out << hungry.name; }

/// As programs: memory that a process has kept from earlier runs would not count.
class LittleMemory : public ProgramTest, public testing::WithParamInterface<Hungry> {};

TEST_P(LittleMemory, IsEnoughOrIsOneLineWithoutAFile) {
  if (kOwnAllocator) GTEST_SKIP();
  write("sheet.obj", sheet(50));
  ASSERT_EQ(run_program(folder_, "draw sheet.obj --edges all -o sheet.svg").status, kDone);
  const std::vector<std::string> before = new_files();
  int done = 0, failed = 0;
  constexpr double kFirst = 40, kLast = 300'000, kStep = 1.3;  // kilobytes
  std::size_t limits = 0;
  for (double kilobytes = kFirst; kilobytes < kLast; kilobytes *= kStep) {
    const bool is_outermost = limits == 0 || kilobytes * kStep >= kLast;  // which fails, and which is enough
    if (!is_chosen(std::string("memory, ") + GetParam().name, limits++, 6) && !is_outermost) continue;
    Words arguments = GetParam().arguments;
    const std::string limit = std::to_string(std::lround(kilobytes)) + "K";
    arguments += {"-o", GetParam().output, "--max-memory", limit};
    const Outcome outcome = run_program(folder_, arguments);
    EXPECT_EQ(outcome.out, "");
    if (outcome.status == kDone) {
      ++done;
      EXPECT_EQ(outcome.err, "") << limit;
      EXPECT_TRUE(std::filesystem::remove(file(GetParam().output))) << limit;
    } else {
      ++failed;
      EXPECT_EQ(outcome.status, kFailed) << limit << ": " << outcome.err;
      EXPECT_EQ(outcome.error_lines(), 1u) << limit << ": " << outcome.err;
      EXPECT_EQ(outcome.err.rfind("ligne: not enough memory", 0), 0u) << limit << ": " << outcome.err;
      EXPECT_NE(outcome.err.find(" (--max-memory is "), std::string::npos) << limit << ": " << outcome.err;
    }
    EXPECT_EQ(new_files(), before) << limit;
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(failed, 0);
}

INSTANTIATE_TEST_SUITE_P(Commands, LittleMemory,
                         testing::Values(Hungry{"Draw", "draw sheet.obj --edges all --threads 1", "a.svg"},
                                         Hungry{"DrawByThreads", "draw sheet.obj --edges all --threads 7", "a.svg"},
                                         Hungry{"DrawPdf", "draw sheet.obj --edges all --hidden dashed", "a.pdf"},
                                         Hungry{"DrawPng", "draw sheet.obj --dpi 300 --threads 3", "a.png"},
                                         Hungry{"DrawJson", "draw sheet.obj --method warnock --threads 2", "a.json"},
                                         Hungry{"DrawHatched", "draw sheet.obj --method watkins --hatch shade", "a.svg"},
                                         Hungry{"DrawFilled", "draw sheet.obj --fill shade --threads 4", "a.svg"},
                                         Hungry{"DrawForPlotter", "draw sheet.obj --edges all", "a.hpgl"},
                                         Hungry{"Surface", "surface sin(x)*cos(y) --axes --threads 4", "a.svg"},
                                         Hungry{"SurfaceMesh", "surface sin(x)*cos(y) --hidden dashed --contours 9",
                                                "a.svg"},
                                         Hungry{"Info", "info sheet.obj --threads 4", "a.txt"},
                                         Hungry{"Plot", "plot sheet.svg --optimize full --threads 4", "a.svg"}),
                         [](const auto& info) { return std::string(info.param.name); });

class Memory : public ProgramTest {};

TEST_F(Memory, ErrorNamesTheStageWhatAsksAndWhatHelps) {
  const Outcome outcome = run_program(folder_, "draw cube.obj -o a.png --dpi 1200 --max-memory 64M");
  EXPECT_EQ(outcome.status, kFailed);
  EXPECT_EQ(outcome.err,
            "ligne: not enough memory to write the picture: 9921 x 14031 pixels, 531M at least; fewer lines take less, and "
            "for a PNG a lower --dpi (--max-memory is 64M)\n");
  EXPECT_EQ(new_files(), Words{});
}

/// Cairo ends in a wrong address when its scan conversion finds no memory.
TEST_F(Memory, PixelsWithoutRoomToPaintThemAreRefused) {
  if (kOwnAllocator) GTEST_SKIP();
  write("sheet.obj", sheet(50));
  ASSERT_EQ(run_program(folder_, "draw sheet.obj -o sheet.svg").status, kDone);
  constexpr int kPixels = 8500, kEnough = 16'000;  // kilobytes
  for (int kilobytes = kPixels; kilobytes < kEnough; kilobytes += runs_all() ? 250 : 750) {
    const std::string limit = std::to_string(kilobytes) + "K";
    const Outcome outcome = run_program(folder_, {"plot", "sheet.svg", "-o", "a.png", "--max-memory", limit});
    EXPECT_EQ(outcome.status, exists("a.png") ? kDone : kFailed) << limit;
    EXPECT_EQ(outcome.error_lines(), exists("a.png") ? 0u : 1u) << limit << ": " << outcome.err;
    std::filesystem::remove(file("a.png"));
  }
}

TEST_F(Memory, FailureKeepsTheEarlierDrawing) {
  if (kOwnAllocator) GTEST_SKIP();
  write("sheet.obj", sheet(50));
  write("a.svg", "earlier");
  EXPECT_EQ(run_program(folder_, "draw sheet.obj -o a.svg --max-memory 600K").status, kFailed);
  EXPECT_EQ(contents(file("a.svg")), "earlier");
}

TEST_F(Memory, NoLimitAndTheUsualOneDrawTheSame) {
  run_well("draw cube.obj -o a.svg");
  for (const char* limit : {"none", "0", "2G", "1e30"}) {
    EXPECT_EQ(run({"draw", "cube.obj", "-o", "b.svg", "--max-memory", limit}).status, kDone) << limit;
    EXPECT_EQ(contents(file("a.svg")), contents(file("b.svg"))) << limit;
  }
}

TEST_F(Memory, LimitStandsInTheHelp) {
  for (const char* command : {"draw", "surface", "plot", "info"}) {
    EXPECT_NE(run({"help", command, "all"}).out.find("--max-memory SIZE"), std::string::npos) << command;
  }
}

/// A value that no machine can serve, and the option that the line begins with.
struct Absurd {
  const char* name;
  Words arguments;
  std::string start;
};

void PrintTo(const Absurd& absurd, std::ostream* out) { *out << absurd.name; }

class AbsurdValues : public ProgramTest, public testing::WithParamInterface<Absurd> {};

TEST_P(AbsurdValues, AreRefusedSoonWithTheOption) {
  const auto start = std::chrono::steady_clock::now();
  const Outcome outcome = run(GetParam().arguments);
  // A fraction of a second; a busy machine takes longer.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  EXPECT_EQ(outcome.status, kUsage) << outcome.err;
  EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("ligne: " + GetParam().start, 0), 0u) << outcome.err;
  EXPECT_EQ(new_files(), Words{});
}

Absurd absurd_draw(const char* name, const Words& options, const std::string& start) {
  Words arguments = "draw cube.obj -o a.svg" + options;
  return {name, arguments, start};
}

Absurd surface(const char* name, const Words& options, const std::string& start) {
  Words arguments = "surface x*y -o a.svg" + options;
  return {name, arguments, start};
}

INSTANTIATE_TEST_SUITE_P(
    Options, AbsurdValues,
    testing::Values(
        surface("Samples", "--samples 1000000000", "--samples: "),
        surface("SamplesSquared", "--samples 1000000", "--samples: gives 1000000 x 1000000 samples, more than 1000000000\n"),
        surface("SamplesOfMesh", "--samples 1000000 --hidden dashed", "--samples: gives 1000000 x 1000000 "),
        surface("Curves", "-x 0:1:1000000000", "-x: "), surface("Contours", "--contours 1000000000", "--contours: "),
        surface("ContourStep", "--contour-step 1e-9", "--contour-step: "),
        surface("ContourStepTiny", "--contour-step 1e-300", "--contour-step: "),
        surface("Columns", "--horizon pixels --resolution 1000000000", "--resolution: "),
        surface("Every", "--every 1000000000", "--every: "),
        surface("TextHeight", "--axes --text-height 1e9", "--text-height: "),
        surface("HatchSpacing", "--hatch plain --hatch-spacing 1e-9", "--hatch-spacing: the strokes are too dense"),
        surface("HatchPage", "--hatch plain --page 99999x99999", "--hatch-spacing: the strokes are too dense"),
        surface("HatchOfManyFaces", "--hatch plain --hatch-spacing 0.0005", "--hatch-spacing: the strokes are too dense"),
        absurd_draw("Page", "--page 1e9x1e9", "--page: "), absurd_draw("Dpi", "--format png --dpi 1e6", "--dpi: "),
        absurd_draw("Pixels", "--format png --dpi 9600", "--dpi: a PNG of 79370 x 112252 pixels is too large\n"),
        absurd_draw("PixelsOfPage", "--format png --page 99999x99999", "--dpi: a PNG of "),
        absurd_draw("Resolution", "--method warnock --set resolution=1000000000", "--set resolution: "),
        absurd_draw("Lines", "--method watkins --lines 1000000000", "--lines: "),
        absurd_draw("HatchSpacing", "--hatch plain --hatch-spacing 1e-9", "--hatch-spacing: the strokes are too dense"),
        absurd_draw("HatchUnderPen", "--hatch plain --hatch-spacing 0.001",
                    "--hatch-spacing: the strokes are too dense: more than 128 under the pen\n"),
        absurd_draw("HatchBySpans", "--method watkins --hatch plain --hatch-spacing 0.0001",
                    "--hatch-spacing: the strokes are too dense"),
        absurd_draw("Threads", "--threads 1000000000", "--threads: "),
        absurd_draw("Memory", "--max-memory much", "--max-memory: \"much\" is not a size such as 500M or 2G, or none\n"),
        absurd_draw("MemoryNegative", "--max-memory -1G", "--max-memory: ")),
    [](const auto& info) { return std::string(info.param.arguments[0]) + info.param.name; });

}  // namespace
}  // namespace ligne::test
