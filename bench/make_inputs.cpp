/// Writes the inputs of the benchmarks: ligne_bench_inputs FOLDER [stanford-bunny.obj]. See README.md.

#include <cstdio>
#include <exception>

#include "inputs.hpp"

namespace {

using namespace ligne::bench;

/// Mean sides of the boxes: 10,000 give 1.41 million pairs of triangles that cross; 1,000 have as many neighbours each.
constexpr double kSideOf10000 = 0.06294, kSideOf1000 = 0.1356;
constexpr std::uint64_t kBoxSeed = 20240607;
constexpr int kBlock = 8;

void write_mesh(const std::filesystem::path& file, const TriangleMesh& mesh) {
  write_glb(file, mesh);
  std::printf("%s: %zu triangles\n", file.filename().c_str(), mesh.triangles.size());
}

void write_boxes(const std::filesystem::path& file, std::size_t n, double side) {
  const std::vector<Placement> boxes = random_boxes(n, side, kBoxSeed);
  write_glb(file, unit_cube(), boxes);
  std::printf("%s: %zu triangles, %zu pairs of triangles cross\n", file.filename().c_str(), 12 * n,
              count_crossing_triangles(boxes));
}

void write_cubes(const std::filesystem::path& folder) {
  std::vector<Placement> nodes;
  for (const CubeCorners& cube : cube_block(kBlock)) {
    Placement p;
    for (std::size_t k = 0; k < 3; ++k) p.shift[k] = cube[0][k] + 0.5;
    nodes.push_back(p);
  }
  write_glb(folder / "cubes_8x8x8.glb", unit_cube(), nodes);
  write_cube_scene(folder / "cubes_8x8x8.json", cube_block(kBlock));
  Placement turn = rotation(0.9, 0.3, -0.5, 0.7);
  turn.shift = {0.1, 0.2, 0.3};
  write_cube_scene(folder / "cubes_8x8x8_turned_shared.json", turned_block_shared(kBlock, turn));
  write_cube_scene(folder / "cubes_8x8x8_turned_rounded.json", turned_block_rounded(kBlock, turn));
}

void write_inputs(const std::filesystem::path& folder, const char* bunny) {
  std::filesystem::create_directories(folder);
  write_mesh(folder / "knot.glb", torus_knot(11, 4));
  write_mesh(folder / "knot_1.glb", torus_knot(12, 5));
  write_mesh(folder / "knot_2.glb", torus_knot(13, 6));
  write_boxes(folder / "boxes_1000.glb", 1000, kSideOf1000);
  write_boxes(folder / "boxes_10000.glb", 10000, kSideOf10000);
  write_cubes(folder);
  if (bunny == nullptr) return;
  const TriangleMesh mesh = read_obj(bunny), mesh_1 = subdivide(mesh);
  write_mesh(folder / "bunny.glb", mesh);
  write_mesh(folder / "bunny_1.glb", mesh_1);
  write_mesh(folder / "bunny_2.glb", subdivide(mesh_1));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "usage: ligne_bench_inputs FOLDER [stanford-bunny.obj]\n");
    return 2;
  }
  try {
    write_inputs(argv[1], argc == 3 ? argv[2] : nullptr);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "ligne_bench_inputs: %s\n", e.what());
    return 1;
  }
}
