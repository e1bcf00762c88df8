#pragma once
/// Rewrites the faces of a scene, with their flags and materials.

#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "scene/clean/cut_nonplanar.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Records the fate of the faces in ascending order, and copies at the end, array by array in parallel. Faces without a
/// record are dropped.
class FaceWriter {
 public:
  explicit FaceWriter(Scene& scene) : scene_(scene) {}

  /// Keeps the faces [first, last) of the scene.
  void keep(std::uint32_t first, std::uint32_t last);
  /// Replaces face f by another face or triangle; several in a row replace it together.
  void replace(std::uint32_t f, const DetachedFace& face);
  void replace(std::uint32_t f, const CutTriangle& triangle);
  /// Puts the new faces into the scene, and renumbers objects and details. Vertices stay. In `faces`, an ascending
  /// list, each face is replaced by the faces made from it.
  void finish(std::vector<std::uint32_t>* faces = nullptr);

 private:
  /// Faces [first, last) of the scene, or one other face in the place of `first`. Each gives one new face.
  struct Part {
    std::uint32_t first, last;
    std::uint32_t other = kNone;  ///< index among the other faces
  };
  /// Consecutive faces.
  struct Row {
    const PolygonFaces& faces;
    const std::vector<std::uint8_t>& flags;
    std::size_t first, last;
    std::size_t corner() const { return faces.corner_index(first, 0); }
    std::size_t corner_end() const { return faces.corner_index(last, 0); }
  };
  Row row_of(const Part& part) const;

  PolygonFaces faces() const;
  std::vector<std::uint8_t> corner_flags() const;
  std::vector<std::uint32_t> of_origins(const std::vector<std::uint32_t>& values) const;
  std::vector<std::uint32_t> first_new() const;

  Scene& scene_;
  std::vector<Part> parts_;
  PolygonFaces others_;
  std::vector<std::uint8_t> flags_of_others_;  ///< per corner
  std::size_t count_ = 0;                      ///< number of new faces
};

/// Face f as a face outside the scene.
DetachedFace loose_face(const Scene& scene, std::uint32_t f);

}  // namespace ligne
