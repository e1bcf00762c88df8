// Within an object: each face sets a bit chosen by a hash of its corners, one of 64 at its lowest vertex, so that
// neighbours use near memory. Faces that share a bit set one of many other bits; faces that share that too go into a
// hash table by their key. So a mesh without duplicates costs two short passes over its faces.
//
// Between objects: objects that may coincide have equal sums of position hashes. Each is described by its sorted
// positions and by its sorted face keys in terms of these, and compared with the first of its kind.

#include "scene/heal/duplicate_faces.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "base/hash.hpp"
#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/compact.hpp"
#include "scene/heal/face_writer.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// A key that is equal for faces with equal contours.

/// Start of the least rotation of a cyclic word (Shiloach 1981: two candidates are compared; the one that loses at its
/// letter k can not begin before k + 1).
std::size_t least_rotation(std::span<const std::uint32_t> word) {
  const std::size_t n = word.size();
  std::size_t i = 0, j = 1, k = 0;
  while (i < n && j < n && k < n) {
    const std::uint32_t a = word[(i + k) % n], b = word[(j + k) % n];
    if (a == b) {
      ++k;
      continue;
    }
    (a > b ? i : j) += k + 1;
    if (i == j) ++j;
    k = 0;
  }
  return std::min(i, j);
}

/// Replaces a cyclic contour by its least word, read in either direction.
void make_canonical(std::vector<std::uint32_t>& contour) {
  if (contour.size() == 3) {  // rotations and reversal give all orders of three
    std::sort(contour.begin(), contour.end());
    return;
  }
  const auto rotate = [](std::vector<std::uint32_t>& word) {
    std::rotate(word.begin(), word.begin() + static_cast<std::ptrdiff_t>(least_rotation(word)), word.end());
  };
  std::vector<std::uint32_t> reverse(contour.rbegin(), contour.rend());
  rotate(contour);
  rotate(reverse);
  if (reverse < contour) contour = std::move(reverse);
}

/// Writes the key of a face into `key`. Two faces have the same key if and only if their outer contours visit the same
/// vertices in the same cyclic order or in reverse, and their holes do too. `name` maps a vertex to the number used in
/// the key. Takes time proportional to the number of corners, plus the sorting of holes.
void face_key(const Scene& scene, std::uint32_t face, FunctionRef<std::uint32_t(std::uint32_t)> name,
              std::vector<std::uint32_t>& key) {
  const auto take_contour = [&](std::size_t c, std::vector<std::uint32_t>& contour) {
    for (const std::uint32_t v : scene.faces.contour(face, c)) contour.push_back(name(v));
    make_canonical(contour);
  };
  key.clear();
  take_contour(0, key);
  std::vector<std::vector<std::uint32_t>> holes(scene.faces.contour_count(face) - 1);
  for (std::size_t c = 1; c <= holes.size(); ++c) take_contour(c, holes[c - 1]);
  std::sort(holes.begin(), holes.end());
  for (const auto& hole : holes) {
    key.push_back(kNone);  // a separator that is not a vertex
    key.insert(key.end(), hole.begin(), hole.end());
  }
}

std::uint64_t hash(std::span<const std::uint32_t> key) {
  std::uint64_t h = key.size();
  for (const std::uint32_t k : key) h = mix_bits(h ^ (k + kGoldenRatio));
  return h;
}

/// Returns the faces that share their bit with another one, in order. `face(k)`: the faces, for k in [0, count).
/// `bit_of(f)` is less than `bits`, which is a multiple of 64.
template <class Face, class Bit>
std::vector<std::uint32_t> faces_that_share(std::size_t count, std::size_t bits, const Face& face, const Bit& bit_of) {
  struct Words {
    std::uint64_t taken = 0, shared = 0;
  };
  std::vector<Words> words(bits / 64);
  // Each task owns a range of the words and reads all faces.
  constexpr std::size_t kFacesPerRange = 200'000, kMostRanges = 4;
  const std::size_t ranges = std::clamp<std::size_t>(count / kFacesPerRange, 1, std::min(kMostRanges, thread_count()));
  parallel_tasks(ranges, [&](std::size_t range) {
    const std::size_t first = words.size() * range / ranges, own = words.size() * (range + 1) / ranges - first;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t bit = bit_of(face(k));
      if (bit / 64 - first >= own) continue;
      const std::uint64_t mask = std::uint64_t{1} << (bit % 64);
      Words& at = words[bit / 64];
      at.shared |= at.taken & mask;
      at.taken |= mask;
    }
  });
  std::vector<std::uint32_t> sharing = indices_where(count, [&](std::size_t k) {
    const std::size_t bit = bit_of(face(k));
    return (words[bit / 64].shared >> (bit % 64) & 1) != 0;
  });
  for (std::uint32_t& k : sharing) k = face(k);
  return sharing;
}

