#pragma once
/// Curvature of smooth surfaces at the nodes of their triangles, and smoothing of node values over the surface.
///
/// The second fundamental form of a triangle fits the change of the normals along its sides; that of a node is the mean
/// over its triangles [Rusinkiewicz2004]. It is positive where the surface bends away from its normal.

#include <array>
#include <complex>
#include <cstdint>
#include <vector>

#include "scene/form/form_mesh.hpp"

namespace ligne {

using Complex = std::complex<double>;

/// Perpendicular unit vectors of a tangent plane; zero if there is no normal.
struct TangentFrame {
  Point3 x{0, 0, 0}, y{0, 0, 0};
};

/// Frames of the nodes, from their normals.
std::vector<TangentFrame> tangent_frames(const FormMesh& mesh);

/// Neighbouring nodes i < j; each pair occurs once.
struct FormLink {
  std::uint32_t i, j;
  double weight;
  double angle;  ///< angle from the frame of j to that of i, radians
};

std::vector<FormLink> form_links(const FormMesh& mesh, const std::vector<TangentFrame>& frames);

/// Smooths values of nodes: returns the z that minimise sum weight_i abs(z_i - wanted_i)^2 + length^2 sum w
/// abs(z_i - turn^symmetry z_j)^2. `symmetry` is the rotational symmetry of values that turn with the frames, and 0 for
/// others.
std::vector<Complex> evened(const std::vector<double>& weights, const std::vector<Complex>& wanted,
                            const std::vector<FormLink>& links, double length, int symmetry);

/// Normals without bumps smaller than `length`.
std::vector<Point3> evened_normals(const FormMesh& mesh, const std::vector<FormLink>& links, double length);

/// e, f, g in the frame of a node. The curvature in the direction (cos a, sin a) is e cos^2 + 2 f cos sin + g sin^2.
using SecondForm = std::array<double, 3>;

std::vector<SecondForm> second_forms(const FormMesh& mesh, const std::vector<TangentFrame>& frames,
                                     const std::vector<Point3>& normals);

}  // namespace ligne
