/// Ligne Claire as a library: a model becomes an SVG file, step by step.  library_use MODEL DRAWING.svg

#include <exception>
#include <iostream>

#include "drawing/drawing.hpp"
#include "plotting/output_file.hpp"
#include "plotting/writers.hpp"
#include "scene/readers/reader.hpp"
#include "view/projected_scene.hpp"
#include "visibility/registry.hpp"
#include "visibility/tolerances.hpp"

void draw(const char* model, const char* file) {
  using namespace ligne;
  Warnings warnings;
  const Scene scene = read_scene(model, {}, warnings);
  const Topology topology = build_topology(scene);

  const PlotOptions plot;  // A4, pen of 0.35 mm
  CameraRequest request;   // isometric
  request.up_axis = scene.up_axis;
  const View view = make_view(scene, make_camera(request, scene), {plot.page.drawable()}, plot.page.sheet());

  EdgeSelection selection;
  for (const LineClass c : {LineClass::outline, LineClass::border, LineClass::intersection, LineClass::crease}) {
    selection.classes.add(c);
  }
  const ProjectedScene projected = project(scene, topology, view, selection);

  VisibilityResult result = find_method("auto")->study(projected, {});
  remove_coincident_strokes(*result.strokes, coincidence_mm(projected));
  write_output(file, write_svg(make_drawing(*result.strokes), plot));
}

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: library_use MODEL DRAWING.svg\n";
    return 2;
  }
  try {
    draw(argv[1], argv[2]);
  } catch (const std::exception& e) {
    std::cerr << "library_use: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
