#include "picture/pages/plot_drawing.hpp"

#include <functional>
#include <map>
#include <stdexcept>
#include <utility>

#include "bindings/drawing.hpp"
#include "bindings/scene.hpp"
#include "bindings/values.hpp"
#include "picture/errors.hpp"
#include "picture/pages/frames.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/parse/parse_plot.hpp"
#include "plotting/writers/output_file.hpp"
#include "report/run_json.hpp"

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
      {"strict", [](PlotDrawingRequest& plot, const std::string& name,
                    py::handle value) { plot.reading.strict = flag_of(name, value); }},
      {"input-dpi", text(parse_dpi, LIGNE_FIELD(reading.px_per_inch))},
      {"fill", [](PlotDrawingRequest& request, const std::string& name,
                  py::handle value) { parse_plot_fill(text_of(name, value), request.fills, request.paint); }},
      {"material",
       [](PlotDrawingRequest& plot, const std::string& name, py::handle value) {
         for (const std::string& one : texts_of(name, value)) parse_material(one, plot.paint);
       }},
      {"min-length", text([](const std::string& t) { return parse_length_mm(t); }, LIGNE_FIELD(plotter.min_length_mm))},
      {"occlude",
       [](PlotDrawingRequest& plot, const std::string& name, py::handle value) {
         plot.own_layer = !PyBool_Check(value.ptr()) && parse_own_layer(text_of(name, value));
         plot.occlude = !PyBool_Check(value.ptr()) || flag_of(name, value);
       }},
      {"hatch", hatches([](FillHatches& all, const std::string& tone) { all.all.tone = parse_fill_tone(tone); })},
      {"hatch-spacing", hatches(add_hatch_spacing)},
      {"hatch-angle", hatches(add_hatch_angle)},
      {"hatch-cross", set_cross},
      {"split", text(parse_split, LIGNE_FIELD(plotter.parts.split))},
      {"from-stroke", text(parse_stroke_number, LIGNE_FIELD(plotter.parts.from_stroke))},
      {"from-time", text(parse_duration_s, LIGNE_FIELD(plotter.parts.from_seconds))},
      {"every", text(parse_drawn_length_mm, LIGNE_FIELD(plotter.parts.every_mm))},
      {"do", text(parse_file_name, LIGNE_FIELD(plotter.parts.action))},
      {"park", text(parse_file_name, LIGNE_FIELD(plotter.parts.park))},
      {"tile", text(parse_page_size, LIGNE_FIELD(tile), 'x')},
      {"overlap", text(parse_min_length, LIGNE_FIELD(overlap_mm))},
      {"grid", text(parse_grid, LIGNE_FIELD(grid), 'x')},
  };
#undef LIGNE_FIELD
  return table;
}

/// Returns the request of the keywords; `options` handles those that a plot of a scene also has.
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
  options.plotter.request.min_length_mm = plot.plotter.min_length_mm;
  options.plotter.request.parts = plot.plotter.parts;
  plot.plotter = plotter_request(options.plotter, plot.format, run.files);
  plot.curves = options.picture.output.curves.value_or(false);
  check(plot);
  if (plot.plotter.parts.every_mm.has_value() == plot.plotter.parts.action.empty())
    throw RequestError("every", "needs do, the name of an action");
  return plot;
}

/// Returns (files, report, warnings, times as JSON). Drawings are (name, text), or (name, None) to read the file of
/// that name. Files are (name, bytes) without a file name, and (name, None) after they are written.
py::tuple plot(const std::vector<std::pair<std::string, std::optional<std::string>>>& drawings, const std::string& file,
               const py::dict& keywords) {
  RunReport report;
  Options options;
  PlotDrawingRequest request = plot_request(file.empty() ? keywords : with_format(keywords, file), options, report);
  // Without a file name the caller gets all files.
  const bool numbered = file.empty() || has_number_place(file);
  request.plotter.parts.split_files = numbered;
  request.plotter.parts.pen_files = has_number_place(file, 'p');
  if (request.tile && !numbered && request.format != OutputFormat::pdf)
    throw RequestError("file", "several sheets need a number in the file name, such as name%d, or a PDF");
  Picture picture;
  run(py::none(), options.threads, [&](const Progress&) {
    std::vector<DrawingText> texts;
    for (const auto& [name, text] : drawings)
      texts.push_back(text ? DrawingText{name, *text} : read_drawing_text(name, report.files));
    refuse_inputs(report.files, "file", file);
    refuse_inputs(report.files, "preview", options.preview);
    picture = plot_drawings(texts, request, !file.empty() && numbered, report);
    if (picture.parts.empty()) picture.parts.push_back({std::move(picture.bytes), 0, 0});
    if (file.empty()) return;
    OutputFiles files;
    for (PicturePart& part : picture.parts) files.add(name_of(file, part), std::exchange(part.bytes, {}));
    if (!options.preview.empty()) files.add(options.preview, std::move(picture.preview));
    files.commit();
  });
  py::list files, warnings;
  for (const PicturePart& part : picture.parts) files.append(py::make_tuple(name_of(file, part), py::bytes(part.bytes)));
  for (const RunWarning& warning : report.warnings) {
    warnings.append(warning.place.empty() ? warning.text : warning.place + ": " + warning.text);
  }
  return py::make_tuple(files, picture.plotter_report, warnings, report_json(report));
}

}  // namespace

void add_plot(py::module_& module) { module.def("plot", &plot, py::arg("drawings"), py::arg("file"), py::arg("options")); }

}  // namespace ligne::python
