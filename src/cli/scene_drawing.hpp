#pragma once
/// From a scene to the file that shows it: what all commands that draw scenes have in common.

#include <string>

#include "cli/face_options.hpp"
#include "cli/fills.hpp"
#include "cli/hatch_options.hpp"
#include "cli/method_options.hpp"
#include "cli/output_options.hpp"
#include "cli/page_options.hpp"
#include "cli/plotter_options.hpp"
#include "cli/run_files.hpp"
#include "cli/run_options.hpp"
#include "cli/stages.hpp"
#include "cli/surface_axes.hpp"
#include "cli/view_options.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Axes and a title round the picture of what is plotted.
struct PlotFrame {
  const AxesOptions& axes;
  std::optional<PlotBox> box;
};

/// What is drawn and how.
struct SceneDrawing {
  const Method& method;
  MethodSettings settings{};  ///< of the method's own parameters
  LineClasses classes;
  double crease_degrees = 30;
  HiddenLines hidden = HiddenLines::none;
  bool cull = false;
  const ViewOptions& view;
  const PageOptions& page;
  const OutputOptions& output;
  const RunOptions& run;
  double dpi = 150;   ///< PNG
  std::string title;  ///< of the document, may be empty
  std::string place_of_warnings;
  const PlotFrame* frame = nullptr;  ///< not for JSON; without it the title is only that of the document
  FaceOptions faces{};
  PlotterSetup plotter{};
  FillOptions fill{};
  HatchRequest hatch{};
};

/// Studies, draws and writes to `files`, which it completes; then reports when the options ask for it. Throws UsageError,
/// std::runtime_error.
void draw_scene(const Scene& scene, const SceneDrawing& request, RunFiles& files, RunReport& run);

}  // namespace ligne
