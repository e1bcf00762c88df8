/// Compares the default drawings of tessellated STEP parts with the edges and outlines of their surfaces.
///
///     compare_step FOLDER [PICTURES]
///
/// prints a line for each STEP file of the folder and each accuracy of the mesh, and the sums. PICTURES is a folder for an
/// SVG file of each view that misses or adds a piece longer than 2 mm: the drawing in grey, what misses in red, what is
/// extra in blue. Ends with 1 if a sum is below what is asked for, and with 77, which ctest takes for skipped, if FOLDER is
/// empty.

#include <unistd.h>

#include "clear/true_comparison.hpp"
#include "clear/true_parts.hpp"
#include "drawing/measures.hpp"
#include "picture/models/models.hpp"
#include "step/step_part.hpp"

namespace ligne::test {
namespace {

struct NamedAccuracy {
  std::string_view name;
  MeshAccuracy mesh;
};
constexpr std::array<NamedAccuracy, 2> kAccuracies{NamedAccuracy{"coarse", {0.1, 0.5}}, {"fine", {0.02, 0.2}}};
/// The mesh that tells what is hidden.
constexpr MeshAccuracy kTrueMesh{0.01, 0.1};
constexpr std::array<Point3, 4> kSights{Point3{-1, 1, -0.8}, {0.6, 1, -0.5}, {-1, 0.4, -0.7}, {0.3, 1, -1.2}};
/// Longer pieces that are missing or extra are told one by one.
constexpr double kPieceMm = 2;
/// Least parts of sharp edges, tangent edges and outlines that are drawn, and of the drawing that is true.
constexpr std::array<double, 3> kLeastDrawn{0.998, 0.97, 0.99};
constexpr double kLeastTrue = 0.995;
constexpr std::array<std::string_view, 3> kKinds{"sharp", "tangent", "outline"};

double length_of(const OddPiece& piece) {
  double length = 0;
  for (std::size_t i = 1; i < piece.path.size(); ++i) length += glm::distance(piece.path[i - 1], piece.path[i]);
  return length;
}

struct LongPieces {
  int count = 0;
  double length_mm = 0;

  void add(const OddPiece& piece) {
    const double length = length_of(piece);
    if (length < kPieceMm) return;
    ++count;
    length_mm += length;
  }
};

struct Sums {
  std::array<DrawnShare, 3> kinds;
  double ink_mm = 0, true_mm = 0;
  std::array<LongPieces, 3> missing;
  LongPieces extra;

  void add(const Comparison& found) {
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      kinds[k].seen_mm += found.kinds[k].seen_mm;
      kinds[k].drawn_mm += found.kinds[k].drawn_mm;
    }
    for (const OddPiece& piece : found.missing) missing[static_cast<std::size_t>(piece.sample.kind)].add(piece);
    for (const OddPiece& piece : found.extra) extra.add(piece);
    ink_mm += found.ink_mm;
    true_mm += found.true_mm;
  }

  void print(std::string_view name, std::string_view accuracy) const {
    std::printf("%-44.44s %-6s", std::string(name).c_str(), std::string(accuracy).c_str());
    for (std::size_t k = 0; k < kinds.size(); ++k)
      std::printf("  %s %.4f of %.0f mm, long %d: %.0f", std::string(kKinds[k]).c_str(), kinds[k].part(), kinds[k].seen_mm,
                  missing[k].count, missing[k].length_mm);
    std::printf("  true %.4f of %.0f mm, long %d: %.0f\n", true_mm / std::max(ink_mm, 1e-9), ink_mm, extra.count,
                extra.length_mm);
    std::fflush(stdout);
  }

