#pragma once
/// Curvature of the smooth surfaces of a scene, as lines of the shape need it.
///
/// Curvatures are told in terms of the size of their object (the diagonal of the box round it): they are those of the
/// object made 1 large. They are positive where the surface bends away from its normal, as on a sphere.

#include <array>
#include <cstdint>
#include <vector>

#include "contours/surfaces/smooth_patch.hpp"
#include "scene/form/curvature.hpp"

namespace ligne {

struct ShapeFields {
  FormMesh mesh;
  std::vector<TangentFrame> frames;  ///< of nodes, as all that follows
  std::vector<Point3> normals;       ///< evened out
  /// The curvature in the direction (cos a, sin a) of the frame is mean + Re(conj(difference) exp(2 i a)).
  std::vector<double> mean;
  std::vector<Complex> difference;
  std::vector<double> size;  ///< of the object, model units
  /// +1 where the normal points out of a closed body, -1 where it points in, 0 where the surface is open.
  std::vector<int> outward;

  /// The change of a function of the nodes along the surface, times the size of the object.
  std::vector<Point3> slopes(const std::vector<double>& values) const;
  /// The slope within a triangle, for the values at its corners.
  Point3 slope(std::uint32_t triangle, const std::array<double, 3>& values) const;
};

ShapeFields shape_fields(const Scene& scene, const Topology& topology, const RegionBorders& borders);

/// A field whose zeros are ridges or valleys.
struct ExtremumField {
  std::vector<double> value;      ///< slope of the curvature along `way`
  std::vector<Point3> way;        ///< direction of that curvature; either of two that are opposite
  std::vector<double> curvature;  ///< not positive where it is not the one that bends the surface most
};

/// For extrema of the larger principal curvature along its direction (`sign` 1), or of the smaller one (-1), which is then
/// taken with the opposite sign, as if the surface were turned inside out [OhtakeBelyaevSeidel2004].
ExtremumField extremum_field(const ShapeFields& fields, int sign);

/// For zeros of the radial curvature: that in the direction in which the sight lies over the surface
/// [DeCarloFinkelsteinRusinkiewiczSantella2003].
struct RadialField {
  std::vector<double> value;  ///< as the normal has it
  /// Change of the radial curvature towards the viewer, as the side has it that counts: of a closed body the outer one, of a
  /// sheet the one that is seen. Zero where that side looks away, or the sight is too steep.
  std::vector<double> growth;
};
RadialField radial_field(const ShapeFields& fields, const Camera& camera);

}  // namespace ligne
