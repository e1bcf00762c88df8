#include "picture/requests.hpp"

#include "picture/errors.hpp"
#include "picture/hatching/form_hatching.hpp"
#include "picture/hatching/hatching.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/parse/parse_options.hpp"
#include "picture/placement.hpp"
#include "picture/products.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// Name of the option that needs regions.
const char* field_of_regions(const PictureRequest& request) {
  if (!request.fill.lights.empty()) return "light";
  return request.fill.kind != FillKind::none ? "fill" : request.regions ? "regions" : "edges";
}

}  // namespace

void check(const PictureRequest& request) {
  const Method& method = method_of(request);
  if (request.gray_faces) {
    const OutputFormat format = request.output.format;
    if (format == OutputFormat::json) throw RequestError("shade", "a JSON drawing has no grey faces");
    if (request.plotter.by_pens() && format != OutputFormat::png)
      throw RequestError("shade", "pens draw no grey faces; see --hatch");
    if (!(method.traits().products & (kSpans | kPixels))) {
      throw RequestError("shade", "needs a method that gives spans or pixels: " + methods_with(kSpans | kPixels));
    }
  }
  if (fills_smoothly(request)) {
    if (request.output.format == OutputFormat::json)
      throw RequestError("shade-tone", "a JSON drawing has no continuous tone");
    if (!request.fill.lights.empty())
      throw RequestError("shade-tone", "smooth: a continuous tone has no cast shadows, so no --light");
    if (!(method.traits().products & (kSpans | kPixels))) {
      throw RequestError("shade-tone",
                         "smooth: --fill needs a method that gives spans or pixels: " + methods_with(kSpans | kPixels));
    }
  }
  const bool painted = request.output.format == OutputFormat::png || request.output.format == OutputFormat::json;
  if (request.fill.kind != FillKind::none && request.plotter.by_pens() && !painted)
    throw RequestError("fill", "pens draw no filled faces; see --hatch");
  if (request.hatch.is_requested()) {
    if (request.output.format == OutputFormat::json) throw RequestError("hatch", "a JSON drawing has no hatching");
    if (!(method.traits().products & (kRegions | kSpans))) refuse_hatching(method.traits().name);
    if (follows_form(request.hatch) && !(method.traits().products & kRegions))
      throw RequestError("hatch-angle", "curvature and iso need a method that gives regions: " + methods_with(kRegions));
    if (request.gray_faces) throw RequestError("hatch", "can not be combined with --shade");
  }
  if (wants_regions(request, method) && !(method.traits().products & kRegions)) {
    throw RequestError(field_of_regions(request), "needs a method that gives regions: " + methods_with(kRegions));
  }
  if (!request.output.colors.empty()) {
    if (request.output.format == OutputFormat::json) throw RequestError("color", "a JSON drawing has no colours");
    if (request.plotter.by_pens()) throw RequestError("color", "pens set the colours: --pen object:NAME=N,COLOUR");
  }
  check(request.page);
  if (request.output.format == OutputFormat::png) check_png(request.page.size.page, request.output.dpi, request.memory);
}

void choose_method_of_gray_faces(PictureRequest& request) {
  if ((request.gray_faces || fills_smoothly(request)) && !request.lines.method)
    request.lines.method = find_method("watkins");
}

void count_hidden(LineRequest& request) {
  if (!request.most_hiding) return;
  const Method* const counting = find_method("appel");
  if (!request.method) request.method = counting;
  if (request.method != counting)
    throw RequestError("hidden", "only --method appel counts faces, which dashed:N and solid:N need");
  if (!request.settings.has("propagate")) set_parameter(request.settings, *counting, "propagate", "test");
}

}  // namespace ligne
