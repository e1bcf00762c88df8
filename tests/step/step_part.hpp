#pragma once
/// Parts of STEP files, read with OpenCASCADE: meshes of them, and the true lines that their surfaces and edges give.

#include "clear/true_comparison.hpp"

namespace ligne::test {

/// How near a mesh is to its surfaces.
struct MeshAccuracy {
  double chord_mm = 0;   ///< between a facet and its surface
  double angle_rad = 0;  ///< between the normals of neighbouring facets

  bool operator==(const MeshAccuracy&) const = default;
};

/// Keeps the last mesh that was made.
class StepPart {
 public:
  /// Reads a STEP file. Throws std::runtime_error if that fails or if there are no faces in it.
  explicit StepPart(const std::filesystem::path& file);

  std::vector<std::array<Point3, 3>> mesh(const MeshAccuracy& accuracy) const;

  /// Wanted are edges whose sides meet at 10 degrees or more or bend differently, and outlines; others are edges between
  /// sides that go on alike. `step`: millimetres of the part between samples. Normals of surfaces tell where an outline
  /// crosses the facets of a mesh of `accuracy`.
  KnownLines lines(const Viewer& viewer, double step, const MeshAccuracy& accuracy) const;

 private:
  struct Shape;
  std::shared_ptr<Shape> shape_;
};

}  // namespace ligne::test
