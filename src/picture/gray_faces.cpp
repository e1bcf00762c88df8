#include "picture/gray_faces.hpp"

#include "view/brightness.hpp"

namespace ligne {
namespace {

constexpr double kMmPerInch = 25.4;

}  // namespace

std::optional<SpanLines> gray_face_lines(const PictureRequest& request, const PlotOptions& plot) {
  if (!request.gray_faces) return std::nullopt;
  const double row_mm = kMmPerInch / plot.dpi;
  return SpanLines{row_mm / 2, row_mm, png_size(plot).height};
}

std::optional<GrayPicture> gray_faces(const PreparedScene& prepared, const VisibilityResult& result,
                                      const PlotOptions& plot) {
  if (!prepared.request.gray_faces || !result.spans) return std::nullopt;
  const PixelSize size = png_size(plot);
  return shade(*result.spans, face_brightness(prepared.scene, prepared.view().camera), size.width, size.height,
               plot.dpi / kMmPerInch);
}

}  // namespace ligne
