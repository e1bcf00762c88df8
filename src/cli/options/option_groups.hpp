#pragma once
/// The groups of options that commands share, what they fill in, and the files of a run.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/memory_limit.hpp"
#include "cli/options/options.hpp"
#include "files/input_file.hpp"
#include "picture/models/memory.hpp"
#include "picture/models/models.hpp"
#include "picture/pages/plotter.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "picture/surface/surface_request.hpp"
#include "plotting/writers/output_file.hpp"
#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

/// The files that a run reads and writes. No file that was read is overwritten, and all written files are moved into place
/// together at the end. Files are compared by identity, not by name.
class RunFiles {
 public:
  /// Registers the output file of an option; empty: none. Throws UsageError if another option names the file too, or if it
  /// was read.
  void will_write(const std::string& option, const std::filesystem::path& file);
  /// Registers files that were read or belong to them. Throws UsageError if one of them is an output file.
  void were_read(const InputFiles& files);
  /// Stores the contents of a file registered with will_write().
  void write(const std::filesystem::path& file, std::string bytes) { outputs_.add(file, std::move(bytes)); }
  /// Moves all files into place.
  void commit() { outputs_.commit(); }

 private:
  struct Written {
    std::string option;
    std::filesystem::path file;
  };
  std::vector<Written> written_;
  InputFiles read_;
  OutputFiles outputs_;
};

enum class ShowProgress { automatic, always, never };
inline constexpr std::string_view kShowProgressNames[] = {"auto", "always", "never"};

struct RunOptions {
  unsigned threads = 0;  ///< 0: all cores
  std::optional<MemoryLimit> max_memory;
  bool stats = false;
  std::string stats_json;  ///< file name, or empty
  ShowProgress progress = ShowProgress::automatic;
  bool quiet = false;
  std::vector<std::string> given{};  ///< names of all options given on the command line

  MemoryLimit memory() const { return max_memory ? *max_memory : usual_memory_limit(); }
};

void add_run_options(CLI::App& app, RunOptions& options);

/// Writes the warnings unless the run is quiet. `place` precedes warnings that name no file.
void report_warnings(const RunReport& report, const std::string& place, const RunOptions& options);

/// The files of a picture as named on the command line.
struct PictureNames {
  std::string output;
  std::string preview;  ///< may be empty
  std::string place;    ///< precedes warnings that name no file
};

/// Writes a picture, its preview, and the requested reports on standard error.
void deliver(Picture picture, const PictureNames& names, const RunOptions& options, RunReport& report, RunFiles& files);

/// Ends a run: writes its counts and times as the options require, and moves all files into place.
void finish(const RunOptions& options, const RunReport& report, RunFiles& files);

struct OutputOptions {
  std::optional<std::string> file;  ///< "-" is standard output
  std::optional<OutputFormat> format;
};

/// Adds -o and --format. `formats` is the help text of --format: the choices and the default.
void add_output_options(CLI::App& app, OutputOptions& options,
                        const std::string& formats = "svg pdf png json hpgl gcode (default: by the suffix)");

/// Adds --dpi.
void add_dpi_option(CLI::App& app, double& dpi);

/// Adds --curves. `standard` is the default shown in the help text.
void add_curves_option(CLI::App& app, std::optional<bool>& curves, const std::string& standard);

/// Adds --title.
void add_title_option(CLI::App& app, std::string& title, const std::string& help);

/// Warns if the suffix of the file names another format than --format.
void warn_of_suffix(const OutputOptions& options);

/// The format: --format, or else from the suffix of the file. Throws UsageError if neither determines it.
OutputFormat format_of(const OutputOptions& options);

/// Options for pens and plotters.
struct PlotterOptions {
  PlotterChoice choice;
  std::string preview;  ///< file name; empty: none
};

void add_plotter_options(CLI::App& app, PlotterOptions& options);

void add_model_options(CLI::App& app, ModelRequest& request);

/// Adds the options that distinguish parts in the picture.
void add_part_drawing_options(CLI::App& app, OutputRequest& request);

/// The stage of reading the models.
Stage reading_of(const ModelRequest& request);

/// Reads all files and records them in `files`. Writes one line per kind of warning unless `quiet`; `with_areas` as in
/// Warnings::lines(). Throws InputError, UsageError.
LoadedModels load_models(const ModelRequest& request, bool quiet, RunFiles& files, bool with_areas = false);

/// Options of lines and methods that the request does not hold.
struct MethodChoice {
  bool edges_given = false;
  std::vector<std::pair<const MethodParameter*, std::string>> parameters;  ///< given options that only some methods have
};

/// `one_method`: adds --method.
void add_line_options(CLI::App& app, LineRequest& request, MethodChoice& choice, bool one_method = true);

/// Adds --method for methods that compile, and the parameters of compiling.
void add_compile_options(CLI::App& app, const Method*& method, MethodChoice& choice);

/// The given options of the methods themselves: name and value.
std::vector<std::pair<std::string, std::string>> named(const MethodChoice& choice);

/// The names of these options.
std::vector<std::string> names_of(const MethodChoice& choice);

/// The values of the method's own parameters. Throws RequestError for a parameter that the method does not have, or a wrong
/// value.
MethodSettings settings_of(const MethodChoice& choice, const Method& method);

/// `standard`: the default view shown in the help text.
void add_view_options(CLI::App& app, ViewRequest& request, const std::string& standard = "iso");

/// Options for the page and the position of the picture on it.
void add_page_options(CLI::App& app, PageRequest& request);

/// Adds --width with the names of layers. `own_layers`: allows only the program's own layers.
void add_width_option(CLI::App& app, LineWidths& widths, bool own_layers);

/// Options for filled faces and light sources.
void add_fill_options(CLI::App& app, FillRequest& request);

/// Options for hatched faces.
void add_hatch_options(CLI::App& app, HatchRequest& request);

/// `style`: text behind --axes; empty: not given, "true": the flag alone.
void add_axes_options(CLI::App& app, AxesChoice& choice, std::string& style);

/// Puts the style into the choice. Throws UsageError for an unknown style, and for axis names without axes.
void check_axes(AxesChoice& choice, const std::string& style);

/// Options for surfaces given by three formulas in u and v, of ligne surface and ligne draw.

/// Adds --parametric X Y Z, repeatable.
void add_parametric(OptionGroup& group, SurfaceRequest& request, const std::string& help);

/// Adds -u and -v, repeatable: one range per surface, in order.
void add_parameter_ranges(OptionGroup& group, SurfaceRequest& request);

/// The parts of a command line that decide which options have an effect.
struct CommandUse {
  std::string_view command;          ///< "draw"
  std::vector<std::string> given{};  ///< names of the given options, such as "--dpi" and "-x"
  OutputFormat format = OutputFormat::svg;
  bool by_pens = false;   ///< true if the drawing is divided among pens
  bool svg_input = true;  ///< plot: true if a drawing is an SVG
};

/// An option without effect, and the reason as a phrase.
struct IdleOption {
  std::string option, why;
};

/// The options without effect, in the order of the table. Options that would change the picture in another format are
/// refused elsewhere (check() of PictureRequest).
std::vector<IdleOption> idle_options(const CommandUse& use);

/// Warns of these options, one line each.
void warn_of_idle_options(const CommandUse& use);

}  // namespace ligne
