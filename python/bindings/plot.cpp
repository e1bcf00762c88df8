#include "picture/plot_drawing.hpp"

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "bindings/drawing.hpp"
#include "bindings/values.hpp"
#include "picture/errors.hpp"
#include "picture/parse.hpp"
#include "picture/parse_options.hpp"
#include "picture/parse_plot.hpp"
#include "plotting/output_file.hpp"

#include <pybind11/stl.h>

namespace py = pybind11;

namespace ligne::python {
namespace {

using Setter = std::function<void(PlotDrawingRequest&, const std::string& name, py::handle value)>;

template <class Parser, class Target>
Setter text(Parser parser, Target target, char separator = ',') {
  return [=](PlotDrawingRequest& plot, const std::string& name, py::handle value) {
    target(plot) = parser(text_of(name, value, separator));
  };
}

Setter hatches(void (*add)(FillHatches&, const std::string&)) {
  return [=](PlotDrawingRequest& plot, const std::string& name, py::handle value) {
    for (const std::string& one : texts_of(name, value)) add(plot.hatches, one);
    plot.hatches_given = true;
  };
}

/// True for all fills, or names of layers and colours.
void set_cross(PlotDrawingRequest& plot, const std::string& name, py::handle value) {
  if (!PyBool_Check(value.ptr())) {
    hatches(add_hatch_cross)(plot, name, value);
  } else if (flag_of(name, value)) {
    add_hatch_cross(plot.hatches, "");
    plot.hatches_given = true;
  }
}

const std::map<std::string, Setter, std::less<>>& setters() {
#define LIGNE_FIELD(field) \
  [](PlotDrawingRequest & p) -> auto& { return p.field; }
  static const std::map<std::string, Setter, std::less<>> table{
      {"page", text(parse_page_size, LIGNE_FIELD(page), 'x')},
      {"pen-width", text(parse_pen_width, LIGNE_FIELD(pen_width_mm))},
      {"width",
       [](PlotDrawingRequest& plot, const std::string& name, py::handle value) {
         for (const std::string& one : texts_of(name, value)) {
           for (const auto& [layer, width] : parse_widths(one)) plot.widths_mm[layer] = width;
         }
       }},
      {"scale", text(parse_scale, LIGNE_FIELD(scale))},
      {"skip", text(parse_skip, LIGNE_FIELD(skip))},
      {"fill", text(parse_fill_reading, LIGNE_FIELD(fills))},
      {"min-length", text([](const std::string& t) { return parse_length_mm(t); }, LIGNE_FIELD(plotter.min_length_mm))},
      {"occlude",
       [](PlotDrawingRequest& plot, const std::string& name, py::handle value) { plot.occlude = flag_of(name, value); }},
      {"hatch", hatches([](FillHatches& all, const std::string& tone) { all.all.tone = parse_fill_tone(tone); })},
      {"hatch-spacing", hatches(add_hatch_spacing)},
      {"hatch-angle", hatches(add_hatch_angle)},
      {"hatch-cross", set_cross},
  };
#undef LIGNE_FIELD
  return table;
}

/// The request of the keywords; those that a plot of a scene has too go through `options`.
PlotDrawingRequest plot_request(const py::dict& keywords, Options& options, RunReport& run) {
  PlotDrawingRequest plot;
  py::dict others;
  for_each_option(keywords, [&](const std::string& name, py::handle value) {
    if (const auto setter = setters().find(name); setter != setters().end()) {
      setter->second(plot, name, value);
    } else {
      others[name.c_str()] = value;
    }
  });
  options.take(others);
  plot.landscape = options.picture.page.landscape;
  plot.portrait = options.picture.page.portrait;
  plot.margin_mm = options.picture.page.margin_mm;
  plot.format = options.picture.output.format;
  plot.dpi = options.picture.output.dpi;
  plot.memory = options.picture.memory;
  check(plot);
  options.plotter.request.min_length_mm = plot.plotter.min_length_mm;
  plot.plotter = plotter_request(options.plotter, plot.format, run.files);
  return plot;
}

/// (bytes, report, warnings, times as JSON). `text`: of the drawing, or None: it is read from the file of that name.
py::tuple plot(const std::string& name, const py::object& text, const std::string& file, const py::dict& keywords) {
  RunReport report;
  Options options;
  const PlotDrawingRequest request = plot_request(file.empty() ? keywords : with_format(keywords, file), options, report);
  DrawingText drawing{name, text.is_none() ? std::string() : text.cast<std::string>()};
  Picture picture;
  const bool from_file = text.is_none();
  run(py::none(), options.threads, [&](const Progress&) {
    if (from_file) drawing = read_drawing_text(name, report.files);
    picture = plot_drawing(drawing, request, report);
    if (file.empty()) return;
    OutputFiles files;
    files.add(file, std::move(picture.bytes));
    if (!options.preview.empty()) files.add(options.preview, std::move(picture.preview));
    files.commit();
  });
  py::list warnings;
  for (const RunWarning& warning : report.warnings) {
    warnings.append(warning.place.empty() ? warning.text : warning.place + ": " + warning.text);
  }
  return py::make_tuple(py::bytes(picture.bytes), picture.plotter_report, warnings, report_json(report));
}

}  // namespace

void add_plot(py::module_& module) {
  module.def("plot", &plot, py::arg("name"), py::arg("text"), py::arg("file"), py::arg("options"));
}

}  // namespace ligne::python