/// The bit of a face among the 64 at its lowest vertex; it does not depend on the order of the corners.
std::size_t bit_at_vertex(std::span<const std::uint32_t> contour) {
  std::uint32_t lowest = contour[0], sum = 0;
  for (const std::uint32_t v : contour) {
    lowest = std::min(lowest, v);
    sum ^= v;
  }
  return 64 * std::size_t{lowest} + ((sum * static_cast<std::uint32_t>(kGoldenRatio >> 32)) >> 26);
}

/// The faces that may have the same contour as another one, ascending.
std::vector<std::uint32_t> suspect_faces(const PolygonFaces& faces, std::size_t vertices) {
  const std::span<const std::uint32_t> corners = faces.corners();
  const auto all = [](std::size_t f) { return static_cast<std::uint32_t>(f); };
  const auto share = [&](const auto& bit_of) { return faces_that_share(faces.size(), 64 * vertices, all, bit_of); };
  const std::vector<std::uint32_t> sharing =
      faces.all_triangles()
          ? share([&](std::uint32_t f) { return bit_at_vertex(corners.subspan(3 * std::size_t{f}).first<3>()); })
          : share([&](std::uint32_t f) { return bit_at_vertex(faces.contour(f, 0)); });
  const std::size_t bits = 64 * std::bit_ceil(sharing.size() + 1);
  return faces_that_share(
      sharing.size(), bits, [&](std::size_t k) { return sharing[k]; },
      [&](std::uint32_t f) {
        std::uint64_t sum = 0;
        for (const std::uint32_t v : faces.contour(f, 0)) sum += mix_bits(v);
        return sum & (bits - 1);
      });
}

/// Records that face `first` stands for `face`.
void library_fallback(DuplicateFaces& found, std::size_t faces, std::uint32_t face, std::uint32_t first) {
  if (found.first.empty()) {
    found.first.resize(faces);
    std::iota(found.first.begin(), found.first.end(), 0u);
  }
  found.first[face] = first;
}

void find_within_objects(const Scene& scene, DuplicateFaces& found) {
  const std::vector<std::uint32_t> candidates = suspect_faces(scene.faces, scene.vertices.size());
  if (candidates.empty()) return;
  // Different objects have different vertices, so one table serves all.
  const std::size_t mask = std::bit_ceil(2 * candidates.size() + 1) - 1;
  struct Slot {
    std::uint64_t hash = 0;
    std::uint32_t face = kNone;
  };
  std::vector<Slot> table(mask + 1);
  std::vector<std::uint32_t> key, other;
  const auto itself = [](std::uint32_t v) { return v; };
  for (const std::uint32_t f : candidates) {
    face_key(scene, f, itself, key);
    const std::uint64_t h = hash(key);
    for (std::size_t k = h & mask;; k = (k + 1) & mask) {
      if (table[k].face == kNone) {
        table[k] = {h, f};
        break;
      }
      if (table[k].hash != h) continue;
      face_key(scene, table[k].face, itself, other);
      if (key != other) continue;
      library_fallback(found, scene.faces.size(), f, table[k].face);
      break;
    }
  }
}

/// Description of an object that is equal for objects that coincide.
struct Shape {
  std::vector<Point3> positions;                  ///< sorted
  std::vector<std::vector<std::uint32_t>> faces;  ///< keys in terms of positions, sorted and distinct
  std::vector<std::uint32_t> face;                ///< per key: its first face
};

