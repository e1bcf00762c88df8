#pragma once
/// All commands of the program and their options. setup_NAME() adds a command, whose options must outlive the parse;
/// run_NAME() runs when the command line names it, and throws UsageError, RequestError, InputError, std::runtime_error.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/options/option_groups.hpp"
#include "picture/pages/frames.hpp"
#include "picture/pages/plot_drawing.hpp"
#include "picture/stream/streamed_model.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "picture/surface/surface_request.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// ligne surface: draws a surface z = f(x, y) as iso-curves with hidden lines removed.
struct SurfaceOptions {
  SurfaceRequest request;
  bool horizon_given = false;  ///< true if the method horizon is requested
  bool as_mesh = false;
  bool pixels = false;
  std::optional<unsigned> resolution;
  std::string axes_style;  ///< text of the option; empty: no axes, "true": the flag alone
  OutputOptions output;
  PlotterOptions plotter;
  RunOptions run;
};

/// Adds the command with its options.
CLI::App* add_surface_command(CLI::App& app, SurfaceOptions& options);

/// The request that the options make. Throws UsageError and RequestError for options that exclude each other.
SurfaceRequest checked_request(const SurfaceOptions& options, const MemoryLimit& memory);

/// Mesh format of --as-mesh, from the file suffix. Throws UsageError.
MeshFormat mesh_format_of(const OutputOptions& options);

/// Options for maps: contour labels, water, hachures, scale bar, north arrow.
void add_terrain_options(CLI::App& surface, SurfaceRequest& request);
/// Options for curves, points, colours and names.
void add_annotation_options(CLI::App& surface, SurfaceRequest& request);

void setup_surface(CLI::App& app, SurfaceOptions& options);

/// Puts formulas with a leading minus in parentheses, because CLI11 would take them for options: "-x^2" becomes "(-x^2)".
void protect_formulas(std::vector<std::string>& arguments);
void run_surface(const SurfaceOptions& options);

/// ligne plot: prepares drawings from files for pen plotters.
struct PlotCommandOptions {
  std::vector<std::string> drawings;  ///< files
  PlotDrawingRequest request;
  std::string occlude;  ///< text of the option; empty: not given, "true": the flag alone
  OutputOptions output;
  std::optional<bool> curves;
  PlotterOptions plotter;
  RunOptions run;
};

void setup_plot(CLI::App& app, PlotCommandOptions& options);
void run_plot(const PlotCommandOptions& options);

/// ligne methods: lists the visibility methods.
struct MethodsOptions {
  std::vector<std::string> names;  ///< empty: all methods
  bool json = false;
};

void setup_methods(CLI::App& app, MethodsOptions& options);
void run_methods(const MethodsOptions& options);

/// ligne info: describes a scene and how each method can draw it.
struct InfoOptions {
  ModelRequest model;
  ViewRequest view;
  LineRequest lines;
  MethodChoice method;
  PageRequest page;
  OutputOptions output;  ///< default: text to standard output
  RunOptions run;
  bool json = false;
};

void setup_info(CLI::App& app, InfoOptions& options);
void run_info(const InfoOptions& options);

/// ligne draw: a hidden-line drawing of meshes and polygon scenes.
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

void setup_draw(CLI::App& app, DrawOptions& options);
void run_draw(const DrawOptions& options);

/// ligne devices: lists the known plotters.
struct DevicesOptions {
  bool json = false;
};

void setup_devices(CLI::App& app, DevicesOptions& options);
void run_devices(const DevicesOptions& options);

/// ligne compile: writes a model with the view-independent data of a method to a file that ligne draw reads.
struct CompileOptions {
  ModelRequest model;
  const Method* method = nullptr;
  MethodChoice choice;
  std::optional<std::string> output;
  RunOptions run;
};

void setup_compile(CLI::App& app, CompileOptions& options);
void run_compile(const CompileOptions& options);

/// ligne compare: every method on one scene, side by side.
struct CompareOptions {
  ModelRequest model;
  ViewRequest view;
  LineRequest lines;
  MethodChoice method;
  std::vector<const Method*> methods;  ///< empty: all methods that produce lines
  double limit_seconds = 60;
  PageRequest page;
  std::string output = "-";
  std::string html;  ///< file name, or empty
  bool json = false, csv = false;
  RunOptions run;
};

void setup_compare(CLI::App& app, CompareOptions& options);
void run_compare(const CompareOptions& options);

/// ligne study: runs the separate program `ligne-study`, which repeats the experiments of the sources.
inline constexpr const char* kStudyTitle = "Repeat the experiments of the published sources";

/// Adds the command to the list of commands.
void add_study_command(CLI::App& app);

/// Runs `ligne-study` from this program's folder, or else from PATH, with these arguments. Returns its exit status, or 128 +
/// the number of the signal that ended it. Throws std::runtime_error if it is not found.
int run_study_program(const std::vector<std::string>& arguments);

struct Commands {
  DrawOptions draw;
  CompareOptions compare;
  CompileOptions compile;
  InfoOptions info;
  MethodsOptions methods;
  DevicesOptions devices;
  PlotCommandOptions plot;
  SurfaceOptions surface;
};

/// Adds the commands to the program; `commands` must outlive the parse. Only the command of the name `chosen` if there is
/// one: adding hundreds of options takes milliseconds.
inline void setup_commands(CLI::App& app, Commands& commands, std::string_view chosen = {}) {
  const std::pair<std::string_view, std::function<void()>> setups[] = {
      {"draw", [&] { setup_draw(app, commands.draw); }},
      {"surface", [&] { setup_surface(app, commands.surface); }},
      {"plot", [&] { setup_plot(app, commands.plot); }},
      {"compile", [&] { setup_compile(app, commands.compile); }},
      {"info", [&] { setup_info(app, commands.info); }},
      {"compare", [&] { setup_compare(app, commands.compare); }},
      {"methods", [&] { setup_methods(app, commands.methods); }},
      {"devices", [&] { setup_devices(app, commands.devices); }},
      {"study", [&] { add_study_command(app); }}};
  const bool is_command = std::ranges::any_of(setups, [&](const auto& setup) { return setup.first == chosen; });
  for (const auto& [name, setup] : setups) {
    if (!is_command || name == chosen) setup();
  }
}

}  // namespace ligne
