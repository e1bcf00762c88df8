#pragma once
/// Fields of curvature on the smooth surfaces of a scene, whose zero sets are shape lines.
///
/// Curvatures are dimensionless: they are multiplied by the size of their object, the diagonal of its bounding box.
/// They are positive where the surface bends away from its normal, as on a sphere.

#include <array>
#include <cstdint>
#include <vector>

#include "contours/surfaces/smooth_patch.hpp"
#include "scene/form/curvature.hpp"

namespace ligne {

struct ShapeFields {
  FormMesh mesh;
  std::vector<TangentFrame> frames;  ///< per node, like all following members
  std::vector<Point3> normals;       ///< smoothed
  /// The curvature in the direction (cos a, sin a) of the frame is mean + Re(conj(difference) exp(2 i a)).
  std::vector<double> mean;
  std::vector<Complex> difference;
  std::vector<double> size;  ///< size of the object, model units
  /// +1 if the normal points out of a closed body, -1 if it points inwards, 0 if the surface is open.
  std::vector<int> outward;

  /// Gradients at the nodes of a function given at the nodes, multiplied by the size of the object.
  std::vector<Point3> slopes(const std::vector<double>& values) const;
  /// Gradient within a triangle of the function with these values at its corners.
  Point3 slope(std::uint32_t triangle, const std::array<double, 3>& values) const;
};

/// Computes and smooths the curvature of all smooth regions of a scene.
ShapeFields shape_fields(const Scene& scene, const Topology& topology, const RegionBorders& borders);

/// A field whose zeros are ridges or valleys.
struct ExtremumField {
  std::vector<double> value;      ///< derivative of the curvature along `way`
  std::vector<Point3> way;        ///< principal direction; its sign is arbitrary
  std::vector<double> curvature;  ///< principal curvature; not positive if the other has a larger absolute value
};

/// The field of ridges (`sign` 1: extrema of the larger principal curvature along its direction) or of valleys (`sign`
/// -1: of the smaller one with the opposite sign, as if the surface were turned inside out) [OhtakeBelyaevSeidel2004].
ExtremumField extremum_field(const ShapeFields& fields, int sign);

/// The radial curvature, whose zeros are suggestive contours: the normal curvature in the direction of the view vector
/// projected onto the tangent plane [DeCarloFinkelsteinRusinkiewiczSantella2003].
struct RadialField {
  std::vector<double> value;  ///< with respect to the normal
  /// Derivative of the radial curvature towards the viewer, with respect to one side of the surface: the outer side of
  /// a closed body, the visible side of an open sheet. Zero if that side faces away, or if the view vector is too close
  /// to the normal.
  std::vector<double> growth;
};
/// Computes the radial curvature for a camera.
RadialField radial_field(const ShapeFields& fields, const Camera& camera);

}  // namespace ligne
