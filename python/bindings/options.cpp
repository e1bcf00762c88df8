#include "bindings/options.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>
#include <string_view>

#include "bindings/values.hpp"
#include "files/closest_name.hpp"
#include "files/message_text.hpp"
#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/products.hpp"
#include "visibility/registry.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

/// Sets one option of a picture from its value.
using Setter = std::function<void(Options&, const std::string& name, py::handle value)>;

/// Sets an option by parsing the text of its value.
template <class Parser, class Target>
Setter text(Parser parser, Target target, char separator = ',') {
  return [=](Options& options, const std::string& name, py::handle value) {
    target(options) = parser(text_of(name, value, separator));
  };
}

template <class Target>
Setter flag(Target target) {
  return [=](Options& options, const std::string& name, py::handle value) { target(options) = flag_of(name, value); };
}

template <class Take>
Setter each(Take take) {
  return [=](Options& options, const std::string& name, py::handle value) {
    for (const std::string& one : texts_of(name, value)) take(options, one);
  };
}

std::string as_written(const std::string& text) { return text; }
double length(const std::string& text) { return parse_length_mm(text); }

void take_method(Options& options, const std::string& name) {
  options.horizon_given = name == "horizon";
  options.picture.lines.method = name == "auto" || name == "horizon" ? nullptr : parse_method(name);
}

