#pragma once
/// All commands of the program and their options. setup_NAME() adds a command, whose options must outlive the parse;
/// run_NAME() runs when the command line names it, and throws UsageError, RequestError, InputError, std::runtime_error.

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
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
/// `awaits_value`: whether an argument is an option whose value is the next argument.
void protect_formulas(std::vector<std::string>& arguments, const std::function<bool(const std::string&)>& awaits_value);
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

struct Command {
  std::string_view name;
  std::function<void(CLI::App&)> set_up;  ///< adds the command with its options
  std::function<void()> run;              ///< empty for the study
  RunOptions* options = nullptr;          ///< gets the names of the given options; null for lists
};

/// All commands. They refer to `c`.
inline std::vector<Command> all_commands(Commands& c) {
  return {
      {"draw", [&](CLI::App& app) { setup_draw(app, c.draw); }, [&] { run_draw(c.draw); }, &c.draw.run},
      {"surface", [&](CLI::App& app) { setup_surface(app, c.surface); }, [&] { run_surface(c.surface); }, &c.surface.run},
      {"plot", [&](CLI::App& app) { setup_plot(app, c.plot); }, [&] { run_plot(c.plot); }, &c.plot.run},
      {"compile", [&](CLI::App& app) { setup_compile(app, c.compile); }, [&] { run_compile(c.compile); }, &c.compile.run},
      {"info", [&](CLI::App& app) { setup_info(app, c.info); }, [&] { run_info(c.info); }, &c.info.run},
      {"compare", [&](CLI::App& app) { setup_compare(app, c.compare); }, [&] { run_compare(c.compare); }, &c.compare.run},
      {"methods", [&](CLI::App& app) { setup_methods(app, c.methods); }, [&] { run_methods(c.methods); }},
      {"devices", [&](CLI::App& app) { setup_devices(app, c.devices); }, [&] { run_devices(c.devices); }},
      {"study", add_study_command, {}}};
}

/// Adds the commands to the program; `commands` must outlive the parse. Only the command of the name `chosen` if there is
/// one: adding hundreds of options takes milliseconds.
inline void setup_commands(CLI::App& app, Commands& commands, std::string_view chosen = {}) {
  const std::vector<Command> all = all_commands(commands);
  const bool is_command = std::ranges::count(all, chosen, &Command::name) > 0;
  for (const Command& command : all) {
    if (!is_command || command.name == chosen) command.set_up(app);
  }
}

}  // namespace ligne
