#pragma once
/// Asking for memory before it is read. Loops over the faces or edges of a large mesh read what these name from all over
/// its arrays: they wait for memory longer than they compute, unless it is asked for some turns ahead.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// Adjustable: turns of a loop by which memory is asked for in advance.
inline constexpr std::size_t kTurnsAhead = 16;

/// Asks for values[i] for all i of `indices`, which are indices of `values`.
template <class T, class Indices>
void prefetch(const std::vector<T>& values, const Indices& indices) {
  for (const std::uint32_t i : indices) __builtin_prefetch(values.data() + i);
}

/// Asks for what the corners of triangle f + kTurnsAhead name, if there is such a triangle. `corners`: three a triangle.
template <class T>
void prefetch_corners(const std::vector<T>& values, std::span<const std::uint32_t> corners, std::size_t f) {
  const std::size_t k = 3 * (f + kTurnsAhead);
  if (k + 3 <= corners.size()) prefetch(values, corners.subspan(k, 3));
}

/// Asks for what the two faces of edge e + kTurnsAhead have in `of_faces`, if there is such an edge. A face that an edge
/// has not is any number.
template <class T, class Edge>
void prefetch_faces(const std::vector<T>& of_faces, const std::vector<Edge>& edges, std::size_t e) {
  if (e + kTurnsAhead >= edges.size()) return;
  const Edge& edge = edges[e + kTurnsAhead];
  __builtin_prefetch(of_faces.data() + edge.face0);
  if (edge.face1 < of_faces.size()) __builtin_prefetch(of_faces.data() + edge.face1);
}

}  // namespace ligne
