#include "picture/raster/zbuffer_picture.hpp"

#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "files/checksummed_file.hpp"
#include "picture/draw_scene.hpp"
#include "picture/errors.hpp"
#include "picture/placement.hpp"
#include "scene/readers/reader.hpp"
#include "scene/readers/scene_bytes.hpp"
#include "visibility/zbuffer/kept_buffer.hpp"

namespace ligne {
namespace {

constexpr ChecksummedFormat kZBufferFile{"ligne-zbuf\r\n", 1, "a depth buffer", "draw it again"};

void write_point(ByteWriter& bytes, const Point3& p) {
  for (int k = 0; k < 3; ++k) bytes.number(p[k]);
}

double read_number(ByteReader& bytes) {
  const auto value = bytes.number<double>();
  bytes.need(std::isfinite(value), "a number is not finite");
  bytes.need(std::abs(value) <= kLargestCoordinate, "a number is too large to compute with");
  return value;
}

Point3 read_point(ByteReader& bytes) {
  const double x = read_number(bytes), y = read_number(bytes), z = read_number(bytes);
  return {x, y, z};
}

/// 0 stands for no value.
double number_of(const std::optional<double>& value) { return value.value_or(0); }

std::optional<double> read_positive(ByteReader& bytes) {
  const double value = read_number(bytes);
  bytes.need(value >= 0, "a scale is negative");
  return value > 0 ? std::optional(value) : std::nullopt;
}

void write_camera(ByteWriter& bytes, const Camera& camera) {
  bytes.number(static_cast<std::uint8_t>(camera.perspective));
  for (const Point3& p : {camera.eye, camera.right, camera.down, camera.forward}) write_point(bytes, p);
  for (const double value : {camera.fov_degrees, camera.target_distance, camera.aspect}) bytes.number(value);
}

Camera read_camera(ByteReader& bytes) {
  Camera camera;
  const auto perspective = bytes.number<std::uint8_t>();
  bytes.need(perspective <= 1, "the camera has an unknown kind");
  camera.perspective = perspective == 1;
  camera.eye = read_point(bytes);
  for (Point3* axis : {&camera.right, &camera.down, &camera.forward}) *axis = read_point(bytes);
  // Largest rounding error of a computed dot product of orthogonal unit vectors.
  constexpr double kRounding = 0x1p-40;
  const auto is = [](double value, double wanted) { return std::abs(value - wanted) <= kRounding; };
  const Point3 &r = camera.right, &d = camera.down, &f = camera.forward;
  bytes.need(is(glm::dot(r, r), 1) && is(glm::dot(d, d), 1) && is(glm::dot(f, f), 1) && is(glm::dot(r, d), 0) &&
                 is(glm::dot(r, f), 0) && is(glm::dot(d, f), 0),
             "the camera has no frame");
  camera.fov_degrees = read_number(bytes);
  camera.target_distance = read_number(bytes);
  camera.aspect = read_number(bytes);
  bytes.need(camera.fov_degrees > 0 && camera.fov_degrees < 180 && camera.target_distance > 0 && camera.aspect > 0,
             "the camera has no field of view");
  return camera;
}

void write_place(ByteWriter& bytes, const ZBufferPlace& place) {
  write_camera(bytes, place.camera);
  for (const Point2& p : {place.extent.min, place.extent.max}) {
    bytes.number(p.x);
    bytes.number(p.y);
  }
  for (const double value : {place.page.width_mm, place.page.height_mm, place.page.margin_mm}) bytes.number(value);
  bytes.number(number_of(place.scale));
  bytes.number(number_of(place.unit_mm));
}

ZBufferPlace read_place(ByteReader& bytes) {
  ZBufferPlace place;
  place.camera = read_camera(bytes);
  for (Point2* p : {&place.extent.min, &place.extent.max}) {
    p->x = read_number(bytes);
    p->y = read_number(bytes);
  }
  for (double* value : {&place.page.width_mm, &place.page.height_mm, &place.page.margin_mm}) *value = read_number(bytes);
  const Page& page = place.page;
  bytes.need(page.width_mm > 0 && page.height_mm > 0 && page.width_mm <= kLargestPageMm &&
                 page.height_mm <= kLargestPageMm && page.margin_mm >= 0 && page.drawable().width() > 0 &&
                 page.drawable().height() > 0,
             "the page has no area");
  place.scale = read_positive(bytes);
  place.unit_mm = read_positive(bytes);
  return place;
}

View view_of(const ZBufferPlace& place, const Scene& scene) {
  PageRequest page;
  page.size = {place.page, true};
  page.margin_mm = place.page.margin_mm;
  page.scale = place.scale;
  page.unit_mm = place.unit_mm;
  return ligne::place({place.camera, place.extent, scene.unit_mm}, page).view;
}

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

std::string ZBuffer::write() const {
  ByteWriter writer;
  write_scene(writer, scene_);
  write_place(writer, *place_);
  buffer_->write(writer);
  return checksummed_file(kZBufferFile, writer.bytes());
}

void write_checksum_of_zbuffer(std::string& bytes) { write_checksum(kZBufferFile, bytes); }

ZBuffer ZBuffer::read(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader reader = open_checksummed(kZBufferFile, bytes, name);
  ZBuffer result;
  result.scene_ = read_scene(reader);
  reader.need(!result.scene_.objects.empty(), "there is no object");
  result.place_ = read_place(reader);
  const View view = view_of(*result.place_, result.scene_);
  reader.need(std::isfinite(view.scale) && view.scale > 0, "the picture has no scale");
  result.buffer_ = zbuffer::KeptBuffer::read(reader, view, static_cast<std::uint32_t>(result.scene_.faces.size()));
  reader.need(reader.left() == 0, "there are bytes after the buffer");
  return result;
}

}  // namespace ligne
