// Every file of the fuzzers' corpus, among them those that once brought a reader down, read again.

#include <chrono>

#include "reader_harness.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

class FuzzReplay : public testing::TestWithParam<const char*> {};

TEST_P(FuzzReplay, EveryFileIsReadOrRefused) {
  const std::filesystem::path folder = std::filesystem::path(LIGNE_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam();
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  ASSERT_GE(files.size(), 5u) << "the corpus is not there";
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NO_THROW(read_as_fuzzer(GetParam(), std::as_bytes(std::span(text))));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, FuzzReplay,
                         testing::Values("gltf", "glb", "obj", "mtl", "stl", "ply", "off", "3mf", "asc", "3ds", "meshopt",
                                         "scene", "tree", "zbuf", "grid", "points", "hgt", "tiff", "formula", "svg", "areas",
                                         "drawing"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace ligne
