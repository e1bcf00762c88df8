#pragma once
/// Writes the faces of a scene anew, with their flags and materials.

#include <cstdint>
#include <span>
#include <vector>

#include "base/no_index.hpp"
#include "scene/clean/cut_nonplanar.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// Takes down what becomes of the faces, in ascending order, and copies at the end, array by array in parallel. Faces of
/// which nothing is said are left out.
class FaceWriter {
 public:
  explicit FaceWriter(Scene& scene) : scene_(scene) {}

  /// Faces [first, last) of the scene as they stand there.
  void keep(std::uint32_t first, std::uint32_t last);
  /// Another face or triangle in the place of face f; several take its place one after the other.
  void replace(std::uint32_t f, const LooseFace& face);
  void replace(std::uint32_t f, const CutTriangle& triangle);
  /// Puts the new faces into the scene, and objects and details on their new numbers. Vertices stay. In an ascending list of
  /// faces those that came from them take their place.
  void finish(std::vector<std::uint32_t>* faces = nullptr);

 private:
  /// Faces [first, last) of the scene, or one other face in the place of `first`. Each face gives one new one.
  struct Part {
    std::uint32_t first, last;
    std::uint32_t other = kNone;  ///< number among the other faces
  };
  /// Faces in a row.
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
  std::size_t count_ = 0;                      ///< of new faces
};

/// Face f of the scene by itself.
LooseFace loose_face(const Scene& scene, std::uint32_t f);

}  // namespace ligne
