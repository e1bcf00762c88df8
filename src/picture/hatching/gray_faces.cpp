#include "picture/hatching/gray_faces.hpp"

#include "view/brightness.hpp"

namespace ligne {

std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const PlotOptions& plot) {
  if (!request.gray_faces) return std::nullopt;
  const double row_mm = kMmPerInch / plot.dpi;
  return SpanLines{row_mm / 2, row_mm, png_size(plot).height};
}

std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot) {
  if (!prepared.request.gray_faces || !(result.spans || result.pixels)) return std::nullopt;
  const PixelSize size = png_size(plot);
  const std::vector<double> brightness = face_brightness(prepared.scene, prepared.view().camera);
  const double pixels_per_mm = plot.dpi / kMmPerInch;
  return result.spans ? shade(*result.spans, brightness, size.width, size.height, pixels_per_mm)
                      : shade(*result.pixels, brightness, size.width, size.height, pixels_per_mm);
}

}  // namespace ligne
