#include "cli/options/option_groups.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/console.hpp"
#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// The methods whose parameter of one name has the same values and the same meaning.
struct ParameterUse {
  const MethodParameter* parameter;
  std::string owners;  ///< such as "bsp, convex-tree"
};

/// The parameters of all methods, grouped by name.
std::vector<std::vector<ParameterUse>> parameters_by_name() {
  std::vector<std::vector<ParameterUse>> groups;
  for (const Method* method : all_methods()) {
    const std::string owner(method->traits().name);
    for (const MethodParameter& own : method->traits().parameters) {
      const auto has_name = [&own](const std::vector<ParameterUse>& uses) { return uses[0].parameter->name == own.name; };
      auto uses = std::ranges::find_if(groups, has_name);
      if (uses == groups.end()) uses = groups.insert(groups.end(), std::vector<ParameterUse>());
      const auto is_same = [&own](const ParameterUse& use) {
        return use.parameter->kind == own.kind && use.parameter->meaning == own.meaning;
      };
      const auto same = std::ranges::find_if(*uses, is_same);
      if (same == uses->end()) {
        uses->push_back({&own, owner});
      } else {
        same->owners += ", " + owner;
      }
    }
  }
  return groups;
}

/// The alternatives of all uses, each once: "clips|windows|spans".
std::string kind_of(const std::vector<ParameterUse>& uses) {
  std::vector<std::string_view> words;
  for (const ParameterUse& use : uses) {
    for (std::string_view rest = use.parameter->kind; !rest.empty();) {
      const std::string_view word = rest.substr(0, rest.find('|'));
      if (std::ranges::find(words, word) == words.end()) words.push_back(word);
      rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    }
  }
  std::string kind;
  for (const std::string_view word : words) kind += (kind.empty() ? "" : "|") + std::string(word);
  return kind;
}

/// The help of a parameter: "METHODS: meaning; METHODS (KIND): meaning".
std::string help_of(const std::vector<ParameterUse>& uses) {
  std::string help;
  for (const ParameterUse& use : uses) {
    const std::string kind = uses.size() > 1 ? " (" + std::string(use.parameter->kind) + ")" : "";
    help += (help.empty() ? "" : "; ") + use.owners + kind + ": " + std::string(use.parameter->meaning);
  }
  return help;
}

/// Records a "NAME=VALUE" of --set. The value is checked once the method is known.
void note_setting(const std::string& text, std::span<const MethodParameter* const> known, MethodChoice& choice) {
  const std::size_t sign = text.find('=');
  if (sign == std::string::npos) throw std::invalid_argument(shown(text, '"') + " is not NAME=VALUE");
  std::vector<std::string_view> names;
  for (const MethodParameter* parameter : known) names.push_back(parameter->name);
  const MethodParameter& parameter = *known[parse_choice(text.substr(0, sign), names)];
  for (const auto& [earlier, value] : choice.parameters) {
    if (earlier->name == parameter.name) throw std::invalid_argument(std::string(parameter.name) + ": given more than once");
  }
  choice.parameters.emplace_back(&parameter, text.substr(sign + 1));
}

/// Adds an option for each user parameter, and --set for the parameters of experiments.
void add_parameters(CLI::App& app, MethodChoice& choice, bool of_compile = false) {
  OptionGroup group(app, "Methods");
  std::vector<const MethodParameter*> settings;
  for (const std::vector<ParameterUse>& uses : parameters_by_name()) {
    const MethodParameter* const parameter = uses.front().parameter;
    if (of_compile && !parameter->of_compile) continue;
    if (parameter->is_experiment) {
      settings.push_back(parameter);
      continue;
    }
    const auto note = [&choice, parameter](const std::string& text) { choice.parameters.emplace_back(parameter, text); };
    group.add_text("--" + std::string(parameter->name), kind_of(uses), note, help_of(uses),
                   std::string(parameter->standard));
  }
  const auto note = [&choice, settings](const std::string& text) { note_setting(text, settings, choice); };
  group.add_repeatable("--set", "NAME=VALUE", note,
                       "an experimental setting of the method; ligne methods METHOD lists them");
}

