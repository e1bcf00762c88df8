#include "cli/plotter_options.hpp"

#include <iterator>
#include <utility>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "files/message_text.hpp"
#include "plotting/page.hpp"

namespace ligne {
namespace {

/// Files of devices and pens are short.
constexpr std::uintmax_t kMostTomlBytes = 1 << 20;

std::string file_name(const std::string& text) {
  if (text.empty()) throw std::invalid_argument("the name of the file is empty");
  return text;
}

std::string read_toml_file(const std::string& file, RunFiles& files) {
  InputFiles opened;
  const std::vector<std::byte> bytes = read_input(file, file, opened, kMostTomlBytes);
  files.were_read(opened);
  return std::string(as_characters(bytes));
}

std::string known_devices(DeviceLanguage language) {
  std::string names;
  for (const Device& device : devices()) {
    if (device.language == language) names += (names.empty() ? "" : ", ") + device.name;
  }
  return names;
}

DeviceLanguage language_of(OutputFormat format) {
  return format == OutputFormat::hpgl    ? DeviceLanguage::hpgl
         : format == OutputFormat::gcode ? DeviceLanguage::gcode
                                         : DeviceLanguage::svg;
}

/// The device that stands for a plotter language when none is named.
constexpr std::string_view kDefaultHpgl = "cutter", kDefaultGcode = "grbl-servo";

std::shared_ptr<const Device> device_of(const PlotterOptions& options, OutputFormat format, RunFiles& files) {
  const DeviceLanguage language = language_of(format);
  std::shared_ptr<const Device> device;
  if (!options.device_file.empty()) {
    device = std::make_shared<Device>(read_device(read_toml_file(options.device_file, files), options.device_file));
  } else {
    const std::string_view standard = language == DeviceLanguage::hpgl    ? kDefaultHpgl
                                      : language == DeviceLanguage::gcode ? kDefaultGcode
                                                                          : std::string_view{};
    const std::string_view name = options.device.empty() ? standard : std::string_view(options.device);
    if (name.empty()) return nullptr;
    const Device* known = find_device(name);
    if (!known) throw UsageError("--device", shown(name, '"') + " is not known; ligne devices lists them");
    device = std::make_shared<Device>(*known);
  }
  const std::string_view speaks = kDeviceLanguageNames[static_cast<std::size_t>(device->language)];
  if (device->language != language) {
    throw UsageError("--device", printable(device->name) + " takes " + std::string(speaks) + ", not " +
                                     std::string(kOutputFormatNames[static_cast<std::size_t>(format)]) +
                                     (known_devices(language).empty() ? "" : "; that take " + known_devices(language)));
  }
  return device;
}

}  // namespace

void add_plotter_options(CLI::App& app, PlotterOptions& options) {
  CLI::Option* device = add_parsed(app, "--device", "NAME", options.device, file_name, "the plotter, one of ligne devices")
                            ->default_str("cutter for HPGL, grbl-servo for G-code");
  CLI::Option* device_file =
      add_parsed(app, "--device-file", "FILE", options.device_file, file_name, "a plotter of your own, as TOML");
  CLI::Option* fit = app.add_flag("--fit-device", options.fit_device,
                                  "shift and shrink the drawing until it lies within the device's limits");
  CLI::Option* pens = add_parsed(app, "--pens", "FILE", options.pens_file, file_name, "pens, and what each draws, as TOML");
  CLI::Option* pen =
      app.add_option_function<std::vector<std::string>>(
             "--pen",
             [&options](const std::vector<std::string>& texts) {
               try {
                 for (const std::string& text : texts) add_pen(options.pens, text);
               } catch (const std::invalid_argument& e) {
                 throw UsageError("--pen", e.what());
               }
             },
             "CLASS=N[,COLOUR[,WIDTH]]: a class of lines, material:NAME, shade:N or rest to pen N; repeatable")
          ->type_name("TEXT")
          ->expected(1)
          ->allow_extra_args(false)
          ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  CLI::Option* optimize = add_parsed(
                              app, "--optimize", "HOW", options.optimize,
                              [](const std::string& t) { return static_cast<Optimize>(parse_choice(t, kOptimizeNames)); },
                              "off; join: lines once, ends joined; full: ordered too")
                              ->default_str("full for pens");
  const auto length = [](const std::string& t) { return parse_length_mm(t); };
  CLI::Option* join =
      add_parsed(app, "--join", "LEN", options.tolerances.ends_mm, length, "ends so near are joined")->default_str("0.05mm");
  CLI::Option* simplify =
      add_parsed(app, "--simplify", "LEN", options.tolerances.simplify_mm, length, "how far a line may leave its points")
          ->default_str("0.02mm");
  CLI::Option* report =
      app.add_flag("--report", options.report, "strokes, lengths, lifts and time before and after, to standard error");
  CLI::Option* preview = add_parsed(app, "--preview", "FILE", options.preview, file_name,
                                    "an SVG of the pen's way: order by colour, raised pen grey");
  device->excludes(device_file);
  for (CLI::Option* option : {device, device_file, fit, pens, pen, optimize, join, simplify, report, preview})
    option->group("Plotter");
}

PlotterSetup plotter_setup(const PlotterOptions& options, OutputFormat format, RunFiles& files) {
  PlotterSetup setup{options, nullptr, {}};
  if (format == OutputFormat::json) {
    const bool given = !options.device.empty() || !options.device_file.empty() || !options.pens_file.empty() ||
                       !options.pens.empty() || options.optimize || options.report || !options.preview.empty() ||
                       options.fit_device;
    if (given) throw UsageError("--format", "a JSON drawing has no pens; ligne plot makes a plot of it");
    return setup;
  }
  setup.device = device_of(options, format, files);
  if (options.fit_device && !setup.device) throw UsageError("--fit-device", "there is no --device");
  if (!options.pens_file.empty()) setup.pens = read_pens(read_toml_file(options.pens_file, files), options.pens_file);
  // What the command line says goes before what the file says.
  for (const auto& [number, pen] : options.pens.pens) {
    const auto [entry, added] = setup.pens.pens.emplace(number, pen);
    if (added) continue;
    entry->second.color = pen.color;
    if (pen.width_mm) entry->second.width_mm = pen.width_mm;
  }
  for (const auto& [layer, number] : options.pens.pen_of_layer) setup.pens.pen_of_layer[layer] = number;
  for (const auto& [material, number] : options.pens.pen_of_material) setup.pens.pen_of_material[material] = number;
  for (const auto& [shade, number] : options.pens.pen_of_shade) setup.pens.pen_of_shade[shade] = number;
  if (options.pens.rest != PenTable{}.rest) setup.pens.rest = options.pens.rest;
  return setup;
}

}  // namespace ligne
