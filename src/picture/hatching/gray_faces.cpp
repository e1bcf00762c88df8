#include "picture/hatching/gray_faces.hpp"

#include <cmath>

#include "drawing/span_areas.hpp"
#include "picture/fills.hpp"
#include "picture/products.hpp"
#include "plotting/hatching/fill_rim.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// Distance of the scan lines of areas, in mm. The strips that they miss are a third of the width of the areas' rims,
/// which cover them.
constexpr double kAreaLinesMm = kFillRimMm / 3;

}  // namespace

std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot) {
  const bool fills = fills_spans(request, method);
  if (!request.gray_faces && !fills) return std::nullopt;
  const auto lines = [](double spacing_mm, double count) {
    return SpanLines{spacing_mm / 2, spacing_mm, static_cast<std::uint32_t>(count)};
  };
  if (request.output.format == OutputFormat::png && !fills) return lines(kMmPerInch / plot.dpi, png_size(plot).height);
  if (!(method.traits().products & kSpans)) return std::nullopt;
  return lines(kAreaLinesMm, std::ceil(plot.page.height_mm / kAreaLinesMm));
}

std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot) {
  const bool png = prepared.request.output.format == OutputFormat::png;
  if (!prepared.request.gray_faces || !(result.pixels || (png && result.spans))) return std::nullopt;
  const std::vector<double> brightness = face_brightness(prepared.scene, prepared.view().camera);
  if (!png) return gray_pixels(*result.pixels, brightness);
  const PixelSize size = png_size(plot);
  const double pixels_per_mm = plot.dpi / kMmPerInch;
  return result.spans ? shade(*result.spans, brightness, size.width, size.height, pixels_per_mm)
                      : shade(*result.pixels, brightness, size.width, size.height, pixels_per_mm);
}

std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result) {
  const PictureRequest& request = prepared.request;
  if (!request.gray_faces || request.output.format == OutputFormat::png || !result.spans) return {};
  return fill_gray(areas_of_spans(*result.spans), face_brightness(prepared.scene, prepared.view().camera));
}

std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result) {
  const std::vector<Region> areas = areas_of_spans(result.spans ? *result.spans : spans_of_pixels(*result.pixels));
  return fill_regions(prepared.scene, prepared.view(), areas, prepared.lights, prepared.request.fill.kind);
}

}  // namespace ligne