Shape shape_of(const Scene& scene, const Object& object) {
  const std::uint32_t first = object.vertex_begin, n = object.vertex_end - first;
  std::vector<std::uint32_t> order(n), rank(n);
  std::iota(order.begin(), order.end(), first);
  const auto coordinates = [&](std::uint32_t v) {
    const Point3& p = scene.vertices[v];
    return std::array{p.x, p.y, p.z};
  };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return coordinates(a) < coordinates(b); });
  Shape shape;
  for (std::uint32_t k = 0; k < n; ++k) {
    rank[order[k] - first] = k;
    shape.positions.push_back(scene.vertices[order[k]]);
  }
  std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> keys(object.face_end - object.face_begin);
  const auto name = [&](std::uint32_t v) { return rank[v - first]; };
  for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
    auto& [key, face] = keys[f - object.face_begin];
    face = f;
    face_key(scene, f, name, key);
  }
  std::sort(keys.begin(), keys.end());
  for (auto& [key, face] : keys) {
    if (!shape.faces.empty() && shape.faces.back() == key) continue;
    shape.faces.push_back(std::move(key));
    shape.face.push_back(face);
  }
  return shape;
}

/// The objects that have as many vertices as another object, ascending. Only these may coincide.
std::vector<std::uint32_t> like_large_objects(const Scene& scene) {
  std::vector<std::uint32_t> order(scene.objects.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto size = [&](std::uint32_t i) { return scene.objects[i].vertex_end - scene.objects[i].vertex_begin; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return size(a) < size(b); });
  std::vector<std::uint32_t> found;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool as_before = k > 0 && size(order[k - 1]) == size(order[k]);
    const bool as_behind = k + 1 < order.size() && size(order[k + 1]) == size(order[k]);
    if (as_before || as_behind) found.push_back(order[k]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Sums of positions, equal for objects that coincide.
std::vector<std::uint64_t> position_sums(const Scene& scene, const std::vector<std::uint32_t>& objects) {
  std::vector<std::uint64_t> sums(scene.objects.size());
  parallel_for(objects.size(), [&](std::size_t k) {
    const std::uint32_t i = objects[k];
    const Object& object = scene.objects[i];
    std::uint64_t sum = object.vertex_end - object.vertex_begin;
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      std::uint64_t h = 0;
      for (int k = 0; k < 3; ++k) h = mix_bits(h ^ std::bit_cast<std::uint64_t>(scene.vertices[v][k] + 0.0)) + 1;
      sum += h;
    }
    sums[i] = sum;
  });
  return sums;
}

void find_equal_objects(const Scene& scene, DuplicateFaces& found) {
  std::vector<std::uint32_t> order = like_large_objects(scene);
  const std::vector<std::uint64_t> sums = position_sums(scene, order);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return sums[a] < sums[b]; });
  for (std::size_t i = 0; i < order.size();) {
    std::size_t end = i + 1;
    while (end < order.size() && sums[order[end]] == sums[order[i]]) ++end;
    std::optional<Shape> first;
    for (std::size_t k = i + 1; k < end; ++k) {
      const Object& object = scene.objects[order[k]];
      if (object.face_begin == object.face_end) continue;
      if (!first) first = shape_of(scene, scene.objects[order[i]]);
      const Shape shape = shape_of(scene, object);
      if (shape.positions != first->positions || shape.faces != first->faces) continue;
      ++found.objects;
      for (std::size_t n = 0; n < shape.face.size(); ++n) {
        library_fallback(found, scene.faces.size(), shape.face[n], first->face[n]);
      }
    }
    i = end;
  }
}

using Corner = std::pair<std::array<std::uint32_t, 2>, std::size_t>;  ///< ends of an edge, and its corner

