#pragma once
/// Exact numbers and vectors.

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "geometry/point.hpp"

namespace oracle {

/// A rational number. CGAL computes with intervals first, and exactly where these do not decide.
using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;

struct Vector3 {
  Exact x, y, z;
};

inline Vector3 exact(const ligne::Point3& p) { return {Exact(p.x), Exact(p.y), Exact(p.z)}; }
inline Vector3 operator+(const Vector3& a, const Vector3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator*(const Exact& k, const Vector3& a) { return {k * a.x, k * a.y, k * a.z}; }
inline Exact dot(const Vector3& a, const Vector3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline bool is_zero(const Vector3& a) { return a.x == 0 && a.y == 0 && a.z == 0; }

inline double to_double(const Exact& v) { return CGAL::to_double(v); }
inline ligne::Point3 to_point(const Vector3& v) { return {to_double(v.x), to_double(v.y), to_double(v.z)}; }
inline double length(const Vector3& v) { return std::sqrt(to_double(dot(v, v))); }

/// Certain lower and upper bound.
inline double lower(const Exact& v) { return CGAL::to_interval(v).first; }
inline double upper(const Exact& v) { return CGAL::to_interval(v).second; }

}  // namespace oracle
