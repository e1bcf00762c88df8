#pragma once
/// Objects by name: which are kept, and which are moved.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// The name of an object, or "object N" with its number.
std::string object_name(const Object& object, std::size_t number);

/// Whether a pattern as of a shell fits the whole name: * ? [a-z], and \ before a character that is meant itself.
bool name_fits(const std::string& pattern, const std::string& name);

/// Leaves the objects whose entry in `keep` is not 0. Those without a name get that of their number `first_number` + i, so
/// that they keep it.
void keep_objects(Scene& scene, const std::vector<std::uint8_t>& keep, std::size_t first_number);

/// Moves an object, with the details on its faces.
void move_object(Scene& scene, std::size_t object, const Point3& by);

/// The object of each face.
class ObjectOfFace {
 public:
  explicit ObjectOfFace(const Scene& scene);
  /// kNone for kNone.
  std::uint32_t operator()(std::uint32_t face) const;

 private:
  std::vector<std::uint32_t> face_end_;
};

}  // namespace ligne
