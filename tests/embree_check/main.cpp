/// ligne_check MODEL DRAWING.json [--edges all|feature] [--crease DEG] [--fov DEG] [--tolerance MM] [--worst N]
/// Exit status 0 when the drawing is right, 1 when it is not or cannot be read, 2 for a wrong command line.

#include <exception>

#include "check.hpp"
#include "scene/readers/reader.hpp"

namespace {

using namespace ligne;

/// Largest part of the drawn length that may be wrong.
constexpr double kLimit = 0.0005;

int usage() {
  std::fputs(
      "usage: ligne_check MODEL DRAWING.json [--edges all|feature] [--crease DEG] [--fov DEG] [--tolerance MM] [--worst "
      "N]\n",
      stderr);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc % 2 == 0) return usage();
  check::CheckOptions options;
  std::size_t worst = 10;
  for (int i = 3; i + 1 < argc; i += 2) {
    const std::string_view name = argv[i], value = argv[i + 1];
    if (name == "--edges" && (value == "all" || value == "feature")) {
      options.kinds = value == "all" ? check::kAllKinds : check::kFeatureKinds;
    } else if (name == "--crease") {
      options.crease_degrees = std::atof(argv[i + 1]);
    } else if (name == "--fov") {
      options.fov_degrees = std::atof(argv[i + 1]);
    } else if (name == "--tolerance") {
      options.tolerance_mm = std::atof(argv[i + 1]);
    } else if (name == "--worst") {
      worst = static_cast<std::size_t>(std::atol(argv[i + 1]));
    } else {
      return usage();
    }
  }
  try {
    Warnings warnings;
    const Scene scene = read_scene(argv[1], {}, warnings);
    const check::DrawingFile drawing = check::read_drawing(argv[2]);
    const check::Report report = check::check_drawing(scene, drawing, options);
    std::fputs(check::to_text(report, worst).c_str(), stdout);
    return report.share(report.drawn_wrong()) <= kLimit && report.share(report.not_drawn()) <= kLimit ? 0 : 1;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "ligne_check: %s\n", e.what());
    return 1;
  }
}