  bool suffice() const {
    bool enough = true_mm >= kLeastTrue * ink_mm;
    for (std::size_t k = 0; k < kinds.size(); ++k) enough = enough && kinds[k].part() >= kLeastDrawn[k];
    return enough;
  }
};

/// The mesh as a scene, as it is read from STL. The file stays in a folder that is given.
Scene scene_of(const std::vector<std::array<Point3, 3>>& triangles, const std::string& name,
               const std::optional<std::filesystem::path>& folder) {
  const std::filesystem::path file = folder.value_or(std::filesystem::temp_directory_path()) / (name + ".stl");
  write_stl(triangles, file);
  Scene scene = load_models({.files = {file.string()}}).scene;
  if (!folder) std::filesystem::remove(file);
  return scene;
}

/// Writes a picture of what is odd if a piece of it is long, and a line for each such piece to `list`.
void write_odd(const Comparison& found, const std::filesystem::path& file, std::ostream& list) {
  const auto is_long = [](const OddPiece& piece) { return length_of(piece) >= kPieceMm; };
  if (std::ranges::none_of(found.missing, is_long) && std::ranges::none_of(found.extra, is_long)) return;
  std::ofstream svg(file);
  svg << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 297 297' fill='none' stroke-linecap='round'>\n";
  const auto path = [&](const auto& points) {
    svg << 'M';
    for (const Point2 p : points) svg << p.x << ' ' << p.y << ' ';
  };
  svg << "<path stroke='#999' stroke-width='0.2' d='";
  for (const Layer& layer : found.drawing.layers)
    for (std::size_t i = 0; i < layer.lines.size(); ++i) path(layer.lines[i]);
  const auto mark = [&](const std::vector<OddPiece>& pieces, std::string_view colour) {
    svg << "'/>\n<path stroke='" << colour << "' stroke-width='0.5' d='";
    for (const OddPiece& piece : pieces)
      if (is_long(piece)) path(piece.path);
  };
  mark(found.missing, "#d00");
  mark(found.extra, "#00f");
  svg << "'/>\n</svg>\n";
  for (const OddPiece& piece : found.missing) {
    if (!is_long(piece)) continue;
    const TruePoint& at = piece.sample;
    const double angle = std::acos(std::clamp(glm::dot(at.normals[0], at.normals[1]), -1.0, 1.0)) * 180 / std::numbers::pi;
    list << file.stem().string() << ": no " << kKinds[static_cast<std::size_t>(at.kind)] << " for " << length_of(piece)
         << " mm from page " << piece.path[0].x << ',' << piece.path[0].y << " model " << at.at.x << ',' << at.at.y << ','
         << at.at.z << ", " << angle << " degrees\n";
  }
  for (const OddPiece& piece : found.extra)
    if (is_long(piece))
      list << file.stem().string() << ": extra for " << length_of(piece) << " mm from page " << piece.path[0].x << ','
           << piece.path[0].y << '\n';
}

bool is_step(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  return extension == ".step" || extension == ".stp";
}

int compare_folder(const std::filesystem::path& folder, const std::optional<std::filesystem::path>& pictures) {
  std::vector<std::filesystem::path> files;
  if (!folder.empty())
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (is_step(entry.path())) files.push_back(entry.path());
  std::ranges::sort(files);
  std::array<Sums, kAccuracies.size()> all;
  std::ofstream list;
  if (pictures) list.open(*pictures / "pieces.txt");
  for (const std::filesystem::path& file : files) {
    // Each keeps one mesh.
    const StepPart truth(file), part(file);
    TrueScene scene;
    scene.fine = scene_of(truth.mesh(kTrueMesh), "truth" + std::to_string(::getpid()), std::nullopt);
    scene.lines = [&](const Viewer& viewer, double step) { return truth.lines(viewer, step, kTrueMesh); };
    for (std::size_t a = 0; a < kAccuracies.size(); ++a) {
      scene.drawn =
          scene_of(part.mesh(kAccuracies[a].mesh), file.stem().string() + "_" + std::string(kAccuracies[a].name), pictures);
      scene.sag = [&](const TruePoint&) { return kAccuracies[a].mesh.chord_mm; };
      Sums sums;
      for (std::size_t v = 0; v < kSights.size(); ++v) {
        ViewRequest view;
        view.direction = kSights[v];
        const Comparison found = compare_with_truth(scene, view);
        sums.add(found);
        all[a].add(found);
        const std::string name = file.stem().string() + "_" + std::string(kAccuracies[a].name) + std::to_string(v);
        if (pictures) write_odd(found, *pictures / (name + ".svg"), list);
      }
      sums.print(file.stem().string(), kAccuracies[a].name);
    }
  }
  bool enough = true;
  for (std::size_t a = 0; a < kAccuracies.size() && !files.empty(); ++a) {
    all[a].print("all", kAccuracies[a].name);
    enough = enough && all[a].suffice();
  }
  constexpr int kSkipped = 77;
  if (files.empty()) std::cout << "no STEP files in \"" << folder.string() << "\"\n";
  return files.empty() ? kSkipped : enough ? 0 : 1;
}

}  // namespace
}  // namespace ligne::test

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::cerr << "usage: compare_step FOLDER [PICTURES]\n";
    return 2;
  }
  try {
    return ligne::test::compare_folder(argv[1], argc > 2 ? std::optional<std::filesystem::path>(argv[2]) : std::nullopt);
  } catch (const std::exception& error) {
    std::cerr << "compare_step: " << error.what() << '\n';
    return 1;
  }
}
