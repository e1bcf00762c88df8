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
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_terrain.hpp"

namespace py = pybind11;

namespace ligne::python {
namespace {

constexpr std::string_view kUndersideNames[] = {"same", "apart", "none"}, kHiddenByNames[] = {"surface", "curves"},
                           kHorizonNames[] = {"exact", "pixels"}, kAxesStyleNames[] = {"back", "grid", "box", "base"},
                           kTextStyleNames[] = {"font", "stroke"};
constexpr unsigned kMost = 1'000'000, kResolution = 2000, kMostBands = 65'535;
constexpr double kHighestTextMm = 1000;

using Setter = std::function<void(SurfaceRequest&, const std::string& name, py::handle value)>;

template <class Parser, class Target>
Setter text(Parser parser, Target target, char separator = ',') {
  return [=](SurfaceRequest& surface, const std::string& name, py::handle value) {
    target(surface) = parser(text_of(name, value, separator));
  };
}

/// A sequence of ranges, or a single range.
Setter ranges(std::vector<CurveRange> SurfaceRequest::*target) {
  return [=](SurfaceRequest& surface, const std::string& name, py::handle value) {
    const bool several = py::isinstance<py::list>(value);
    if (!several) (surface.*target).push_back(parse_range(text_of(name, value, ':')));
    if (several) {
      for (const py::handle one : value) (surface.*target).push_back(parse_range(text_of(name, one, ':')));
    }
  };
}

/// An option with an optional value: True, or a number.
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

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> values(const Numbers& array) { return {array.data(), array.data() + array.size()}; }

using Heights = std::tuple<std::string, Numbers, Numbers, Numbers>;

using Texts = std::vector<std::string>;

const std::map<std::string, Setter, std::less<>>& setters() {
#define LIGNE_FIELD(field) \
  [](SurfaceRequest & s) -> auto& { return s.field; }
  static const std::map<std::string, Setter, std::less<>> table{
      {"formulas", [](SurfaceRequest& s, const std::string&, py::handle value) { s.formulas = value.cast<Texts>(); }},
      {"grids", [](SurfaceRequest& s, const std::string&, py::handle value) { s.grids = value.cast<Texts>(); }},
      {"parametric", [](SurfaceRequest& s, const std::string&,
                        py::handle value) { s.parametric = value.cast<std::vector<std::array<std::string, 3>>>(); }},
      {"heights",
       [](SurfaceRequest& s, const std::string&, py::handle value) {
         for (const auto& [name, x, y, z] : value.cast<std::vector<Heights>>())
           s.heights.push_back({name, values(x), values(y), values(z)});
       }},
      {"x", text(parse_range, LIGNE_FIELD(x), ':')},
      {"y", text(parse_range, LIGNE_FIELD(y), ':')},
      {"u", ranges(&SurfaceRequest::u)},
      {"v", ranges(&SurfaceRequest::v)},
      {"samples", text([](const std::string& t) { return parse_count(t, 2, kMost); }, LIGNE_FIELD(samples))},
      {"every", text(parse_every, LIGNE_FIELD(every))},
      {"gridded", text([](const std::string& t) { return parse_count(t, 2, kMostCurves); }, LIGNE_FIELD(gridded))},
      {"using", text(parse_columns, LIGNE_FIELD(using_columns), ':')},
      {"index", text([](const std::string& t) { return parse_count(t, 0, kMostDataSets); }, LIGNE_FIELD(data_set))},
      {"layout", text(parse_layout, LIGNE_FIELD(layout))},
      {"band", text([](const std::string& t) { return parse_count(t, 1, kMostBands); }, LIGNE_FIELD(band))},
      {"ground", text(parse_ground, LIGNE_FIELD(ground))},
      {"max-slope", text(parse_positive, LIGNE_FIELD(max_slope))},
      {"aspect", text(parse_aspect, LIGNE_FIELD(aspect), ':')},
      {"exaggeration", text(parse_positive, LIGNE_FIELD(exaggeration))},
      {"lines", text([](const std::string& t) { return static_cast<CurveFamilies>(parse_choice(t, kCurveFamilyNames)); },
                     LIGNE_FIELD(lines))},
      {"azimuth", text(parse_number, LIGNE_FIELD(azimuth_degrees))},
      {"elevation",
       text([](const std::string& t) { return parse_within(t, -90, 90, "degrees"); }, LIGNE_FIELD(elevation_degrees))},
      {"z-scale", text(parse_positive, LIGNE_FIELD(z_scale))},
      {"log-x", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[0] = flag_of(name, value); }},
      {"log-y", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[1] = flag_of(name, value); }},
      {"log-z", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.log_axes[2] = flag_of(name, value); }},
      {"z-range", text(parse_heights, LIGNE_FIELD(z_range), ':')},
      {"skirt", flag_or_value(LIGNE_FIELD(skirt), LIGNE_FIELD(skirt_base))},
      {"horizon",
       [](SurfaceRequest& s, const std::string& name, py::handle value) {
         if (parse_choice(text_of(name, value), kHorizonNames) == 1) s.pixel_columns = s.pixel_columns.value_or(kResolution);
       }},
      {"resolution", text(count, LIGNE_FIELD(pixel_columns))},
      {"contours", [](SurfaceRequest& s, const std::string& name,
                      py::handle value) { parse_contours(text_of(name, value) + (is_sequence(value) ? "," : ""), s.curves); }},
      {"contour-step", text(parse_positive, LIGNE_FIELD(curves.contour_step))},
      {"contours-base", flag_or_value(LIGNE_FIELD(curves.contours_base), LIGNE_FIELD(curves.contour_base))},
      {"outline",
       text([](const std::string& t) { return parse_choice(t, kSwitchNames) == 1; }, LIGNE_FIELD(curves.outline))},
      {"underside", text([](const std::string& t) { return static_cast<Underside>(parse_choice(t, kUndersideNames)); },
                         LIGNE_FIELD(curves.underside))},
      {"hidden-by", text([](const std::string& t) { return static_cast<HiddenBy>(parse_choice(t, kHiddenByNames)); },
                         LIGNE_FIELD(curves.hidden_by))},
      {"ridgeline", flag_or_value(LIGNE_FIELD(curves.ridgeline), LIGNE_FIELD(curves.ridgeline_overlap))},
      {"axes", set_axes},
      {"x-label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[0]))},
      {"y-label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[1]))},
      {"z-label", text([](const std::string& t) { return t; }, LIGNE_FIELD(picture.axes.names[2]))},
      {"text", text([](const std::string& t) { return static_cast<TextStyle>(parse_choice(t, kTextStyleNames)); },
                    LIGNE_FIELD(picture.axes.text))},
      {"text-height", text(parse_text_height, LIGNE_FIELD(picture.axes.text_height_mm))},
      {"contour-labels",
       [](SurfaceRequest& s, const std::string& name, py::handle value) {
         if (PyBool_Check(value.ptr()) && !value.cast<bool>()) return;
         s.curves.labels = parse_contour_labels(PyBool_Check(value.ptr()) ? std::string() : text_of(name, value));
       }},
      {"index-contours", text(parse_index_contours, LIGNE_FIELD(curves.index_contours))},
      {"water",
       [](SurfaceRequest& s, const std::string& name, py::handle value) { parse_water(text_of(name, value), s.terrain); }},
      {"water-fill", text(parse_water_fill, LIGNE_FIELD(terrain.water_fill))},
      {"hachures", text(parse_hachures, LIGNE_FIELD(terrain.hachures))},
      {"hachure-spacing", text(parse_hatch_spacing, LIGNE_FIELD(terrain.hachure_mm))},
      {"sun", [](SurfaceRequest& s, const std::string& name,
                 py::handle value) { parse_sun(text_of(name, value, ':'), s.terrain); }},
      {"scale-bar",
       [](SurfaceRequest& s, const std::string& name, py::handle value) {
         const bool alone = PyBool_Check(value.ptr());
         s.picture.axes.scale_bar = !alone || value.cast<bool>();
         if (!alone) s.picture.axes.scale_unit = text_of(name, value);
       }},
      {"north-arrow", [](SurfaceRequest& s, const std::string& name,
                         py::handle value) { s.picture.axes.north_arrow = flag_of(name, value); }},
      {"curve",
       [](SurfaceRequest& s, const std::string&, py::handle value) {
         for (const py::handle one : value) s.space_curves.push_back(one.cast<SpaceCurve>());
       }},
      {"t", ranges(&SurfaceRequest::t)},
      {"points",
       [](SurfaceRequest& s, const std::string&, py::handle value) {
         for (const py::handle one : value) s.point_files.push_back(py::str(one));
       }},
      {"path",
       [](SurfaceRequest& s, const std::string&, py::handle value) {
         for (const py::handle one : value) s.line_files.push_back(py::str(one));
       }},
      {"colors", text(parse_colors, LIGNE_FIELD(colors))},
      {"bands", text(parse_bands, LIGNE_FIELD(bands))},
      {"legend", [](SurfaceRequest& s, const std::string& name, py::handle value) { s.legend = flag_of(name, value); }},
      {"name",
       [](SurfaceRequest& s, const std::string&, py::handle value) {
         for (const py::handle one : value) s.names.push_back(py::str(one));
       }},
      {"x-names", text(parse_words, LIGNE_FIELD(picture.axes.categories[0]))},
      {"y-names", text(parse_words, LIGNE_FIELD(picture.axes.categories[1]))},
      {"z-names", text(parse_words, LIGNE_FIELD(picture.axes.categories[2]))},
  };
#undef LIGNE_FIELD
  return table;
}

}  // namespace

SurfaceRequest surface_request(const py::dict& keywords) {
  SurfaceRequest surface;
  bool pixels_asked = false;
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    pixels_asked |= name == "horizon";
    const auto setter = setters().find(name);
    if (setter == setters().end()) throw RequestError(name, "there is no such option");
    setter->second(surface, name, value);
  });
  if (surface.pixel_columns && !pixels_asked) throw RequestError("resolution", "needs horizon=\"pixels\"");
  return surface;
}

std::vector<std::string_view> names_of_surface_options() {
  std::vector<std::string_view> names;
  for (const auto& [name, setter] : setters()) names.push_back(name);
  return names;
}

void add_surface(py::module_& module) {
  module.def(
      "surface",
      [](const py::dict& surface, const py::dict& keywords, const py::object& progress) {
        Options options;
        options.take(keywords, names_of_surface_options());
        return DrawingHolder::of_surface(surface_request(surface), std::move(options), progress);
      },
      py::arg("surface"), py::arg("options"), py::arg("progress"));
}

}  // namespace ligne::python