/// Sets of output formats, as bits.
constexpr unsigned bit(OutputFormat format) { return 1u << static_cast<unsigned>(format); }
constexpr unsigned kSvg = bit(OutputFormat::svg), kPng = bit(OutputFormat::png), kJson = bit(OutputFormat::json),
                   kPaper = kSvg | bit(OutputFormat::pdf) | kPng,
                   kPlotted = bit(OutputFormat::hpgl) | bit(OutputFormat::gcode), kDrawn = kPaper | kPlotted,
                   kAll = kDrawn | kJson;

/// Words in OptionUse::needs beside names of options.
constexpr std::string_view kPens = "pens", kNoPens = "no-pens", kSvgInput = "svg";

/// The conditions under which an option has an effect. Other combinations get a warning.
struct OptionUse {
  std::string_view commands;  ///< separated by blanks
  std::string_view option;
  unsigned formats = kAll;
  std::string_view needs{};   ///< one of these options or of the words above, separated by blanks; empty: none
  unsigned needed_in = kAll;  ///< formats in which the option needs them
};

constexpr OptionUse kUses[] = {
    {"surface plot", "--dpi", kPng},
    {"draw", "--dpi", kPaper, "--shade-tone", kSvg | bit(OutputFormat::pdf)},
    {"draw", "--shade-tone", kPaper, "--shade --fill"},
    {"draw surface", "--curves", kPaper, kNoPens},
    {"plot", "--curves", kPaper},
    {"draw", "--profile", kAll, "--pens --pen", kPlotted},
    {"surface", "--pen-width", kAll,
     "--hatch --hachures --water-fill --grid --method --contours --contour-step --outline --parametric --points --curve",
     kPlotted | kJson},
    {"plot", "--pen-width", kAll, "--hatch --hatch-spacing --hatch-angle --hatch-cross --fill --occlude", kPlotted},
    {"draw", "--title", kSvg | bit(OutputFormat::pdf)},
    {"surface", "--title", kDrawn},
    {"draw", "--group", kSvg | kJson, kNoPens},
    {"draw surface plot", "--width", kPaper},
    {"draw surface", "--join", kDrawn, "pens --optimize"},
    {"draw surface", "--simplify", kDrawn, "pens --optimize"},
    {"draw surface", "--unit", kAll, "--scale --move"},
    {"draw", "--samples", kAll, "--surface"},
    {"draw", "--every", kAll, "--grid"},
    {"surface", "--text", kDrawn, "--axes --title --scale-bar --north-arrow --legend --points --contour-labels"},
    {"surface", "--text-height", kDrawn, "--axes --title --scale-bar --north-arrow --legend --points --contour-labels"},
    {"surface", "--contour-labels", kDrawn},
    {"surface", "--x-names", kAll, "--axes"},
    {"surface", "--y-names", kAll, "--axes"},
    {"surface", "--z-names", kAll, "--axes"},
    {"surface", "--index-contours", kPaper},
    {"surface", "--points", kDrawn},
    {"surface", "--colors", kPaper, kNoPens},
    {"surface", "--sun", kAll, "--hachures"},
    {"plot", "--margin", kAll, "--scale --tile --grid"},
    {"plot", "--skip", kAll, kSvgInput},
    {"plot", "--strict", kAll, kSvgInput},
    {"plot", "--input-dpi", kAll, kSvgInput},
    {"plot", "--occlude", kAll, kSvgInput},
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words = split(text, ' ');
  std::erase(words, "");
  return words;
}

bool holds(std::string_view need, const CommandUse& use) {
  if (need == kPens) return use.by_pens;
  if (need == kNoPens) return !use.by_pens;
  if (need == kSvgInput) return use.svg_input;
  return std::ranges::find(use.given, need) != use.given.end();
}

/// The words for a need in a message.
std::string_view phrase_of(std::string_view need) {
  if (need == kPens) return "pens or a --device";
  if (need == kNoPens) return "a drawing without pens";
  return need == kSvgInput ? "an SVG input" : need;
}

std::string names_of(unsigned formats) {
  std::vector<std::string_view> names;
  for (std::size_t f = 0; f < std::size(kOutputFormatNames); ++f) {
    if (formats & bit(static_cast<OutputFormat>(f))) names.push_back(kOutputFormatNames[f]);
  }
  return list_of(names);
}

}  // namespace

