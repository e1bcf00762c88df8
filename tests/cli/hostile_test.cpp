/// Forged files and little memory.

#include "files/input_error.hpp"
#include "main/tier.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/raster/zbuffer_picture.hpp"
#include "program.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

// Files that `ligne draw` reads back and that were damaged, or changed by somebody who made their checksum fit: nothing in
// them is to be believed. What whole ones draw: scripts/models.txt and scripts/draw.txt.

/// Changes every byte in turn, and cuts the file everywhere. `sign(bytes)` puts the checksum in, `read(bytes, name)` reads:
/// it returns, or throws an InputError of one line.
template <class Sign, class Read>
void expect_forgeries_are_refused(const std::string& bytes, Sign sign, Read read) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const unsigned char flip : {0x01, 0x80, 0xff}) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(static_cast<unsigned char>(changed[i]) ^ flip);
      sign(changed);
      try {
        read(std::as_bytes(std::span(changed)), "forged");
      } catch (const InputError& error) {
        ++refused;
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
      }
    }
  }
  EXPECT_GT(refused, bytes.size()) << "a third of the changes at the least";
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    std::string cut = bytes.substr(0, size);
    sign(cut);
    EXPECT_THROW(read(std::as_bytes(std::span(cut)), "cut"), InputError);
  }
}

class ForgedFiles : public DrawTest {
 protected:
  /// The message when files are drawn one of which has the bytes.
  std::string error_of(const std::string& bytes, const Words& files) const {
    write("changed", bytes);
    const Outcome outcome = run("draw" + files + "-o a.svg");
    EXPECT_NE(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1u) << outcome.err;
    EXPECT_FALSE(exists("a.svg"));
    return outcome.err;
  }
  void damage_is_told(const std::string& bytes, const Words& files, const std::string& what) const {
    const std::string damaged = "ligne: changed: byte 12: the file was changed or cut off since it was written\n";
    EXPECT_EQ(error_of(bytes.substr(0, bytes.size() / 2), files), damaged);
    EXPECT_EQ(error_of(bytes + "x", files), damaged);
    std::string other = bytes;
    other[other.size() / 2] ^= 4;
    EXPECT_EQ(error_of(other, files), damaged);
    other = bytes;
    other[12] = 7;
    expect_parts(error_of(other, files), {what + " of version 7; this program reads version 1"});
  }
};

TEST_F(ForgedFiles, CompiledModels) {
  for (const char* method : {"bsp", "convex-tree"}) {
    run_well({"compile", LIGNE_SOURCE_DIR "/tests/corpus/cyclic_4.json", "-o", "model.tree", "-q", "--method", method});
    const std::string bytes = contents(file("model.tree"));
    damage_is_told(bytes, "changed", "a compiled model");
    expect_forgeries_are_refused(bytes, write_checksum_of_model, read_compiled_model);
  }
}

TEST_F(ForgedFiles, DepthBuffers) {
  run_well("draw cube.obj --zbuffer-save cube.zbuf --lines 5 -q -o b.svg");
  const std::string bytes = contents(file("cube.zbuf"));
  damage_is_told(bytes, "square.obj --zbuffer-add changed", "a depth buffer");
  expect_forgeries_are_refused(bytes, write_checksum_of_zbuffer, ZBuffer::read);
}

// --max-memory: a run is done, or ends soon with one line and no file.

/// The sanitizer's allocator ends the program in its own way. GCC tells of it by a macro, clang by a feature.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool kOwnAllocator = true;
#elif defined(__has_feature)
constexpr bool kOwnAllocator = __has_feature(address_sanitizer);
#else
constexpr bool kOwnAllocator = false;
#endif

/// A wavy sheet of 5000 triangles.
std::string sheet() { return obj_of_mesh("grid 50 x 50 triangles: u; 3*sin(u*0.2)*cos(v*0.3); v"); }

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
  write("sheet.obj", sheet());
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
  write("sheet.obj", sheet());
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
  write("sheet.obj", sheet());
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

}  // namespace
}  // namespace ligne::test
