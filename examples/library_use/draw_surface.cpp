/// Ligne Claire as a library: a surface z = f(x, y) with axes becomes a PDF file.  draw_surface FORMULA DRAWING.pdf

#include <exception>
#include <iostream>

#include <ligne/ligne.hpp>

int main(int argc, char** argv) {
  using namespace ligne;
  if (argc != 3) {
    std::cerr << "usage: draw_surface FORMULA DRAWING.pdf\n";
    return 2;
  }
  try {
    SurfaceRequest request;
    request.formulas = {argv[1]};
    request.x = request.y = CurveRange{.from = -8, .to = 8, .curves = 50};
    request.picture.axes.style = AxesStyle::back;
    request.picture.output = {.format = OutputFormat::pdf, .title = argv[1]};

    RunReport report;
    write_output(argv[2], draw_surface(request, report).bytes);
    for (const RunWarning& warning : report.warnings) std::cerr << argv[1] << ": " << warning.text << "\n";
  } catch (const std::exception& e) {
    std::cerr << "draw_surface: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
