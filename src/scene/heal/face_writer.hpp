#pragma once
/// Writes the faces of a scene anew, one after the other, with their flags and materials.

#include <cstdint>
#include <vector>

#include "scene/clean/cut_nonplanar.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

class FaceWriter {
 public:
  explicit FaceWriter(Scene& scene);

  /// Faces [first, last) of the scene as they stand there.
  void keep(std::uint32_t first, std::uint32_t last);
  /// Another face or triangle in the place of face f.
  void replace(std::uint32_t f, const LooseFace& face);
  void replace(std::uint32_t f, const CutTriangle& triangle);
  /// Tells that what is put in the place of face f follows; faces come in ascending order.
  void begin(std::uint32_t f);
  /// Puts the new faces into the scene, and objects and details on their new numbers. Vertices stay. In an ascending list of
  /// faces those that came from them take their place.
  void finish(std::vector<std::uint32_t>* faces = nullptr);

 private:
  void keep_polygon(std::uint32_t f);
  void add_flags(std::span<const std::uint8_t> flags);
  void add_origins(std::uint32_t first, std::uint32_t last);

  Scene& scene_;
  PolygonFaces faces_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> material_, source_;
  std::vector<std::uint32_t> first_new_;
};

/// Face f of the scene by itself.
LooseFace loose_face(const Scene& scene, std::uint32_t f);

}  // namespace ligne
