#include "picture/raster/zbuffer_picture.hpp"

#include <utility>

#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/placement.hpp"
#include "scene/readers/reader.hpp"
#include "visibility/zbuffer/kept_buffer.hpp"

namespace ligne {
namespace {

/// The place that the request alone would have.
ZBufferPlace place_of(const PictureRequest& request, const Scene& scene) {
  ZBufferPlace place;
  const CameraPicture picture = picture_of(request.view, request.page, scene);
  place.camera = picture.camera;
  place.extent = picture.extent;
  place.page = page_for(request.page, place.extent);
  place.scale = request.page.scale;
  place.unit_mm = request.page.unit_mm;
  return place;
}

void put(const ZBufferPlace& place, PictureRequest& request) {
  request.view = {};
  request.view.made = place.camera;
  request.page.extent = place.extent;
  request.page.size = {place.page, true};
  request.page.landscape = request.page.portrait = false;
  request.page.margin_mm = place.page.margin_mm;
  request.page.scale = place.scale;
  request.page.unit_mm = place.unit_mm;
}

}  // namespace

Scene ZBuffer::joined(Scene added) const {
  if (empty()) return added;
  Scene all = scene_;
  append_scene(all, std::move(added));
  all.up_axis = scene_.up_axis;
  all.unit_mm = scene_.unit_mm;
  return all;
}

Picture ZBuffer::add(Scene scene, const PictureRequest& request, RunReport& run) {
  return draw(joined(std::move(scene)), request, run);
}

Picture ZBuffer::draw(Scene joined, PictureRequest request, RunReport& run) {
  check(request.page);
  const ZBufferPlace place = place_ ? *place_ : place_of(request, joined);
  put(place, request);
  request.keep = Keep::for_more_objects;
  request.earlier = buffer_;
  Picture picture;
  {
    const DrawnScene drawn = draw_lines(joined, std::move(request), run);
    auto kept = std::dynamic_pointer_cast<const zbuffer::KeptBuffer>(drawn.visibility().result.kept);
    if (!kept) throw RequestError("method", "has no depth buffer; use --method zbuffer");
    buffer_ = std::move(kept);
    picture = drawn.write(run);
  }
  place_ = place;
  scene_ = std::move(joined);
  return picture;
}

void require_no_place(const PictureRequest& request, const std::string& what) {
  const ViewRequest& view = request.view;
  const auto refuse = [&](bool given, const char* field) {
    if (given) throw RequestError(field, "can not be changed after " + what + " was drawn");
  };
  refuse(view.named_view || view.camera, "view");
  refuse(view.direction.has_value(), "direction");
  refuse(view.eye.has_value(), "eye");
  refuse(view.up.has_value(), "up");
  refuse(view.up_axis.has_value(), "up-axis");
  const PageRequest standard, &page = request.page;
  refuse(page.size.page.width_mm != standard.size.page.width_mm || page.size.page.height_mm != standard.size.page.height_mm,
         "page");
  refuse(page.landscape, "landscape");
  refuse(page.portrait, "portrait");
  refuse(page.margin_mm != standard.margin_mm, "margin");
  refuse(page.scale.has_value(), "scale");
  refuse(page.unit_mm.has_value(), "unit");
  for (const char* name : {"lines", "depth-bits"}) refuse(request.lines.settings.has(name), name);
}

}  // namespace ligne
