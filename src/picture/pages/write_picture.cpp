#include "picture/pages/write_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <optional>
#include <stdexcept>
#include <utility>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/pages/named_layers.hpp"
#include "plotting/plot.hpp"

namespace ligne {
namespace {

std::string written_as(OutputFormat format, const Drawing& drawing, const PlotOptions& style, const FacePicture* under,
                       PdfDocument* pages) {
  if (pages) {
    pages->add_page(drawing, style, under);
    return {};
  }
  return format == OutputFormat::pdf   ? write_pdf(drawing, style, under)
         : format == OutputFormat::png ? write_png(drawing, style, under)
                                       : write_svg(drawing, style, under);
}

std::string padded(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string metres(double mm) {
  constexpr double kMmPerMetre = 1000;
  char text[64];
  std::snprintf(text, sizeof text, "%.3f m", mm / kMmPerMetre);
  return text;
}

/// The scale of a reduced drawing, as text.
std::string scale_text(double scale) {
  char text[64];
  std::snprintf(text, sizeof text, "%.4f", scale);
  return text;
}

/// Minutes and seconds. plotting/devices/device_reader.cpp bounds the speeds and times of devices so that these seconds
/// fit.
std::string minutes(double seconds) {
  const auto whole = std::llround(seconds);
  char text[64];
  std::snprintf(text, sizeof text, "%lld:%02lld min", whole / 60, whole % 60);
  return text;
}

struct ReportRow {
  const char* name;
  PathLengths lengths;
  std::size_t pen_changes;
};

std::string report_of(const ReportRow& before, const ReportRow& after, const Device* device, double scale = 1) {
  constexpr std::size_t kColumn = 12;
  std::string text;
  if (scale < 1) text = "drawn at " + scale_text(scale) + " of its size, which fits " + printable(device->name) + "\n";
  text += padded("", 8);
  for (const char* head : {"strokes", "down", "up", "lifts"}) text += padded(head, kColumn);
  if (device) text += padded("time", kColumn) + "  (" + printable(device->name) + ")";
  text += "\n";
  for (const ReportRow* row : {&before, &after}) {
    std::string name = row->name;
    name.resize(8, ' ');
    text += name + padded(std::to_string(row->lengths.strokes), kColumn) + padded(metres(row->lengths.down_mm), kColumn) +
            padded(metres(row->lengths.up_mm), kColumn) + padded(std::to_string(row->lengths.strokes), kColumn);
    if (device) text += padded(minutes(plot_seconds(*device, row->lengths, row->pen_changes)), kColumn);
    text += "\n";
  }
  return text;
}

Picture write_by_layers(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter,
                        const PictureFile& file, RunReport& run) {
  const auto [format, under, pages] = file;
  const PathOptions paths{plotter.path_work(), plotter.tolerances, {}, plotter.min_length_mm, {}};
  if (paths.optimize == Optimize::off && !(paths.min_length_mm > 0) && !plotter.report && !plotter.preview) {
    return {written_as(format, drawing, style, under, pages)};
  }
  const Drawing better = timed(run.stages, "paths", [&] { return optimize_layers(drawing, paths); });
  Picture picture;
  if (plotter.report) {
    picture.plotter_report =
        report_of({"before", measure(drawing, {}, false), 0}, {"after", measure(better, {}, false), 0}, nullptr);
  }
  if (plotter.preview) {
    const PlotRequest request{style, {}, true, false, {Optimize::off, {}, {}, 0, {}}};
    picture.preview = write_preview(assign_pens(better, request), {}, false);
  }
  picture.bytes = written_as(format, better, style, under, pages);
  return picture;
}

/// Finds the device's action and place for stops. Throws RequestError for one that the device does not have.
PlotStops stops_of(const PlotterRequest& plotter) {
  const LongPlotRequest& parts = plotter.parts;
  PlotStops stops;
  if (!plotter.device) return stops;
  const Device& device = *plotter.device;
  const auto refuse = [&](const char* option, const char* what, const std::string& name, const auto& there) {
    std::string list;
    for (const auto& one : there) list += (list.empty() ? "" : ", ") + printable(one.name);
    throw RequestError(option, "device " + printable(device.name) + " has no " + what + " " + shown(name, '"') + "; " +
                                   (list.empty() ? "it has none" : "it has " + list));
  };
  if (parts.every_mm) {
    stops.action = find_action(device, parts.action);
    if (!stops.action) refuse("do", "action", parts.action, device.actions);
  }
  if (!parts.park.empty()) {
    stops.park = find_place(device, parts.park);
    if (!stops.park) refuse("park", "place", parts.park, device.places);
  }
  if (parts.split && !parts.split_files && !find_action(device, "pause")) {
    refuse("split", "action", "pause", device.actions);
  }
  return stops;
}

/// Throws RequestError for options that need a device or a plotter language.
void check_parts(const PlotterRequest& plotter) {
  const LongPlotRequest& parts = plotter.parts;
  const bool timed = parts.from_seconds > 0 || (parts.split && parts.split->by == SplitBy::time);
  if (timed && !plotter.device)
    throw RequestError(parts.from_seconds > 0 ? "from-time" : "split", "a time needs a --device");
  const bool machine = plotter.device && plotter.device->language != DeviceLanguage::svg;
  if (parts.every_mm && !machine) throw RequestError("every", "works for HPGL and G-code only");
  if (!parts.park.empty() && !machine) throw RequestError("park", "works for HPGL and G-code only");
  if (parts.split && !parts.split_files && !machine)
    throw RequestError("split", "several files need a number in the file name: -o name%d.svg");
  stops_of(plotter);
}

/// Throws RequestError if no stroke remains after the strokes that are left out.
void check_first(const Plot& plot, const LongPlotRequest& request, std::size_t first) {
  const std::size_t strokes = stroke_count(plot);
  if (strokes == 0 || first < strokes) return;
  const std::string whole = "the plot has " + std::to_string(strokes) + (strokes == 1 ? " stroke" : " strokes");
  if (request.from_stroke > strokes) throw RequestError("from-stroke", whole);
  throw RequestError("from-time", whole + ", all drawn by then");
}

/// Writes the rest of the plot in its parts.
void write_parts(Plot plot, const PlotterRequest& plotter, Point2 home, const std::function<std::string(Plot)>& bytes_of,
                 Picture& picture) {
  const LongPlotRequest& request = plotter.parts;
  const Device* device = plotter.device.get();
  std::size_t first = request.from_stroke - 1;
  if (request.from_seconds > 0) first = std::max(first, strokes_within(plot, *device, home, request.from_seconds));
  if (first > 0) {
    check_first(plot, request, first);
    plot = without_first(plot, first);
    if (plotter.report) picture.plotter_report += "begins with stroke " + std::to_string(first + 1) + "\n";
  }
  std::vector<Plot> parts;
  if (request.split) {
    parts = split_plot(plot, *request.split, device, home);
  } else {
    parts.push_back(std::move(plot));
  }
  const bool files = request.split && request.split_files;
  if (request.split && plotter.report) picture.plotter_report += std::to_string(parts.size()) + " parts\n";
  if (!files && parts.size() > 1) parts = {with_pauses(parts)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const unsigned number = files ? static_cast<unsigned>(i + 1) : 0;
    std::vector<std::pair<unsigned, Plot>> of_pens;
    if (request.pen_files) {
      of_pens = plots_of_pens(parts[i]);
    } else {
      of_pens.emplace_back(0, std::move(parts[i]));
    }
    for (auto& [pen, part] : of_pens) {
      if (request.every_mm) part = with_actions(part, *request.every_mm);
      std::string bytes = bytes_of(std::move(part));
      if (number == 0 && pen == 0) {
        picture.bytes = std::move(bytes);
      } else {
        picture.parts.push_back({std::move(bytes), number, pen});
      }
    }
  }
}

/// Warns if the page is larger than every paper of the device. The drawing is then fitted to the largest paper.
void warn_of_paper(const Device& device, const DeviceFrame& frame, const Page& page, RunReport& run) {
  if (!frame.paper) return;
  const auto [low, high] = std::minmax(page.width_mm, page.height_mm);
  const auto [paper_low, paper_high] = std::minmax(frame.paper->width_mm, frame.paper->height_mm);
  constexpr double kSameSizeMm = 1;
  if (low <= paper_low + kSameSizeMm && high <= paper_high + kSameSizeMm) return;
  run.warnings.push_back({"", "no paper of " + printable(device.name) + " holds a page of " + rounded(page.width_mm) +
                                  " x " + rounded(page.height_mm) + " mm: the drawing is made for " +
                                  printable(frame.paper->name)});
}

Picture write_by_pens(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter,
                      const PictureFile& file, RunReport& run) {
  const Device* device = plotter.device.get();
  const bool picture_of_pens = file.format != OutputFormat::hpgl && file.format != OutputFormat::gcode;
  PlotRequest request{
      style,
      plotter.pens,
      picture_of_pens && device,
      picture_of_pens,
      {plotter.path_work(), plotter.tolerances, {}, plotter.min_length_mm, device ? pace_of(*device) : PathPace{}}};
  check_pens(plotter.asked_pens, drawing);
  check_parts(plotter);
  const Plot before = assign_pens(drawing, request);
  const bool fits = plotter.fit_device || plotter.fit_drawing;
  std::optional<DeviceFrame> frame;
  OrderOptions& order = request.paths.order;
  if (device) {
    frame = place_on_device(*device, style.page, drawn_bounds(before), fits);
    if (frame->scale < 1 && !plotter.fit_drawing) {
      run.warnings.push_back({"", "the drawing is scaled down to " + scale_text(frame->scale) +
                                      " of the requested size to fit " + printable(device->name)});
    }
    warn_of_paper(*device, *frame, style.page, run);
    order.home = frame->to_page({0, 0});
    order.returns = device->returns;
    order.inside_first = device->inside_first;
  }
  Plot plot = timed(run.stages, "paths", [&] { return make_plot(drawing, request); });
  Picture picture;
  if (plotter.report) {
    picture.plotter_report = report_of({"before", measure_in_turn(before, order.home, order.returns), pen_changes(before)},
                                       {"after", measure_in_turn(plot, order.home, order.returns), pen_changes(plot)},
                                       device, frame && !plotter.fit_drawing ? frame->scale : 1);
  }
  if (plotter.preview) picture.preview = write_preview(plot, order.home, order.returns);
  const auto bytes_of = [&](Plot part) {
    if (!picture_of_pens) return write_plot(part, *device, *frame, stops_of(plotter));
    if (frame && fits) {
      for (PenLines& pen : part.pens) {
        for (Point2& p : pen.lines.points) p = frame->fitted(p);
      }
    }
    PlotOptions by_pen = style;
    by_pen.style = styles_of(part);
    // Otherwise the curves would not follow the planned path of the pen.
    by_pen.curves = style.curves && style.starts_stay;
    return written_as(file.format, drawing_of(part), by_pen, file.under, file.pages);
  };
  write_parts(std::move(plot), plotter, order.home, bytes_of, picture);
  return picture;
}

/// Warns of a page larger than 200 inches. PDF leaves it to viewers whether they show it (PDF 1.7, annex C.2), and many
/// do not. A larger unit (/UserUnit) would need an interface that Cairo does not have.
void warn_of_size(const Page& page, RunReport& run) {
  constexpr double kLargestPdfMm = 200 * kMmPerInch;
  if (std::max(page.width_mm, page.height_mm) <= kLargestPdfMm) return;
  const std::string text = "a page of " + shortest(page.width_mm) + " x " + shortest(page.height_mm) +
                           " mm is larger than the 14400 points (5080 mm) that readers of PDF show; write an SVG, which "
                           "ligne plot --tile A0 cuts into pages";
  if (std::ranges::find(run.warnings, text, &RunWarning::text) == run.warnings.end()) run.warn(text);
}

}  // namespace

PlotOptions plot_options(const PictureRequest& request, const Page& page) {
  return {.page = page,
          .pen_width_mm = request.page.pen_width_mm,
          .widths_mm = request.page.widths_mm,
          .hidden_solid = request.lines.hidden == HiddenLines::solid,
          .title = request.output.title,
          .dpi = request.output.dpi,
          .curves = request.output.curves.value_or(request.lines.quality == Quality::clear)};
}

void check_png(const Page& page, double dpi, const MemoryLimit& memory) {
  PlotOptions options{.page = page, .dpi = dpi};
  PixelSize size;
  try {
    size = png_size(options);
  } catch (const std::runtime_error& e) {
    throw RequestError("dpi", e.what());
  }
  memory.require(png_bytes(size), {"write", std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels"});
}

Picture write_picture(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter,
                      const PictureFile& file, RunReport& run) {
  if (plotter.parts.is_requested() && !plotter.by_pens())
    throw RequestError("", "--split, --every, --from-stroke, --from-time, --park and %p need pens or a --device");
  if (file.format == OutputFormat::pdf) warn_of_size(style.page, run);
  return plotter.by_pens() ? write_by_pens(drawing, style, plotter, file, run)
                           : write_by_layers(drawing, style, plotter, file, run);
}

}  // namespace ligne
