#include <array>
#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "bindings/drawing.hpp"
#include "bindings/values.hpp"
#include "picture/errors.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

constexpr std::string_view kUndersideNames[] = {"same", "apart", "none"}, kHiddenByNames[] = {"surface", "curves"},
                           kHorizonNames[] = {"exact", "pixels"}, kAxesStyleNames[] = {"back", "grid", "box", "base"},
                           kTextStyleNames[] = {"font", "stroke"};
constexpr unsigned kMost = 1'000'000, kMostContours = 10'000, kResolution = 2000;
constexpr double kHighestTextMm = 1000;

using Setter = std::function<void(SurfaceRequest&, const std::string& name, py::handle value)>;

template <class Parser, class Target>
Setter text(Parser parser, Target target, char separator = ',') {
  return [=](SurfaceRequest& surface, const std::string& name, py::handle value) {
    target(surface) = parser(text_of(name, value, separator));
  };
}

/// A sequence of ranges, or one.
Setter ranges(std::vector<CurveRange> SurfaceRequest::*target) {
  return [=](SurfaceRequest& surface, const std::string& name, py::handle value) {
    const bool several = py::isinstance<py::list>(value);
    if (!several) (surface.*target).push_back(parse_range(text_of(name, value, ':')));
    if (several) {
      for (const py::handle one : value) (surface.*target).push_back(parse_range(text_of(name, one, ':')));
    }
  };
}

/// True, or a number: an option that may stand alone.
template <class Flag, class Target>
Setter flag_or_value(Flag flag, Target target) {
  return [=](SurfaceRequest& surface, const std::string& name, py::handle value) {
    if (PyBool_Check(value.ptr())) {
      flag(surface) = value.cast<bool>();
    } else {
      flag(surface) = true;
      target(surface) = parse_number(text_of(name, value));
    }
  };
}

unsigned count(const std::string& t) { return parse_count(t, 1, kMost); }

double parse_text_height(const std::string& t) {
  const double height = parse_length_mm(t);
  if (!(height > 0 && height <= kHighestTextMm)) throw std::invalid_argument("is not above 0 and at most 1000 mm");
  return height;
}

void set_axes(SurfaceRequest& surface, const std::string& name, py::handle value) {
  if (PyBool_Check(value.ptr())) {
    if (value.cast<bool>()) surface.picture.axes.style = AxesStyle::back;
    return;
  }
  surface.picture.axes.style = static_cast<AxesStyle>(parse_choice(text_of(name, value), kAxesStyleNames));
}

