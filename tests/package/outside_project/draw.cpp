/// A program outside the project: a model becomes an SVG file, and its visible strokes are counted.  draw MODEL DRAWING.svg

#include <exception>
#include <iostream>

#include <ligne/ligne.hpp>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const ligne::LoadedModels models = ligne::load_models({.files = {argv[1]}});
    ligne::PictureRequest request;
    ligne::RunReport report;
    const ligne::DrawnScene drawn = ligne::draw_lines(models.scene, request, report);
    ligne::write_output(argv[2], drawn.write(report).bytes);
    std::cout << drawn.visibility().result.strokes->strokes.size() << "\n";
  } catch (const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 1;
  }
  return 0;
}
