#include "picture/write_picture.hpp"

#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "plotting/plot_writers.hpp"

namespace ligne {
namespace {

std::string written_as(OutputFormat format, const Drawing& drawing, const PlotOptions& style, const GrayPicture* under,
                       PdfDocument* pages) {
  if (pages) {
    pages->add_page(drawing, style);
    return {};
  }
  return format == OutputFormat::pdf   ? write_pdf(drawing, style)
         : format == OutputFormat::png ? write_png(drawing, style, under)
                                       : write_svg(drawing, style);
}

std::string padded(std::string text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string metres(double mm) {
  constexpr double kMmPerMetre = 1000;
  char text[64];
  std::snprintf(text, sizeof text, "%.3f m", mm / kMmPerMetre);
  return text;
}

/// The speeds and times of a device are bounded so that these seconds fit (plotting/device_reader.cpp).
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

std::string report_of(const ReportRow& before, const ReportRow& after, const Device* device) {
  constexpr std::size_t kColumn = 12;
  std::string text = padded("", 8);
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

Picture write_by_layers(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter, OutputFormat format,
                        RunReport& run, const GrayPicture* under, PdfDocument* pages) {
  const PathOptions paths{plotter.path_work(), plotter.tolerances, {}, {}};
  if (paths.optimize == Optimize::off && !plotter.report && !plotter.preview) {
    return {written_as(format, drawing, style, under, pages)};
  }
  const Drawing better = timed(run.stages, "paths", [&] { return optimize_layers(drawing, paths); });
  Picture picture;
  if (plotter.report) {
    picture.plotter_report =
        report_of({"before", measure(drawing, {}, false), 0}, {"after", measure(better, {}, false), 0}, nullptr);
  }
  if (plotter.preview) {
    const PlotRequest request{style, {}, true, false, {Optimize::off, {}, {}, {}}};
    picture.preview = write_preview(deal_to_pens(better, request), {}, false);
  }
  picture.bytes = written_as(format, better, style, under, pages);
  return picture;
}

Picture write_by_pens(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter, OutputFormat format,
                      RunReport& run, const GrayPicture* under, PdfDocument* pages) {
  const Device* device = plotter.device.get();
  const bool picture_of_pens = format != OutputFormat::hpgl && format != OutputFormat::gcode;
  PlotRequest request{style,
                      plotter.pens,
                      picture_of_pens && device,
                      picture_of_pens,
                      {plotter.path_work(), plotter.tolerances, {}, device ? pace_of(*device) : PathPace{}}};
  request.paths.tolerances.lift_mm = request.paths.pace.lift_mm();
  const Plot before = deal_to_pens(drawing, request);
  std::optional<DeviceFrame> frame;
  OrderOptions& order = request.paths.order;
  if (device) {
    frame = place_on_device(*device, style.page, ink_of(before), plotter.fit_device);
    order.home = frame->to_page({0, 0});
    order.returns = device->returns;
  }
  Plot plot = timed(run.stages, "paths", [&] { return make_plot(drawing, request); });
  Picture picture;
  if (plotter.report) {
    picture.plotter_report = report_of({"before", measure(before, order.home, order.returns), pen_changes(before)},
                                       {"after", measure(plot, order.home, order.returns), pen_changes(plot)}, device);
  }
  if (plotter.preview) picture.preview = write_preview(plot, order.home, order.returns);
  if (!picture_of_pens) {
    picture.bytes = write_plot(plot, *device, *frame);
    return picture;
  }
  if (frame && plotter.fit_device) {
    for (PenLines& pen : plot.pens) {
      for (Point2& p : pen.lines.points) p = frame->fitted(p);
    }
  }
  PlotOptions by_pen = style;
  by_pen.style = styles_of(plot);
  by_pen.curves = false;  // the way of the pen is measured and simplified along its points
  picture.bytes = written_as(format, drawing_of(plot), by_pen, under, pages);
  return picture;
}

}  // namespace

PlotOptions plot_options(const PictureRequest& request, const Page& page) {
  PlotOptions plot;
  plot.page = page;
  plot.pen_width_mm = request.page.pen_width_mm;
  plot.widths_mm = request.page.widths_mm;
  plot.hidden_solid = request.lines.hidden == HiddenLines::solid;
  plot.title = request.output.title;
  plot.dpi = request.output.dpi;
  plot.curves = request.output.curves.value_or(request.lines.quality == Quality::clear);
  return plot;
}

void check_png(const Page& page, double dpi, const MemoryLimit& memory) {
  PlotOptions options;
  options.page = page;
  options.dpi = dpi;
  PixelSize size;
  try {
    size = png_size(options);
  } catch (const std::runtime_error& e) {
    throw RequestError("dpi", e.what());
  }
  memory.require(png_bytes(size), {"write", std::to_string(size.width) + " x " + std::to_string(size.height) + " pixels"});
}

Picture write_picture(const Drawing& drawing, const PlotOptions& style, const PlotterRequest& plotter, OutputFormat format,
                      RunReport& run, const GrayPicture* under, PdfDocument* pages) {
  return plotter.by_pens() ? write_by_pens(drawing, style, plotter, format, run, under, pages)
                           : write_by_layers(drawing, style, plotter, format, run, under, pages);
}

}  // namespace ligne
