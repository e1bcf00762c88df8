#pragma once
/// Selects and moves objects by name.

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// The name of an object, or "object N" with its number.
std::string object_name(const Object& object, std::size_t number);

/// Whether a shell pattern matches the whole name: * ? [a-z], and \ before a character to be taken literally.
bool name_fits(const std::string& pattern, const std::string& name);

/// Keeps only the objects whose entry in `keep` is not 0. Objects without a name are named by their number
/// `first_number` + i, so that the number stays.
void keep_objects(Scene& scene, const std::vector<std::uint8_t>& keep, std::size_t first_number);

/// Moves an object, with the details on its faces.
void move_object(Scene& scene, std::size_t object, const Point3& by);

/// The object of each face.
class ObjectOfFace {
 public:
  explicit ObjectOfFace(const Scene& scene);
  /// The object of the face; kNone for kNone.
  std::uint32_t operator()(std::uint32_t face) const;

 private:
  std::vector<std::uint32_t> face_end_;
};

}  // namespace ligne
