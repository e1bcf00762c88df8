#include "cli/face_options.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "plotting/page.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

constexpr double kMostHatchLines = 1e6;
constexpr double kMmPerInch = 25.4;

double parse_hatch_distance(const std::string& text) {
  const double mm = parse_length_mm(text);
  if (!(mm > 0)) throw std::invalid_argument("\"" + text + "\" is not a length above zero");
  return mm;
}

}  // namespace

void add_face_options(CLI::App& app, FaceOptions& options) {
  CLI::Option* shade = app.add_flag("--shade", options.shade, "PNG: faces in gray, lit from the eye (methods with spans)");
  CLI::Option* hatch = add_parsed(app, "--hatch", "LEN", options.hatch_mm, parse_hatch_distance,
                                  "hatch the faces, the darkest with lines so far apart (methods with spans)");
  CLI::Option* levels =
      add_parsed(
          app, "--hatch-levels", "N", options.hatch_levels, [](const std::string& text) { return parse_count(text, 1, kMostHatchLevels); },
          "degrees of darkness, 1 to 4")
          ->default_str("4");
  for (CLI::Option* option : {shade, hatch, levels}) option->group("Faces");
}

void check(const FaceOptions& options, OutputFormat format, const Method& method) {
  if (options.shade && options.hatch_mm) throw UsageError("--hatch", "does not go together with --shade");
  if (options.shade && format != OutputFormat::png) throw UsageError("--shade", "gray faces are for PNG; see --hatch");
  if (options.hatch_mm && format == OutputFormat::json) throw UsageError("--hatch", "a JSON drawing has no hatching");
  if (options.wanted() && !(method.traits().products & kSpans)) {
    throw UsageError(options.shade ? "--shade" : "--hatch", "needs a method that gives spans, such as --method watkins");
  }
}

std::optional<SpanLines> span_lines(const FaceOptions& options, const PlotOptions& plot) {
  if (options.shade) {
    const std::uint32_t rows = png_size(plot).height;
    const double row_mm = kMmPerInch / plot.dpi;
    return SpanLines{row_mm / 2, row_mm, rows};
  }
  if (!options.hatch_mm) return std::nullopt;
  const double count = std::ceil(plot.page.height_mm / *options.hatch_mm);
  if (count > kMostHatchLines) throw UsageError("--hatch", "the lines are too close: more than a million on the page");
  return SpanLines{*options.hatch_mm / 2, *options.hatch_mm, static_cast<std::uint32_t>(count)};
}

FacePicture picture_faces(const FaceOptions& options, const Scene& scene, const Camera& camera, const SpanModel& spans, const PlotOptions& plot) {
  FacePicture result;
  if (!options.wanted()) return result;
  const std::vector<double> brightness = face_brightness(scene, camera);
  if (options.shade) {
    const PixelSize size = png_size(plot);
    result.shaded = shade(spans, brightness, size.width, size.height, plot.dpi / kMmPerInch);
  } else {
    result.hatching = hatch(spans, brightness, options.hatch_levels);
  }
  return result;
}

}  // namespace ligne
