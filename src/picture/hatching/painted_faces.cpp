#include "picture/hatching/gray_faces.hpp"

#include <cmath>

#include "drawing/span_areas.hpp"
#include "picture/fills.hpp"
#include "picture/hatching/smooth_tones.hpp"
#include "picture/products.hpp"
#include "plotting/hatching/fill_rim.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// Distance of the scan lines of areas, in mm. The strips that they miss are a third of the width of the areas' rims,
/// which cover them.
constexpr double kAreaLinesMm = kFillRimMm / 3;

bool is_smooth(const PictureRequest& request) { return request.gray_faces && request.gray_tone == GrayTone::smooth; }

}  // namespace

std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot) {
  const bool fills = fills_spans(request, method);
  if (!request.gray_faces && !fills) return std::nullopt;
  const auto lines = [](double spacing_mm, double count) {
    return SpanLines{spacing_mm / 2, spacing_mm, static_cast<std::uint32_t>(count)};
  };
  const bool rows =
      request.output.format == OutputFormat::png || (is_smooth(request) && (method.traits().products & kSpans));
  if (rows && !fills) return lines(kMmPerInch / plot.dpi, png_size(plot).height);
  if (!(method.traits().products & kSpans)) return std::nullopt;
  return lines(kAreaLinesMm, std::ceil(plot.page.height_mm / kAreaLinesMm));
}

void prepare_tones(PreparedScene& prepared) {
  if (is_smooth(prepared.request)) prepared.tones = std::make_shared<SmoothTones>(prepared);
}

/// Gray faces of continuous tone: pixels of the page, of vector files too where the method has spans.
static GrayPicture smooth_gray(const PreparedScene& prepared, const VisibilityResult& result, const PlotOptions& plot) {
  const auto tone = [&](std::uint32_t face, Point2 page_mm) { return prepared.tones->at(face, page_mm); };
  const bool png = prepared.request.output.format == OutputFormat::png;
  if (!png && !result.spans) return gray_pixels(*result.pixels, tone);
  const PixelSize size = png_size(plot);
  const double pixels_per_mm = plot.dpi / kMmPerInch;
  if (!result.spans) return shade(*result.pixels, tone, size.width, size.height, pixels_per_mm);
  GrayPicture picture = shade(*result.spans, tone, size.width, size.height, pixels_per_mm);
  if (!png) picture.pixel_mm = 1 / pixels_per_mm;
  return picture;
}

std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot) {
  const bool png = prepared.request.output.format == OutputFormat::png;
  const bool smooth = is_smooth(prepared.request);
  if (!prepared.request.gray_faces || !(result.pixels || ((png || smooth) && result.spans))) return std::nullopt;
  if (smooth) return smooth_gray(prepared, result, plot);
  const std::vector<double> brightness = face_brightness(prepared.scene, prepared.view().camera);
  if (!png) return gray_pixels(*result.pixels, brightness);
  const PixelSize size = png_size(plot);
  const double pixels_per_mm = plot.dpi / kMmPerInch;
  return result.spans ? shade(*result.spans, brightness, size.width, size.height, pixels_per_mm)
                      : shade(*result.pixels, brightness, size.width, size.height, pixels_per_mm);
}

std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result) {
  const PictureRequest& request = prepared.request;
  if (!request.gray_faces || is_smooth(request) || request.output.format == OutputFormat::png || !result.spans) return {};
  return fill_gray(areas_of_spans(*result.spans), face_brightness(prepared.scene, prepared.view().camera));
}

std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result) {
  const std::vector<Region> areas = areas_of_spans(result.spans ? *result.spans : spans_of_pixels(*result.pixels));
  return fill_regions(prepared.scene, prepared.view(), areas, prepared.lights, prepared.request.fill.kind);
}

}  // namespace ligne