void add_line_options(CLI::App& app, LineRequest& request, MethodChoice& choice, bool one_method) {
  OptionGroup group(app, "Lines");
  if (one_method) {
    group.add("--method", "NAME", request.method, parse_method, "visibility method; see ligne methods", "auto");
  }
  const auto parse_given_edges = [&choice](const std::string& text) {
    choice.edges_given = true;
    return parse_edges(text);
  };
  group.add("--edges", "LIST", request.classes, parse_given_edges,
            "line classes to draw, comma-separated: outline, crease, border, intersection, tangent, mesh, shadow, profile, "
            "suggestive, ridge, valley, detail; feature: the first five; all: the first six",
            "feature");
  const auto parse_both_creases = [&request](const std::string& text) {
    return request.surface_crease_degrees = parse_crease(text);
  };
  group.add("--crease", "DEG", request.crease_degrees, parse_both_creases, "smallest angle between normals at a crease",
            "30 between faces, 10 between surfaces that the mesh approximates");
  group.add(
      "--tangent", "HOW", request.tangent, parse_tangent,
      "lines of fillets. borders; middles: their middle lines; auto: middles of narrow fillets, borders of others; none",
      "auto");
  group.add("--min-length", "LEN", request.least_mm, parse_min_length, "omit visible line parts shorter than LEN",
            "1.5 pens; 0 for exact lines");
  const auto take_hidden = [&request](const std::string& text) {
    const HiddenChoice choice = parse_hidden_choice(text);
    request.hidden = choice.lines;
    request.most_hiding = choice.most_hiding;
  };
  group.add_text(
      "--hidden", "HOW", take_hidden,
      "draw hidden lines in their own layer: none, dashed or solid; dashed:N, solid:N: only lines behind at most N "
      "faces (--method appel)",
      "none");
  group.add("--quality", "HOW", request.quality, parse_quality,
            "clear: lines of the shape that the mesh approximates; exact: every edge as stored", "clear");
  group.add_flag("--cull", request.cull, "omit back faces of closed, consistently wound objects");
  add_parameters(app, choice);
}

void add_compile_options(CLI::App& app, const Method*& method, MethodChoice& choice) {
  const std::vector<std::string_view> names = compiling_methods();
  method = find_method(names.front());
  const auto parse = [names](const std::string& text) { return find_method(names[parse_choice(text, names)]); };
  OptionGroup(app, "Methods").add("--method", "NAME", method, parse, list_of(names), std::string(names.front()));
  add_parameters(app, choice, true);
}

std::vector<std::pair<std::string, std::string>> named(const MethodChoice& choice) {
  std::vector<std::pair<std::string, std::string>> given;
  for (const auto& [parameter, text] : choice.parameters) given.emplace_back(parameter->name, text);
  return given;
}

std::vector<std::string> names_of(const MethodChoice& choice) {
  std::vector<std::string> names;
  for (const auto& [parameter, text] : choice.parameters) names.emplace_back(parameter->name);
  return names;
}

MethodSettings settings_of(const MethodChoice& choice, const Method& method) {
  MethodSettings settings;
  for (const auto& [parameter, text] : choice.parameters) {
    set_parameter(settings, method, std::string(parameter->name), text);
  }
  return settings;
}

std::vector<IdleOption> idle_options(const CommandUse& use) {
  std::vector<IdleOption> idle;
  for (const OptionUse& row : kUses) {
    const std::vector<std::string_view> commands = words_of(row.commands);
    if (std::ranges::find(commands, use.command) == commands.end()) continue;
    if (std::ranges::find(use.given, row.option) == use.given.end()) continue;
    if (!(row.formats & bit(use.format))) {
      const std::string_view format = kOutputFormatNames[static_cast<std::size_t>(use.format)];
      idle.push_back(
          {std::string(row.option), "has no effect in " + std::string(format) + ", only in " + names_of(row.formats)});
      continue;
    }
    std::vector<std::string_view> needs = words_of(row.needed_in & bit(use.format) ? row.needs : std::string_view());
    if (needs.empty() || std::ranges::any_of(needs, [&](std::string_view need) { return holds(need, use); })) continue;
    std::ranges::transform(needs, needs.begin(), phrase_of);
    idle.push_back({std::string(row.option), "has no effect without " + list_of(needs)});
  }
  return idle;
}

void warn_of_idle_options(const CommandUse& use) {
  for (const IdleOption& idle : idle_options(use)) warn(idle.option, idle.why);
}

}  // namespace ligne