std::vector<Corner> edges_of(const Scene& scene, std::uint32_t f) {
  std::vector<Corner> edges;
  for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
    const auto contour = scene.faces.contour(f, c);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const auto [low, high] = std::minmax(contour[k], contour[k + 1 == contour.size() ? 0 : k + 1]);
      edges.push_back({{low, high}, scene.faces.corner_index(f, c) + k});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Whether all corners of two faces have the same flags.
bool have_same_flags(const Scene& scene, std::uint32_t from, std::uint32_t to) {
  const std::uint8_t flags = scene.corner_flags[scene.faces.corner_index(from, 0)];
  return std::ranges::all_of(std::array{from, to}, [&](std::uint32_t f) {
    const std::size_t first = scene.faces.corner_index(f, 0), count = corners_of(scene.faces, f).size();
    return std::ranges::count(std::span(scene.corner_flags).subspan(first, count), flags) ==
           static_cast<std::ptrdiff_t>(count);
  });
}

/// Joins flags of faces of one object. Faces of other objects have their own vertices, and their flags are dropped with
/// them.
void join_flags(Scene& scene, std::uint32_t from, std::uint32_t to) {
  constexpr std::uint8_t kFlagsOfAll = kCornerFileHidden | kCornerInner | kCornerSmooth | kCornerLimit;
  if (have_same_flags(scene, from, to)) return;
  const std::vector<Corner> a = edges_of(scene, from), b = edges_of(scene, to);
  for (std::size_t k = 0; k < a.size() && a[k].first == b[k].first; ++k) {
    std::uint8_t& kept = scene.corner_flags[b[k].second];
    const std::uint8_t other = scene.corner_flags[a[k].second];
    kept = static_cast<std::uint8_t>((kept & other & kFlagsOfAll) | ((kept | other) & ~kFlagsOfAll));
  }
}

}  // namespace

bool may_repeat_triangles(const Topology& topology) {
  const std::vector<Edge>& edges = topology.edges;
  constexpr std::uint32_t kMostLookedBack = 64;  // adjustable
  // Edges are sorted by their lower vertex. If two faces share two edges there, the second edge looks back for the first
  // one, as far as the first edge of the vertex.
  const auto repeats = [&](std::size_t first, std::size_t e) {
    const Edge& edge = edges[e];
    if (e - first > kMostLookedBack) return true;
    return std::any_of(edges.data() + first, edges.data() + e, [&](const Edge& other) {
      return (other.face0 == edge.face0 && other.face1 == edge.face1) ||
             (other.face0 == edge.face1 && other.face1 == edge.face0);
    });
  };
  // Most pairs of faces at a vertex have bits of their own among 64.
  const auto bit_of = [](const Edge& edge) {
    return std::uint64_t{1} << ((edge.face0 ^ edge.face1) * static_cast<std::uint32_t>(kGoldenRatio >> 32) >> 26);
  };
  const auto any_repeats = [&](std::size_t begin, std::size_t end) {
    std::size_t first = begin;
    while (first > 0 && edges[first - 1].v0 == edges[begin].v0) --first;
    std::uint64_t seen = 0;
    for (std::size_t e = first; e < end; ++e) {
      if (edges[e].v0 != edges[first].v0) first = e, seen = 0;
      if (topology.edge_flags[e] & kEdgeManyFaces) return true;
      if (edges[e].face1 == kNone) continue;
      const std::uint64_t bit = bit_of(edges[e]);
      if ((seen & bit) && repeats(first, e)) return true;
      seen |= bit;
    }
    return false;
  };
  return parallel_reduce(edges.size(), kShortWorkBlock, false, any_repeats, std::logical_or<>{});
}

DuplicateFaces find_duplicate_faces(const Scene& scene, bool within_objects) {
  DuplicateFaces found;
  if (within_objects) find_within_objects(scene, found);
  if (scene.objects.size() > 1) find_equal_objects(scene, found);
  for (std::uint32_t f = 0; f < found.first.size(); ++f) {
    // The first face of a pair within an object may itself be replaced, together with its object.
    found.first[f] = found.first[found.first[f]];
    found.faces += found.first[f] != f;
  }
  if (found.faces == 0) found.first.clear();
  return found;
}

void drop_duplicate_faces(Scene& scene, const DuplicateFaces& duplicates) {
  if (duplicates.faces == 0) return;
  if (!scene.corner_flags.empty()) {
    for (std::uint32_t f = 0; f < duplicates.first.size(); ++f) {
      if (duplicates.first[f] != f) join_flags(scene, f, duplicates.first[f]);
    }
  }
  for (Detail& detail : scene.details) detail.face = duplicates.first[detail.face];
  FaceWriter writer(scene);
  const auto n = static_cast<std::uint32_t>(duplicates.first.size());
  for (std::uint32_t f = 0; f < n;) {
    std::uint32_t end = f;
    while (end < n && duplicates.first[end] == end) ++end;
    writer.keep(f, end);
    for (f = end; f < n && duplicates.first[f] != f;) ++f;
  }
  writer.finish();
  drop_unused_vertices(scene);
}

}  // namespace ligne