const std::map<std::string, Setter, std::less<>>& setters() {
#define LIGNE_FIELD(field) \
  [](SurfaceRequest & s) -> auto& { return s.field; }
  static const std::map<std::string, Setter, std::less<>> table{
      {"x", text(parse_range, LIGNE_FIELD(x), ':')},
      {"y", text(parse_range, LIGNE_FIELD(y), ':')},
      {"u", ranges(&SurfaceRequest::u)},
      {"v", ranges(&SurfaceRequest::v)},
      {"samples", text([](const std::string& t) { return parse_count(t, 2, kMost); }, LIGNE_FIELD(samples))},
      {"every", text(parse_every, LIGNE_FIELD(every))},
      {"gridded", text([](const std::string& t) { return parse_count(t, 2, kMostCurves); }, LIGNE_FIELD(gridded))},
      {"ground", text(parse_ground, LIGNE_FIELD(ground))},
      {"max_slope", text(parse_positive, LIGNE_FIELD(max_slope))},
      {"aspect", text(parse_aspect, LIGNE_FIELD(aspect), ':')},
      {"exaggeration", text(parse_positive, LIGNE_FIELD(exaggeration))},
      {"lines", text([](const std::string& t) { return static_cast<CurveFamilies>(parse_choice(t, kCurveFamilyNames)); },
                     LIGNE_FIELD(lines))},
      {"azimuth", text(parse_number, LIGNE_FIELD(azimuth_degrees))},
      {"elevation",
       text([](const std::string& t) { return parse_within(t, -90, 90, "degrees"); }, LIGNE_FIELD(elevation_degrees))},
      {"z_scale", text(parse_positive, LIGNE_FIELD(z_scale))},
      {"log_x", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[0] = flag_of(name, value); }},
      {"log_y", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[1] = flag_of(name, value); }},
      {"log_z", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[2] = flag_of(name, value); }},
      {"z_range", text(parse_heights, LIGNE_FIELD(z_range), ':')},
      {"skirt", flag_or_value(LIGNE_FIELD(skirt), LIGNE_FIELD(skirt_base))},
      {"horizon",
       [](SurfaceRequest& s, const std::string& name, py::handle value) {
         if (parse_choice(text_of(name, value), kHorizonNames) == 1) s.pixel_columns = s.pixel_columns.value_or(kResolution);
       }},
      {"resolution", text(count, LIGNE_FIELD(pixel_columns))},
      {"contours",
       text([](const std::string& t) { return parse_count(t, 1, kMostContours); }, LIGNE_FIELD(curves.contours))},
      {"contour_step", text(parse_positive, LIGNE_FIELD(curves.contour_step))},
      {"contours_base", flag_or_value(LIGNE_FIELD(curves.contours_base), LIGNE_FIELD(curves.contour_base))},
      {"outline",
       text([](const std::string& t) { return parse_choice(t, kSwitchNames) == 1; }, LIGNE_FIELD(curves.outline))},
      {"underside", text([](const std::string& t) { return static_cast<Underside>(parse_choice(t, kUndersideNames)); },
                         LIGNE_FIELD(curves.underside))},
      {"hidden_by", text([](const std::string& t) { return static_cast<HiddenBy>(parse_choice(t, kHiddenByNames)); },
                         LIGNE_FIELD(curves.hidden_by))},
      {"ridgeline", flag_or_value(LIGNE_FIELD(curves.ridgeline), LIGNE_FIELD(curves.ridgeline_overlap))},
      {"axes", set_axes},
      {"x_label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[0]))},
      {"y_label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[1]))},
      {"z_label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[2]))},
      {"text", text([](const std::string& t) { return static_cast<TextStyle>(parse_choice(t, kTextStyleNames)); },
                    LIGNE_FIELD(picture.axes.text))},
      {"text_height", text(parse_text_height, LIGNE_FIELD(picture.axes.text_height_mm))},
  };
#undef LIGNE_FIELD
  return table;
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> values(const Numbers& array) { return {array.data(), array.data() + array.size()}; }

using Heights = std::tuple<std::string, Numbers, Numbers, Numbers>;

}  // namespace

void take_surface_options(SurfaceRequest& surface, const py::dict& keywords) {
  for (const auto& [keyword, value] : keywords) {
    if (value.is_none()) continue;
    const std::string name = keyword.cast<std::string>();
    const auto setter = setters().find(name);
    if (setter == setters().end()) throw RequestError(name, "there is no such option");
    try {
      setter->second(surface, name, value);
    } catch (const std::invalid_argument& e) {
      throw RequestError(name, e.what());
    }
  }
  if (surface.pixel_columns && keywords.contains("horizon") && keywords["horizon"].is_none()) {
    throw RequestError("resolution", "goes with horizon=\"pixels\"");
  }
}

void add_surface(py::module_& module) {
  module.def(
      "surface",
      [](std::vector<std::string> formulas, std::vector<std::string> grids, const std::vector<Heights>& heights,
         std::vector<std::array<std::string, 3>> parametric, const py::dict& surface_options, const py::dict& keywords,
         const py::object& progress) {
        SurfaceRequest surface;
        surface.formulas = std::move(formulas);
        surface.grids = std::move(grids);
        surface.parametric = std::move(parametric);
        for (const auto& [name, x, y, z] : heights) surface.heights.push_back({name, values(x), values(y), values(z)});
        take_surface_options(surface, surface_options);
        Options options;
        options.take(keywords);
        return DrawingHolder::of_surface(std::move(surface), std::move(options), progress);
      },
      py::arg("formulas"), py::arg("grids"), py::arg("heights"), py::arg("parametric"), py::arg("surface_options"),
      py::arg("options"), py::arg("progress"));
}

}  // namespace ligne::python
