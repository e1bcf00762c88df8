#include "picture/products.hpp"

#include "visibility/registry.hpp"

namespace ligne {

const Method& method_of(const PictureRequest& request) {
  if (request.lines.method) return *request.lines.method;
  return needs_regions(request) ? region_method() : default_method();
}

bool needs_regions(const PictureRequest& request) {
  return request.regions || request.fill.is_requested() || request.hatch.is_requested() ||
         request.lines.classes.has(LineClass::shadow);
}

bool shows_materials(const PictureRequest& request) {
  return request.fill.kind == FillKind::material || request.fill.kind == FillKind::shade ||
         request.hatch.kind == HatchKind::material;
}

bool hatches_regions(const PictureRequest& request, const Method& method) {
  return request.hatch.is_requested() && (method.traits().products & kRegions);
}

bool paints_in_order(const PictureRequest& request, const Method& method) {
  const std::uint8_t products = method.traits().products;
  return request.fill.kind != FillKind::none && request.fill.lights.empty() && (products & kOrder) &&
         !fills_smoothly(request);
}

bool fills_smoothly(const PictureRequest& request) {
  return request.fill.kind == FillKind::shade && request.gray_tone == GrayTone::smooth;
}

bool fills_spans(const PictureRequest& request, const Method& method) {
  const std::uint8_t products = method.traits().products;
  return request.fill.kind != FillKind::none && request.fill.lights.empty() && !(products & (kRegions | kOrder)) &&
         (products & (kSpans | kPixels)) && !fills_smoothly(request);
}

bool shows_faces_of_spans(const PictureRequest& request, const Method& method) {
  if (request.output.format == OutputFormat::json) return false;
  return request.gray_faces || fills_smoothly(request) || fills_spans(request, method);
}

std::uint8_t wanted_products(const PictureRequest& request, const Method& method) {
  if (request.output.format == OutputFormat::json) return 0xff & ~kPixels;
  std::uint8_t wanted = kStrokes;
  if (shows_faces_of_spans(request, method)) wanted |= kSpans | kPixels;
  if (wants_regions(request, method)) wanted |= kRegions;
  if (paints_in_order(request, method)) wanted |= kOrder;
  return wanted;
}

bool wants_regions(const PictureRequest& request, const Method& method) {
  return request.regions ||
         (request.fill.is_requested() && !fills_smoothly(request) && !paints_in_order(request, method) &&
          !fills_spans(request, method)) ||
         hatches_regions(request, method) || request.lines.classes.has(LineClass::shadow);
}

}  // namespace ligne