const std::map<std::string, Setter, std::less<>>& setters() {
#define LIGNE_FIELD(field) \
  [](Options & o) -> auto& { return o.field; }
  static const std::map<std::string, Setter, std::less<>> table{
      {"view", each([](Options& o, const std::string& t) { parse_view(t, o.picture.view); })},
      {"direction", text(parse_vector, LIGNE_FIELD(picture.view.direction))},
      {"eye", text(parse_point, LIGNE_FIELD(picture.view.eye))},
      {"target", text(parse_point, LIGNE_FIELD(picture.view.target))},
      {"fov", text([](const std::string& t) { return parse_between(t, 0, 180, "degrees"); },
                   LIGNE_FIELD(picture.view.fov_degrees))},
      {"up", text(parse_vector, LIGNE_FIELD(picture.view.up))},
      {"up-axis", text(parse_axis, LIGNE_FIELD(picture.view.up_axis))},
      {"method", each(take_method)},
      {"edges", [](Options& o, const std::string& name, py::handle value) {
         o.edges_given = true;
         o.picture.lines.classes = parse_edges(text_of(name, value));
       }},
      {"profile", text(parse_profile, LIGNE_FIELD(picture.lines.profile))},
      {"crease", [](Options& o, const std::string& name, py::handle value) {
         o.picture.lines.crease_degrees = parse_crease(text_of(name, value));
         o.picture.lines.surface_crease_degrees = o.picture.lines.crease_degrees;
       }},
      {"tangent", text(parse_tangent, LIGNE_FIELD(picture.lines.tangent))},
      {"min-length", text(parse_min_length, LIGNE_FIELD(picture.lines.least_mm))},
      {"hidden", each([](Options& o, const std::string& t) {
         const HiddenChoice choice = parse_hidden_choice(t);
         o.picture.lines.hidden = choice.lines;
         o.picture.lines.most_hiding = choice.most_hiding;
       })},
      {"quality", text(parse_quality, LIGNE_FIELD(picture.lines.quality))},
      {"cull", flag(LIGNE_FIELD(picture.lines.cull))},
      {"regions", flag(LIGNE_FIELD(picture.regions))},
      {"fill", text(parse_fill, LIGNE_FIELD(picture.fill.kind))},
      {"light", each([](Options& o, const std::string& t) { o.picture.fill.lights.push_back(parse_vector(t)); })},
      {"page", text(parse_page_size, LIGNE_FIELD(picture.page.size), 'x')},
      {"landscape", flag(LIGNE_FIELD(picture.page.landscape))},
      {"portrait", flag(LIGNE_FIELD(picture.page.portrait))},
      {"margin", text(length, LIGNE_FIELD(picture.page.margin_mm))},
      {"pen-width", text(parse_pen_width, LIGNE_FIELD(picture.page.pen_width_mm))},
      {"width", each([](Options& o, const std::string& t) {
         for (const auto& [layer, width] : parse_widths(t)) o.picture.page.widths_mm[layer] = width;
         require_layers(o.picture.page.widths_mm);
       })},
      {"scale", text(parse_scale, LIGNE_FIELD(picture.page.scale))},
      {"unit", text(parse_unit_mm, LIGNE_FIELD(picture.page.unit_mm))},
      {"group", text([](const std::string& t) {
         constexpr std::string_view kGroupNames[] = {"none", "object"};
         return parse_choice(t, kGroupNames) == 1;
       }, LIGNE_FIELD(picture.output.group_objects))},
      {"color", each([](Options& o, const std::string& t) { o.picture.output.colors.push_back(parse_object_color(t)); })},
      {"format", text(parse_format, LIGNE_FIELD(picture.output.format))},
      {"dpi", text(parse_dpi, LIGNE_FIELD(picture.output.dpi))},
      {"curves", text([](const std::string& t) { return parse_choice(t, kSwitchNames) == 1; },
                      LIGNE_FIELD(picture.output.curves))},
      {"title", text(as_written, LIGNE_FIELD(picture.output.title))},
      {"shade", flag(LIGNE_FIELD(picture.gray_faces))},
      {"shade-tone", text(parse_gray_tone, LIGNE_FIELD(picture.gray_tone))},
      {"hatch", text(parse_hatch, LIGNE_FIELD(picture.hatch.kind))},
      {"hatch-spacing", text(parse_hatch_spacing, LIGNE_FIELD(picture.hatch.spacing_mm))},
      {"hatch-angle", text(parse_hatch_direction, LIGNE_FIELD(picture.hatch.direction))},
      {"hatch-levels", text(parse_hatch_levels, LIGNE_FIELD(picture.hatch.levels))},
      {"hatch-cross", flag(LIGNE_FIELD(picture.hatch.cross))},
      {"device", text(parse_file_name, LIGNE_FIELD(plotter.device))},
      {"device-file", text(parse_file_name, LIGNE_FIELD(plotter.device_file))},
      {"fit-device", flag(LIGNE_FIELD(plotter.request.fit_device))},
      {"pens", text(parse_file_name, LIGNE_FIELD(plotter.pens_file))},
      {"pen", each([](Options& o, const std::string& t) { add_pen(o.plotter.request.pens, t); })},
      {"optimize", text([](const std::string& t) { return static_cast<Optimize>(parse_choice(t, kOptimizeNames)); },
                        LIGNE_FIELD(plotter.request.optimize))},
      {"join", text(length, LIGNE_FIELD(plotter.request.tolerances.ends_mm))},
      {"simplify", text(length, LIGNE_FIELD(plotter.request.tolerances.simplify_mm))},
      {"report", flag(LIGNE_FIELD(plotter.request.report))},
      {"preview", [](Options& o, const std::string& name, py::handle value) {
         o.preview = parse_file_name(text_of(name, value));
         o.plotter.request.preview = true;
       }},
      {"threads", [](Options& o, const std::string&, py::handle value) { o.threads = threads_of(value); }},
      {"max-memory", text(parse_memory, LIGNE_FIELD(picture.memory))},
  };
#undef LIGNE_FIELD
  return table;
}

std::string option_name(py::handle keyword) {
  std::string name = keyword.cast<std::string>();
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

bool is_parameter(std::string_view name) {
  for (const Method* method : all_methods()) {
    for (const MethodParameter& parameter : method->traits().parameters) {
      if (parameter.name == name) return true;
    }
  }
  return false;
}

/// The suggestion as a keyword: " (pen_width?)".
std::string suggested_option(const std::string& name, std::vector<std::string_view> names) {
  for (const auto& [known, setter] : setters()) names.push_back(known);
  for (const Method* method : all_methods()) {
    for (const MethodParameter& parameter : method->traits().parameters) names.push_back(parameter.name);
  }
  std::string text = suggestion(name, names);
  std::replace(text.begin(), text.end(), '-', '_');
  return text;
}

MethodSettings settings_of(const Options& options, const Method& method) {
  MethodSettings settings;
  for (const auto& [name, value] : options.parameters) set_parameter(settings, method, name, value);
  return settings;
}

}  // namespace

