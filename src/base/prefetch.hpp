#pragma once
/// Prefetching of memory. A loop over the faces or edges of a large mesh reads vertices or faces from all over an
/// array. It waits for memory longer than it computes, unless it prefetches some iterations ahead. The functions are always
/// inlined: GCC removes calls of functions that do nothing but prefetch.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ligne {

/// Number of loop iterations between the prefetch of an element and its use. Adjustable.
inline constexpr std::size_t kTurnsAhead = 16;

/// Prefetches values[i] for all i in `indices`, which must be valid indices.
template <class T, class Indices>
[[gnu::always_inline]] inline void prefetch(const std::vector<T>& values, const Indices& indices) {
  for (const std::uint32_t i : indices) __builtin_prefetch(values.data() + i);
}

/// Prefetches the values of the three corners of triangle f + kTurnsAhead, if there is such a triangle. `corners` holds
/// three indices into `values` per triangle.
template <class T>
[[gnu::always_inline]] inline void prefetch_corners(const std::vector<T>& values, std::span<const std::uint32_t> corners,
                                                    std::size_t f) {
  const std::size_t k = 3 * (f + kTurnsAhead);
  if (k + 3 <= corners.size()) prefetch(values, corners.subspan(k, 3));
}

/// Prefetches the values of the two faces of edge e + kTurnsAhead, if there is such an edge. `of_faces` has one value
/// per face. `face1` may be any number that is not a face, if the edge has one face only.
template <class T, class Edge>
[[gnu::always_inline]] inline void prefetch_faces(const std::vector<T>& of_faces, const std::vector<Edge>& edges,
                                                  std::size_t e) {
  if (e + kTurnsAhead >= edges.size()) return;
  const Edge& edge = edges[e + kTurnsAhead];
  __builtin_prefetch(of_faces.data() + edge.face0);
  if (edge.face1 < of_faces.size()) __builtin_prefetch(of_faces.data() + edge.face1);
}

}  // namespace ligne
