/// Ligne Claire as a library: the visible strokes of a model as numbers, with the edges and faces that they are of.
///   list_strokes MODEL
/// A line is: class, two points in page mm, the source edge's ends in the model and its two faces, the interval on it.

#include <exception>
#include <iostream>
#include <optional>

#include <ligne/ligne.hpp>

namespace {

void list_strokes(const char* model) {
  using namespace ligne;
  const LoadedModels models = load_models({.files = {model}});
  const PictureRequest request;
  RunReport report;
  PreparedScene prepared = prepare(models.scene, request, std::nullopt, report);
  SceneVisibility found = compute_visibility(prepared, std::nullopt, true, report);
  finish_lines(found, prepared, report);

  for (const Stroke& stroke : found.result.strokes->strokes) {
    const SourceEdge edge = found.source(models.scene, stroke.source);
    const Lattice& lattice = found.result.strokes->lattice;
    std::cout << kLineClassNames[static_cast<std::size_t>(stroke.line_class)];
    for (const LatticePoint end : {stroke.from, stroke.to}) {
      const Point2 p = lattice.to_mm(end);
      std::cout << ' ' << p.x << ' ' << p.y;
    }
    for (const Point3& p : edge.ends) std::cout << ' ' << p.x << ' ' << p.y << ' ' << p.z;
    for (const std::uint32_t face : edge.faces) std::cout << ' ' << (face == kNone ? -1 : static_cast<long>(face));
    std::cout << ' ' << stroke.t_from << ' ' << stroke.t_to << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: list_strokes MODEL\n";
    return 2;
  }
  try {
    list_strokes(argv[1]);
  } catch (const std::exception& e) {
    std::cerr << "list_strokes: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
