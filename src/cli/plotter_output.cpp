#include "cli/plotter_output.hpp"

#include <cmath>
#include <cstdio>
#include <optional>

#include "files/message_text.hpp"
#include "plotting/plot_writers.hpp"

namespace ligne {
namespace {

std::string written_as(OutputFormat format, const Drawing& drawing, const PlotOptions& style, const GrayPicture* under) {
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
  std::size_t pens;
};

void print_report(const ReportRow& before, const ReportRow& after, const Device* device) {
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
    if (device) text += padded(minutes(plot_seconds(*device, row->lengths, row->pens)), kColumn);
    text += "\n";
  }
  std::fputs(text.c_str(), stderr);
}

std::string written_by_layers(const Drawing& drawing, const PlotOptions& style, const PlotterSetup& setup,
                              OutputFormat format, RunFiles& files, RunReport& run, const GrayPicture* under) {
  const PlotterOptions& options = setup.options;
  const PathOptions paths{setup.optimize(), options.tolerances, {}};
  if (paths.optimize == Optimize::off && !options.report && options.preview.empty())
    return written_as(format, drawing, style, under);
  const Drawing better = timed(run.stages, "paths", [&] { return optimize_layers(drawing, paths); });
  if (options.report)
    print_report({"before", measure(drawing, {}, false), 0}, {"after", measure(better, {}, false), 0}, nullptr);
  if (!options.preview.empty()) {
    PlotRequest request{style, {}, true, {Optimize::off, {}, {}}};
    files.write(options.preview, write_preview(deal_to_pens(better, request), {}, false));
  }
  return written_as(format, better, style, under);
}

}  // namespace

std::string written(const Drawing& drawing, const PlotOptions& style, const PlotterSetup& setup, OutputFormat format,
                    RunFiles& files, RunReport& run, const GrayPicture* under) {
  if (!setup.by_pens()) return written_by_layers(drawing, style, setup, format, files, run, under);
  const PlotterOptions& options = setup.options;
  const Device* device = setup.device.get();
  PlotRequest request{
      style, setup.pens, device && device->language == DeviceLanguage::svg, {setup.optimize(), options.tolerances, {}}};

  const Plot before = deal_to_pens(drawing, request);
  std::optional<DeviceFrame> frame;
  if (device) {
    frame = place_on_device(*device, style.page, ink_of(before), options.fit_device);
    request.paths.order.home = frame->to_page({0, 0});
    request.paths.order.returns = device->returns;
  }
  const OrderOptions& order = request.paths.order;
  Plot plot = timed(run.stages, "paths", [&] { return make_plot(drawing, request); });
  if (options.report) {
    print_report({"before", measure(before, order.home, order.returns), before.pens.size()},
                 {"after", measure(plot, order.home, order.returns), plot.pens.size()}, device);
  }
  if (!options.preview.empty()) files.write(options.preview, write_preview(plot, order.home, order.returns));
  if (format == OutputFormat::hpgl || format == OutputFormat::gcode) return write_plot(plot, *device, *frame);
  if (frame && options.fit_device) {
    for (PenLines& pen : plot.pens) {
      for (Point2& p : pen.lines.points) p = frame->fitted(p);
    }
  }
  PlotOptions by_pen = style;
  by_pen.style = styles_of(plot);
  return written_as(format, drawing_of(plot), by_pen, under);
}

}  // namespace ligne
