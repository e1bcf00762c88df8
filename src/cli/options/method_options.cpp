#include "cli/options/method_options.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/options/options.hpp"
#include "files/message_text.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Names of the methods with that parameter, such as "bsp, convex-tree".
std::string owners_of(std::string_view parameter) {
  std::string owners;
  for (const Method* method : all_methods()) {
    for (const MethodParameter& own : method->traits().parameters) {
      if (own.name == parameter) owners += (owners.empty() ? "" : ", ") + std::string(method->traits().name);
    }
  }
  return owners;
}

/// The parameters of all methods, each name once.
std::vector<const MethodParameter*> distinct_parameters() {
  std::vector<const MethodParameter*> parameters;
  for (const Method* method : all_methods()) {
    for (const MethodParameter& parameter : method->traits().parameters) {
      const auto has_name = [&parameter](const MethodParameter* known) { return known->name == parameter.name; };
      if (std::ranges::none_of(parameters, has_name)) parameters.push_back(&parameter);
    }
  }
  return parameters;
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
  for (const MethodParameter* parameter : distinct_parameters()) {
    if (of_compile && !parameter->of_compile) continue;
    if (parameter->is_experiment) {
      settings.push_back(parameter);
      continue;
    }
    const auto note = [&choice, parameter](const std::string& text) { choice.parameters.emplace_back(parameter, text); };
    group
        .add_text("--" + std::string(parameter->name), std::string(parameter->kind), note,
                  owners_of(parameter->name) + ": " + std::string(parameter->meaning))
        .standard(std::string(parameter->standard));
  }
  const auto note = [&choice, settings](const std::string& text) { note_setting(text, settings, choice); };
  group.add_repeatable("--set", "NAME=VALUE", note,
                       "a setting of the method, for experiments; ligne methods METHOD lists them");
}

}  // namespace

void add_line_options(CLI::App& app, LineRequest& request, MethodChoice& choice, bool one_method) {
  OptionGroup group(app, "Lines");
  if (one_method) {
    group.add("--method", "NAME", request.method, parse_method, "visibility method; see ligne methods").standard("auto");
  }
  const auto parse_given_edges = [&choice](const std::string& text) {
    choice.edges_given = true;
    return parse_edges(text);
  };
  group
      .add("--edges", "LIST", request.classes, parse_given_edges,
           "line classes to draw, comma-separated: outline, crease, border, intersection, tangent, mesh, shadow, profile, "
           "suggestive, ridge, valley, detail; feature: the first five; all: the first six")
      .standard("feature");
  const auto parse_both_creases = [&request](const std::string& text) {
    return request.surface_crease_degrees = parse_crease(text);
  };
  group.add("--crease", "DEG", request.crease_degrees, parse_both_creases, "smallest angle between normals at a crease")
      .standard("30 between faces, 10 between surfaces that a mesh stands for");
  group
      .add("--tangent", "HOW", request.tangent, parse_tangent,
           "lines of fillets: their borders, their middles; auto: middles of narrow ones, borders of others")
      .standard("auto");
  group.add("--min-length", "LEN", request.least_mm, parse_min_length, "leave out shorter visible parts of lines")
      .standard("1.5 pens; 0 for exact lines");
  const auto take_hidden = [&request](const std::string& text) {
    const HiddenChoice choice = parse_hidden_choice(text);
    request.hidden = choice.lines;
    request.most_hiding = choice.most_hiding;
  };
  group
      .add_text(
          "--hidden", "HOW", take_hidden,
          "draw hidden lines in a layer of their own: none, dashed or solid; dashed:N, solid:N: those behind at most N "
          "faces (--method appel)")
      .standard("none");
  group
      .add("--quality", "HOW", request.quality, parse_quality,
           "clear: lines of the shape that the mesh stands for; exact: every edge as stored")
      .standard("clear");
  group.add_flag("--cull", request.cull, "leave out back faces of closed, consistently wound objects");
  add_parameters(app, choice);
}

void add_compile_options(CLI::App& app, const Method*& method, MethodChoice& choice) {
  const std::vector<std::string_view> names = compiling_methods();
  method = find_method(names.front());
  const auto parse = [names](const std::string& text) { return find_method(names[parse_choice(text, names)]); };
  OptionGroup(app, "Methods").add("--method", "NAME", method, parse, list_of(names)).standard(std::string(names.front()));
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

}  // namespace ligne
