#include "scene/readers/obj/obj_reader.hpp"

#include "reader_tools.hpp"
#include "scene/readers/ligne_scene_reader.hpp"

namespace ligne {
namespace {

using namespace reader_test;

/// Without shading.
Scene plain_obj(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_obj({bytes, name}, report, warnings);
}

TEST(ObjReader, NumbersAreRoundedCorrectly) {
  for (const std::string word :
       {"0.1234567890123456", "-149.29088", "123456.789012", "1e-3", "+2.5", "5e-324", "1e-400", ".5", "7."}) {
    const Result r = read_raw(plain_obj, "v " + word + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(r.scene.vertices[0].x, std::strtod(word.c_str(), nullptr)) << word;
  }
}

TEST(ObjReader, LongWordsAreShownByTheirBeginnings) {
  EXPECT_EQ(error_of(plain_obj, "v 0 0 " + std::string(100, 'x')),
            "M:1: '" + std::string(40, 'x') + "...' is not a coordinate of a vertex");
  EXPECT_EQ(error_of(read_ligne_scene, std::string(1000000, '[')), "M: JSON nested deeper than 32 levels");
}

}  // namespace
}  // namespace ligne
