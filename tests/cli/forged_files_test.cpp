/// Files that `ligne draw` reads back and that were damaged, or changed by somebody who made their checksum fit: nothing in
/// them is to be believed. What whole ones draw: scripts/models.txt and scripts/draw.txt.

#include "draw_program.hpp"
#include "files/input_error.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/raster/zbuffer_picture.hpp"

namespace ligne::test {
namespace {

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
    expect_forgeries_are_refused(bytes, sign_compiled_model, read_compiled_model);
  }
}

TEST_F(ForgedFiles, DepthBuffers) {
  run_well("draw cube.obj --zbuffer-save cube.zbuf --lines 5 -q -o b.svg");
  const std::string bytes = contents(file("cube.zbuf"));
  damage_is_told(bytes, "square.obj --zbuffer-add changed", "a depth buffer");
  expect_forgeries_are_refused(bytes, sign_zbuffer, ZBuffer::read);
}

}  // namespace
}  // namespace ligne::test