void for_each_option(const py::dict& keywords,
                     const std::function<void(const std::string& name, pybind11::handle value)>& set) {
  for (const auto& [keyword, value] : keywords) {
    if (value.is_none()) continue;
    const std::string name = option_name(keyword);
    try {
      set(name, value);
    } catch (const std::invalid_argument& e) {
      throw RequestError(name, e.what());
    }
  }
}

py::dict with_format(const py::dict& keywords, const std::string& file) {
  if (keywords.contains("format") && !keywords["format"].is_none()) return keywords;
  py::dict whole = py::reinterpret_steal<py::dict>(PyDict_Copy(keywords.ptr()));
  try {
    whole["format"] = std::string(kOutputFormatNames[static_cast<std::size_t>(format_of_suffix(file))]);
  } catch (const std::invalid_argument& e) {
    throw RequestError("format", e.what());
  }
  return whole;
}

void Options::take(const py::dict& keywords, const std::vector<std::string_view>& others) {
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    if (const auto setter = setters().find(name); setter != setters().end()) {
      setter->second(*this, name, value);
    } else if (is_parameter(name)) {
      parameters.emplace_back(name, text_of(name, value));
    } else {
      throw RequestError(name, "there is no such option" + suggested_option(name, others));
    }
  });
}

PictureRequest Options::request() const {
  PictureRequest request = picture;
  const ViewRequest& view = request.view;
  if (view.named_view.has_value() + view.camera.has_value() + view.direction.has_value() + view.eye.has_value() > 1) {
    throw RequestError("view", "only one of view, direction and eye can be given");
  }
  if (!edges_given && !request.fill.lights.empty()) request.lines.classes.add(LineClass::shadow);
  if (request.lines.profiles() != ProfileKind::off) request.lines.classes.add(LineClass::profile);
  InputFiles files;
  request.plotter = plotter_request(plotter, request.output.format, files);
  request.plotter.fit_drawing = !request.page.scale;
  choose_method_of_gray_faces(request);
  check(request);
  request.lines.settings = settings_of(*this, method_of(request));
  count_hidden(request.lines);
  return request;
}

unsigned threads_of(py::handle value) {
  constexpr unsigned kMostThreads = 1024;
  return parse_count(text_of("threads", value), 0, kMostThreads);
}

ModelRequest model_request(const py::dict& keywords) {
  ModelRequest request;
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    if (name == "weld") {
      const std::string distance = text_of(name, value);
      request.weld_distance = parse_weld(distance == "0" ? "off" : distance);
    } else if (name == "pose") {
      request.pose = parse_pose(text_of(name, value));
    } else if (name == "assume") {
      request.assumed = parse_facts(text_of(name, value));
    } else if (name == "subdivide") {
      request.subdivision = parse_subdivision(text_of(name, value));
    } else if (name == "merge-coplanar") {
      request.merge_coplanar = flag_of(name, value);
    } else if (name == "only" || name == "hide") {
      for (const std::string& names : texts_of(name, value)) {
        for (std::string& one : parse_names(names)) {
          (name == "only" ? request.parts.only : request.parts.hide).push_back(std::move(one));
        }
      }
    } else if (name == "move") {
      for (const std::string& one : texts_of(name, value)) request.parts.moves.push_back(parse_move(one));
    } else if (name == "quality") {
      request.quality = parse_quality(text_of(name, value));
    } else if (name == "unit") {
      request.unit_mm = parse_unit_mm(text_of(name, value));
    } else if (name == "groups") {
      request.tell_parts = flag_of(name, value);
    } else {
      throw RequestError(name, "there is no such option");
    }
  });
  return request;
}

}  // namespace ligne::python
