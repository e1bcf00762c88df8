#include "picture/hatching/painted_faces.hpp"

#include <array>
#include <cmath>

#include "picture/fills.hpp"
#include "picture/hatching/smooth_tones.hpp"
#include "picture/products.hpp"
#include "picture/raster/span_areas.hpp"
#include "plotting/page.hpp"
#include "view/brightness.hpp"

namespace ligne {
namespace {

/// Distance of the scan lines of areas, in mm. The strips that they miss are a third of the width of the areas' rims,
/// which cover them.
constexpr double kAreaLinesMm = kFillRimMm / 3;

/// Whether the picture has faces of continuous tone, gray or in colour.
bool is_smooth(const PictureRequest& request) {
  return (request.gray_faces && request.gray_tone == GrayTone::smooth) || fills_smoothly(request);
}

/// The transparent faces that the spans or pixels were found with.
const TransparentLayers& layers_of(const VisibilityResult& result) {
  return result.spans ? result.spans->layers : result.pixels->layers;
}

/// An image of the spans or pixels, with the pixels of the page in PNG and where there are spans, else with those of the
/// method.
template <std::size_t N>
FacePicture image_of(const PreparedScene& prepared, const VisibilityResult& result, const PlotOptions& plot, ColorAt<N> at) {
  const bool png = prepared.request.output.format == OutputFormat::png;
  const PixelSize size = png_size(plot);
  const double pixels_per_mm = plot.dpi / kMmPerInch;
  if (!result.spans && !png) return paint_each<N>(*result.pixels, at);
  if (!result.spans) return paint<N>(*result.pixels, at, size.width, size.height, pixels_per_mm);
  FacePicture picture = paint<N>(*result.spans, at, size.width, size.height, pixels_per_mm);
  if (!png) picture.pixel_mm = 1 / pixels_per_mm;
  return picture;
}

/// An image in gray. tone_of(face, page_mm) is the tone of a face.
template <class ToneOf>
FacePicture gray_image(const PreparedScene& prepared, const VisibilityResult& result, const PlotOptions& plot,
                       ToneOf tone_of) {
  const Scene& scene = prepared.scene;
  const auto opacity_of = [&](std::uint32_t face) { return material_of(scene, face).opacity; };
  return image_of<1>(prepared, result, plot, [&](SeenFace seen, Point2 page_mm) {
    const auto of_face = [&](std::uint32_t face) { return std::array{tone_of(face, page_mm)}; };
    return seen_color<1>(layers_of(result), seen, of_face, opacity_of);
  });
}

/// An image in lit colours of continuous tone.
FacePicture color_image(const PreparedScene& prepared, const VisibilityResult& result, const PlotOptions& plot) {
  const Scene& scene = prepared.scene;
  const SmoothFillColors colors(scene, prepared.view().camera, prepared.lights);
  const auto opacity_of = [&](std::uint32_t face) { return material_of(scene, face).opacity; };
  return image_of<3>(prepared, result, plot, [&](SeenFace seen, Point2 page_mm) {
    const auto of_face = [&](std::uint32_t face) { return colors.of(face, prepared.tones->surface_at(face, page_mm)); };
    return seen_color<3>(layers_of(result), seen, of_face, opacity_of);
  });
}

}  // namespace

std::optional<SpanLines> painted_lines(const PictureRequest& request, const Method& method, const PlotOptions& plot) {
  const bool fills = fills_spans(request, method), smooth = is_smooth(request);
  if (!request.gray_faces && !fills && !smooth) return std::nullopt;
  const auto lines = [](double spacing_mm, double count) {
    return SpanLines{spacing_mm / 2, spacing_mm, static_cast<std::uint32_t>(count)};
  };
  const bool rows = request.output.format == OutputFormat::png || (smooth && (method.traits().products & kSpans));
  if (rows && !fills) return lines(kMmPerInch / plot.dpi, png_size(plot).height);
  if (!(method.traits().products & kSpans)) return std::nullopt;
  return lines(kAreaLinesMm, std::ceil(plot.page.height_mm / kAreaLinesMm));
}

void prepare_tones(PreparedScene& prepared) {
  if (is_smooth(prepared.request)) prepared.tones = std::make_shared<SmoothTones>(prepared);
}

std::optional<FacePicture> face_picture(const PreparedScene& prepared, const VisibilityResult& result,
                                        const PlotOptions& plot) {
  const PictureRequest& request = prepared.request;
  const bool png = request.output.format == OutputFormat::png, smooth = is_smooth(request);
  if (!(request.gray_faces || smooth) || !(result.pixels || ((png || smooth) && result.spans))) return std::nullopt;
  if (fills_smoothly(request)) return color_image(prepared, result, plot);
  if (smooth) {
    return gray_image(prepared, result, plot,
                      [&](std::uint32_t face, Point2 page_mm) { return prepared.tones->at(face, page_mm); });
  }
  const std::vector<double> brightness = face_brightness(prepared.scene, prepared.view().camera);
  return gray_image(prepared, result, plot, [&](std::uint32_t face, Point2) { return brightness[face]; });
}

std::vector<Fill> gray_areas(const PreparedScene& prepared, const VisibilityResult& result) {
  const PictureRequest& request = prepared.request;
  if (!request.gray_faces || is_smooth(request) || request.output.format == OutputFormat::png || !result.spans) return {};
  return fill_gray(prepared.scene, areas_of_spans(*result.spans), result.spans->layers,
                   face_brightness(prepared.scene, prepared.view().camera));
}

std::vector<Fill> filled_spans(const PreparedScene& prepared, const VisibilityResult& result) {
  const std::vector<Region> areas = areas_of_spans(result.spans ? *result.spans : spans_of_pixels(*result.pixels));
  return fill_areas(prepared.scene, prepared.view(), areas, layers_of(result), prepared.lights, prepared.request.fill.kind);
}

}  // namespace ligne
