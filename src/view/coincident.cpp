#include "view/coincident.hpp"

#include <algorithm>
#include <atomic>
#include <compare>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "view/equal_runs.hpp"
#include "view/spatial_order.hpp"
#include "view/tolerances.hpp"
#include "view/vertex_clusters.hpp"

namespace ligne {
namespace {

constexpr std::size_t kFew = 8;  ///< largest number of items that are compared in pairs; more are sorted

/// Calls found(first, other) for equal items; `first` is the first of its equals in the order `less`, which may
/// distinguish equal items.
template <class Item, class Equal, class Less, class Found>
void for_each_equal(std::span<Item> items, Equal equal, Less less, Found found) {
  if (items.size() <= kFew) {
    bool any = false;
    for (std::size_t i = 0; i < items.size(); ++i) {
      for (std::size_t k = i + 1; k < items.size(); ++k) any = any || equal(items[i], items[k]);
    }
    if (!any) return;
  }
  std::sort(items.begin(), items.end(), less);
  for (std::size_t i = 0; i < items.size();) {
    std::size_t end = i + 1;
    while (end < items.size() && equal(items[i], items[end])) found(items[i], items[end++]);
    i = end;
  }
}

/// Per vertex, the lowest vertex with its position and depth; empty if no two vertices share them.
std::vector<std::uint32_t> find_first_at_place(const std::vector<ProjectedVertex>& vertices) {
  std::vector<std::uint32_t> first(vertices.size());
  std::iota(first.begin(), first.end(), 0u);
  const auto place = [&](std::uint32_t v) { return std::tie(vertices[v].p.x, vertices[v].p.y, vertices[v].z); };
  std::atomic<bool> any{false};
  for_each_run(
      vertices.size(), [&](std::size_t i) { return page_square(vertices[i].p); },
      [&](std::size_t begin, std::size_t end) {
        // Uses numbers within the run, since `first` of the run changes meanwhile.
        thread_local std::vector<std::uint32_t> run;
        run.resize(end - begin);
        std::iota(run.begin(), run.end(), static_cast<std::uint32_t>(begin));
        for_each_equal(
            std::span(run), [&](std::uint32_t a, std::uint32_t b) { return place(a) == place(b); },
            [&](std::uint32_t a, std::uint32_t b) { return std::pair(place(a), a) < std::pair(place(b), b); },
            [&](std::uint32_t lowest, std::uint32_t other) {
              first[other] = lowest;
              any = true;
            });
      });
  if (!any) first.clear();
  return first;
}

/// A triangle by the places of its vertices on the page.
struct PlacedTriangle {
  std::array<std::uint32_t, 3> v;  ///< ascending
  std::uint32_t face, number;
  auto order() const { return std::tie(v, face, number); }
};

std::uint32_t lowest_place(const ProjectedScene& scene, const Triangle& t) {
  return std::min({scene.place(t.v[0]), scene.place(t.v[1]), scene.place(t.v[2])});
}

PlacedTriangle placed(const ProjectedScene& scene, std::uint32_t number) {
  const Triangle& t = scene.triangles[number];
  PlacedTriangle p{{scene.place(t.v[0]), scene.place(t.v[1]), scene.place(t.v[2])}, t.face, number};
  std::sort(p.v.begin(), p.v.end());
  return p;
}

/// A coincident triangle: `number` coincides with `first`, which has the lowest face.
struct Repeated {
  std::uint32_t face, first, number;
  friend auto operator<=>(const Repeated&, const Repeated&) = default;
};

/// The triangles ordered by their lowest place. They are already sorted by their lowest vertex. If no two vertices
/// share a place that is the same order, and the result is empty.
std::vector<std::uint32_t> order_by_place(const ProjectedScene& scene) {
  if (scene.first_at_place.empty()) return {};
  struct Numbered {
    std::uint32_t place, number;
    auto operator<=>(const Numbered&) const = default;
  };
  std::vector<Numbered> numbered(scene.triangles.size());
  for (std::uint32_t i = 0; i < numbered.size(); ++i) numbered[i] = {lowest_place(scene, scene.triangles[i]), i};
  parallel_sort(numbered.begin(), numbered.end());
  std::vector<std::uint32_t> order(numbered.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = numbered[i].number;
  return order;
}

/// Whether triangles in [begin, end) may have equal places: such triangles have equal sums.
template <class Number>
bool may_repeat(const ProjectedScene& scene, std::size_t begin, std::size_t end, const Number& number) {
  if (end - begin > kFew) return true;
  std::array<std::uint32_t, kFew> sums{};
  for (std::size_t i = begin; i < end; ++i) {
    const auto& v = scene.triangles[number(i)].v;
    const auto last = sums.begin() + static_cast<std::ptrdiff_t>(i - begin);
    *last = scene.place(v[0]) + scene.place(v[1]) + scene.place(v[2]);
    if (std::find(sums.begin(), last, *last) != last) return true;
  }
  return false;
}

/// The triangles whose places several triangles share, ordered by face.
std::vector<Repeated> repeated_triangles(const ProjectedScene& scene) {
  const std::size_t n = scene.triangles.size();
  const std::vector<std::uint32_t> order = order_by_place(scene);
  const auto number = [&](std::size_t i) { return order.empty() ? static_cast<std::uint32_t>(i) : order[i]; };
  std::vector<std::vector<Repeated>> found(block_count(n, kRunBlock));
  for_each_run(
      n, [&](std::size_t i) { return lowest_place(scene, scene.triangles[number(i)]); },
      [&](std::size_t begin, std::size_t end) {
        if (!may_repeat(scene, begin, end, number)) return;
        thread_local std::vector<PlacedTriangle> run;
        run.clear();
        for (std::size_t i = begin; i < end; ++i) run.push_back(placed(scene, number(i)));
        std::vector<Repeated>& out = found[begin / kRunBlock];
        std::uint32_t last_first = kNone;
        for_each_equal(
            std::span(run), [](const PlacedTriangle& a, const PlacedTriangle& b) { return a.v == b.v; },
            [](const PlacedTriangle& a, const PlacedTriangle& b) { return a.order() < b.order(); },
            [&](const PlacedTriangle& first, const PlacedTriangle& other) {
              if (first.number != last_first) out.push_back({first.face, first.number, first.number});
              last_first = first.number;
              out.push_back({other.face, first.number, other.number});
            });
      });
  std::vector<Repeated> all;
  for (const auto& block : found) all.insert(all.end(), block.begin(), block.end());
  parallel_sort(all.begin(), all.end());
  return all;
}

ReplacedFaces repeated_faces(const ProjectedScene& scene, const std::vector<Repeated>& repeated) {
  std::vector<std::uint32_t> triangles_of_face;
  for (const Triangle& t : scene.triangles) {
    if (t.face >= triangles_of_face.size()) triangles_of_face.resize(t.face + std::size_t{1}, 0);
    ++triangles_of_face[t.face];
  }
  /// A face all of whose triangles coincide with others: repeated[begin, end).
  struct Face {
    std::uint32_t face;
    std::size_t begin, end;
  };
  std::vector<Face> faces;
  for (std::size_t begin = 0; begin < repeated.size();) {
    const std::uint32_t face = repeated[begin].face;
    std::size_t end = begin + 1;
    while (end < repeated.size() && repeated[end].face == face) ++end;
    const bool transparent = !scene.face_is_transparent.empty() && scene.face_is_transparent[face];
    if (end - begin == triangles_of_face[face] && !transparent) faces.push_back({face, begin, end});
    begin = end;
  }
  const auto run = [&](const Face& face) { return std::span(repeated).subspan(face.begin, face.end - face.begin); };
  const auto equal = [&](const Face& a, const Face& b) {
    return std::ranges::equal(run(a), run(b), {}, &Repeated::first, &Repeated::first);
  };
  ReplacedFaces result;
  for_each_equal(
      std::span(faces), equal,
      [&](const Face& a, const Face& b) {
        if (equal(a, b)) return a.face < b.face;
        return std::ranges::lexicographical_compare(run(a), run(b), {}, &Repeated::first, &Repeated::first);
      },
      [&](const Face& first, const Face& other) { result.emplace_back(other.face, first.face); });
  std::sort(result.begin(), result.end());
  return result;
}

/// A candidate edge by the places of its ends.
struct PlacedEdge {
  std::array<std::uint32_t, 2> v;  ///< ascending
  std::uint32_t number;
};

void merge_edges(ProjectedScene& scene) {
  if (scene.first_at_place.empty()) return;  // no two edges have two vertices in common
  const std::size_t n = scene.edges.size();
  std::vector<PlacedEdge> placed(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t a = scene.place(scene.edges[i].v0), b = scene.place(scene.edges[i].v1);
    placed[i] = {{std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(i)};
  }
  const auto precedence = [&](const PlacedEdge& e) {
    const ProjectedEdge& edge = scene.edges[e.number];
    return std::tie(edge.line_class, edge.source, e.number);
  };
  parallel_sort(placed.begin(), placed.end(), [&](const PlacedEdge& a, const PlacedEdge& b) {
    return a.v != b.v ? a.v < b.v : precedence(a) < precedence(b);
  });
  std::vector<std::uint8_t> keep(n, 1);
  bool all = true;
  for (std::size_t i = 1; i < n; ++i) {
    if (placed[i].v != placed[i - 1].v) continue;
    keep[placed[i].number] = 0;
    all = false;
  }
  if (all) return;
  scene.erase_edges([&](std::size_t i) { return !keep[i]; });
}

/// The face that replaces a face, or kNone.
std::uint32_t replacement(const ReplacedFaces& replaced, std::uint32_t face) {
  const auto found = std::lower_bound(replaced.begin(), replaced.end(), std::pair(face, std::uint32_t{0}));
  return found != replaced.end() && found->first == face ? found->second : kNone;
}

}  // namespace

ReplacedFaces merge_coincident_faces(ProjectedScene& scene, bool may_repeat) {
  const double side_mm = coincidence_mm(scene) / 2;  // a vertex moves by at most two sides in each direction
  merge_vertex_clusters(scene.vertices, std::max(side_mm / scene.lattice.step_mm, 1.0), side_mm);
  scene.first_at_place = find_first_at_place(scene.vertices);
  if (!may_repeat && scene.first_at_place.empty()) return {};
  const std::vector<Repeated> repeated = repeated_triangles(scene);
  if (repeated.empty()) return {};
  ReplacedFaces replaced = repeated_faces(scene, repeated);
  if (!replaced.empty())
    std::erase_if(scene.triangles, [&](const Triangle& t) { return replacement(replaced, t.face) != kNone; });
  return replaced;
}

void merge_coincident_edges(ProjectedScene& scene, const ReplacedFaces& replaced) {
  for (std::size_t i = 0; i < scene.edges.size() && !replaced.empty(); ++i) {
    for (std::uint32_t* face : {&scene.edges[i].face0, &scene.edges[i].face1}) {
      if (const std::uint32_t first = replacement(replaced, *face); first != kNone) *face = first;
    }
  }
  merge_edges(scene);
}

}  // namespace ligne
