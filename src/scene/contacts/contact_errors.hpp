#pragma once
/// Recognises faces that cross in the mesh, but only touch in the shape.

#include <array>
#include <cstdint>
#include <span>

#include "scene/contacts/chord_errors.hpp"

namespace ligne {

/// The distances of the faces of a scene from their shapes, and the angles by which these turn over a face.
class ContactErrors {
 public:
  /// `patch_of`: Patches::patch_of. `errors`: those of the faces that will be asked for, and of their neighbours.
  ContactErrors(const Scene& scene, std::span<const std::uint32_t> patch_of, const ChordErrors& errors)
      : scene_(scene), patch_of_(patch_of), errors_(errors) {}

  /// Whether two faces that cross in a segment only touch.
  bool is_contact(const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment) const;

 private:
  struct Turn {
    double angle = 0, error = 0;
  };
  double contact_distance(const std::array<std::uint32_t, 2>& faces) const;
  Turn turn_of(std::uint32_t face) const;

  const Scene& scene_;
  std::span<const std::uint32_t> patch_of_;
  const ChordErrors& errors_;
};

}  // namespace ligne
