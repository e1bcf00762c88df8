#pragma once
/// ligne draw: a hidden-line drawing of meshes and polygon scenes.

#include "cli/options/method_options.hpp"
#include "cli/options/model_options.hpp"
#include "cli/options/output_options.hpp"
#include "cli/options/plotter_options.hpp"
#include "cli/options/run_options.hpp"
#include "picture/pages/frames.hpp"
#include "picture/stream/streamed_model.hpp"
#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

struct DrawOptions {
  ModelRequest model;
  SurfaceRequest surfaces;  ///< drawn among the models
  PictureRequest picture;
  MethodChoice method;
  FrameRequest frames;
  std::optional<Point3> last_eye;         ///< end of a straight path of the eye that begins at the view's eye
  std::string path;                       ///< file of eye positions; empty: none
  std::string zbuffer_add, zbuffer_save;  ///< files of depth buffers; empty: none
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
  Streaming streaming = Streaming::automatic;
};

/// Adds the command; it runs when the command line names it. `options` must outlive the parse.
void setup_draw(CLI::App& app, DrawOptions& options);

/// Throws UsageError, RequestError, InputError, std::runtime_error.
void run_draw(const DrawOptions& options);

}  // namespace ligne
