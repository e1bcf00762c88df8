/// A program with a "view/view.hpp" and a "geometry/point.hpp" of its own beside those of the library.  clash MODEL
/// DRAWING.svg

#include "geometry/point.hpp"
#include "view/view.hpp"

#include <ligne/ligne.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const outside::View view{"iso"};
  const outside::Point point{1, 2};
  const ligne::LoadedModels models = ligne::load_models({.files = {argv[1]}});
  ligne::PictureRequest request;
  ligne::RunReport report;
  ligne::write_output(argv[2], ligne::draw_scene(models.scene, request, report).bytes);
  return view.name.empty() || point.x > point.y ? 1 : 0;
}
