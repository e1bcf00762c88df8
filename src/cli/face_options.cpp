#include "cli/face_options.hpp"

#include "cli/option_helpers.hpp"
#include "cli/parse.hpp"
#include "plotting/page.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

constexpr double kMmPerInch = 25.4;

}  // namespace

void add_face_options(CLI::App& app, FaceOptions& options) {
  app.add_flag("--shade", options.shade, "PNG: faces in gray, lit from the eye (methods with spans)")->group("Faces");
}

void check(const FaceOptions& options, OutputFormat format, const Method& method) {
  if (!options.shade) return;
  if (format != OutputFormat::png) throw UsageError("--shade", "gray faces are for PNG; see --hatch");
  if (!(method.traits().products & kSpans))
    throw UsageError("--shade", "needs a method that gives spans, such as --method watkins");
}

std::optional<SpanLines> span_lines(const FaceOptions& options, const PlotOptions& plot) {
  if (!options.shade) return std::nullopt;
  const double row_mm = kMmPerInch / plot.dpi;
  return SpanLines{row_mm / 2, row_mm, png_size(plot).height};
}

GrayPicture picture_faces(const Scene& scene, const Camera& camera, const SpanModel& spans, const PlotOptions& plot) {
  const PixelSize size = png_size(plot);
  return shade(spans, face_brightness(scene, camera), size.width, size.height, plot.dpi / kMmPerInch);
}

}  // namespace ligne
