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
    group.add_text("--" + std::string(parameter->name), kind_of(uses), note, help_of(uses))
        .standard(std::string(parameter->standard));
  }
  const auto note = [&choice, settings](const std::string& text) { note_setting(text, settings, choice); };
  group.add_repeatable("--set", "NAME=VALUE", note,
                       "an experimental setting of the method; ligne methods METHOD lists them");
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
      .standard("30 between faces, 10 between surfaces that the mesh approximates");
  group
      .add("--tangent", "HOW", request.tangent, parse_tangent,
           "lines of fillets. borders; middles: their middle lines; auto: middles of narrow fillets, borders of others")
      .standard("auto");
  group.add("--min-length", "LEN", request.least_mm, parse_min_length, "omit visible line parts shorter than LEN")
      .standard("1.5 pens; 0 for exact lines");
  const auto take_hidden = [&request](const std::string& text) {
    const HiddenChoice choice = parse_hidden_choice(text);
    request.hidden = choice.lines;
    request.most_hiding = choice.most_hiding;
  };
  group
      .add_text(
          "--hidden", "HOW", take_hidden,
          "draw hidden lines in their own layer: none, dashed or solid; dashed:N, solid:N: only lines behind at most N "
          "faces (--method appel)")
      .standard("none");
  group
      .add("--quality", "HOW", request.quality, parse_quality,
           "clear: lines of the shape that the mesh approximates; exact: every edge as stored")
      .standard("clear");
  group.add_flag("--cull", request.cull, "omit back faces of closed, consistently wound objects");
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
