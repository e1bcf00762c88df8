/// Ligne Claire as a library: a model, hatched and with cast shadows, becomes an SVG file.  draw_mesh MODEL DRAWING.svg

#include <exception>
#include <iostream>

#include <ligne/ligne.hpp>

int main(int argc, char** argv) {
  using namespace ligne;
  if (argc != 3) {
    std::cerr << "usage: draw_mesh MODEL DRAWING.svg\n";
    return 2;
  }
  try {
    const LoadedModels models = load_models({.files = {argv[1]}});

    PictureRequest request;  // isometric, A4, outlines and creases
    request.fill.lights = {{1, 2, -3}};
    request.lines.classes.add(LineClass::shadow);
    request.hatch = {.kind = HatchKind::shade, .direction = {.by_face = true}};

    RunReport report;
    write_output(argv[2], draw_scene(models.scene, request, report).bytes);
    for (const RunWarning& warning : report.warnings) std::cerr << argv[1] << ": " << warning.text << "\n";
  } catch (const std::exception& e) {
    std::cerr << "draw_mesh: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
