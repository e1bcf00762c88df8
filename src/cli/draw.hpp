#pragma once
/// ligne draw: a hidden-line drawing of meshes and polygon scenes.

#include <string>

#include "cli/face_options.hpp"
#include "cli/fills.hpp"
#include "cli/hatch_options.hpp"
#include "cli/method_options.hpp"
#include "cli/models.hpp"
#include "cli/output_options.hpp"
#include "cli/page_options.hpp"
#include "cli/plotter_options.hpp"
#include "cli/run_options.hpp"
#include "cli/view_options.hpp"

namespace ligne {

struct DrawOptions {
  ModelOptions model;
  ViewOptions view;
  MethodOptions method;
  PageOptions page;
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
  double dpi = 150;   ///< PNG
  std::string title;  ///< of the document, may be empty
  FaceOptions faces;
  FillOptions fill{};
  HatchRequest hatch{};
};

/// Adds the command; it runs when the command line names it. `options` must outlive the parse.
void setup_draw(CLI::App& app, DrawOptions& options);

/// Throws UsageError, InputError, std::runtime_error.
void run_draw(const DrawOptions& options);

}  // namespace ligne
