#include "scene/surfaces/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "base/no_index.hpp"
#include "scene/clean/weld.hpp"
#include "scene/model/precision.hpp"
#include "scene/surfaces/contours/outside_cells.hpp"

namespace ligne {
namespace {

/// Largest coordinate, so that products of five stay finite, as for models (scene/readers/reader.cpp).
constexpr double kLargestCoordinate = 0x1p200;

constexpr std::uint8_t kRims[] = {SurfaceMesh::kRimBottom, SurfaceMesh::kRimRight, SurfaceMesh::kRimTop,
                                  SurfaceMesh::kRimLeft};
constexpr const char* kRimNames[] = {"wall at low y", "wall at high x", "wall at high y", "wall at low x"};

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// Per sample its vertex, kNone for a hole. Samples that only rounding separates get one position.
std::vector<std::uint32_t> vertices_of(const SurfacePoints& surface, std::vector<Point3>& vertices) {
  std::vector<std::uint32_t> vertex(vertices.size());
  for (std::uint32_t v = 0; v < vertex.size(); ++v) vertex[v] = is_finite(vertices[v]) ? v : kNone;
  if (!surface.parametric) return vertex;
  Scene scene;
  scene.vertices = std::move(vertices);
  scene.objects.emplace_back().vertex_end = static_cast<std::uint32_t>(scene.vertices.size());
  double largest = 0;
  for (const Point3& p : scene.vertices) {
    if (is_finite(p)) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  if (largest > 0 && largest < kLargestCoordinate) weld_near_vertices(scene, largest * kFormulaRounding);
  vertex = weld_vertices(scene).first;
  vertices = std::move(scene.vertices);
  return vertex;
}

/// Adds the cells of a grid to a mesh.
class CellCutter {
 public:
  CellCutter(const SurfacePoints& surface, const std::vector<std::uint32_t>& vertex, SurfaceMesh& mesh)
      : surface_(surface),
        vertex_(vertex),
        outside_(surface.columns, surface.rows, [&](std::size_t k) { return vertex[k] != kNone; }),
        mesh_(mesh) {}

  void cut(std::size_t i, std::size_t j) {
    const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    if (a == kNone || b == kNone || c == kNone || d == kNone) return;
    if (!surface_.left_out.empty() && surface_.left_out[j * (surface_.columns - 1) + i]) return;
    const std::uint8_t bottom = row_flags(j) | rim(i + 1, j, SurfaceMesh::kRimBottom),
                       top = row_flags(j + 1) | rim(i + 1, j + 2, SurfaceMesh::kRimTop);
    const std::uint8_t left = column_flags(i) | rim(i, j + 1, SurfaceMesh::kRimLeft),
                       right = column_flags(i + 1) | rim(i + 2, j + 1, SurfaceMesh::kRimRight);
    // If a side has no length, the diagonal coincides with another side and takes its flags.
    std::uint8_t diagonal = 0;
    if (a == b) diagonal |= left;
    if (a == c) diagonal |= bottom;
    if (d == b) diagonal |= top;
    if (d == c) diagonal |= right;
    add({a, b, c}, {bottom, diagonal, left});
    add({b, d, c}, {right, top, diagonal});
  }

 private:
  std::uint32_t at(std::size_t i, std::size_t j) const { return vertex_[j * surface_.columns + i]; }
  std::uint8_t row_flags(std::size_t j) const { return is_curve_at(j, surface_.rows, surface_.y_stride) ? kCornerCurve : 0; }
  std::uint8_t column_flags(std::size_t i) const {
    return is_curve_at(i, surface_.columns, surface_.x_stride) ? kCornerCurve : 0;
  }
  /// Returns the flag if the neighbour, numbered as in OutsideCells, is outside.
  std::uint8_t rim(std::size_t i, std::size_t j, std::uint8_t flag) const { return outside_(i, j) ? flag : 0; }
  void add(std::array<std::uint32_t, 3> corners, std::array<std::uint8_t, 3> flags) {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return;
    mesh_.triangles.push_back(corners);
    mesh_.flags.push_back(flags);
  }

  const SurfacePoints& surface_;
  const std::vector<std::uint32_t>& vertex_;
  OutsideCells outside_;
  SurfaceMesh& mesh_;
};

/// Clips the triangles of a mesh at the plane z = height.
class PlaneCut {
 public:
  PlaneCut(SurfaceMesh& mesh, double height, bool keep_above) : mesh_(mesh), height_(height), keep_above_(keep_above) {}

  void run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<std::uint8_t, 3>> flags;
    triangles.swap(mesh_.triangles);
    flags.swap(mesh_.flags);
    for (std::size_t t = 0; t < triangles.size(); ++t) cut(triangles[t], flags[t]);
  }

 private:
  struct Corner {
    std::uint32_t vertex;
    std::uint8_t flags;
  };

  /// +1 inside, 0 on the plane, -1 outside.
  int side(std::uint32_t v) const {
    const double z = mesh_.vertices[v].z;
    const int above = (z > height_) - (z < height_);
    return keep_above_ ? above : -above;
  }

  void cut(const std::array<std::uint32_t, 3>& t, const std::array<std::uint8_t, 3>& flags) {
    const std::array<int, 3> sides{side(t[0]), side(t[1]), side(t[2])};
    if (std::min({sides[0], sides[1], sides[2]}) >= 0) {
      mesh_.triangles.push_back(t);
      mesh_.flags.push_back(flags);
      return;
    }
    if (std::max({sides[0], sides[1], sides[2]}) <= 0) return;
    std::array<Corner, 4> corners;
    std::size_t n = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const bool goes_out = sides[next] < 0, crosses = sides[k] * sides[next] < 0;
      // The side after the corner where the contour leaves runs along the plane.
      if (sides[k] >= 0) corners[n++] = {t[k], sides[k] == 0 && goes_out ? std::uint8_t{0} : flags[k]};
      if (crosses) corners[n++] = {cut_vertex(t[k], t[next]), goes_out ? std::uint8_t{0} : flags[k]};
    }
    add(corners[0], corners[1], corners[2], n == 4);
    if (n == 4) add({corners[0].vertex, 0}, corners[2], corners[3], false);
  }

  void add(Corner a, Corner b, Corner c, bool last_is_inner) {
    mesh_.triangles.push_back({a.vertex, b.vertex, c.vertex});
    mesh_.flags.push_back({a.flags, b.flags, last_is_inner ? std::uint8_t{0} : c.flags});
  }

  /// The vertex at which the edge crosses the plane, the same for both directions of the edge.
  std::uint32_t cut_vertex(std::uint32_t v0, std::uint32_t v1) {
    if (v0 > v1) std::swap(v0, v1);
    const auto [place, is_new] =
        cuts_.try_emplace(std::uint64_t{v0} << 32 | v1, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const Point3 a = mesh_.vertices[v0], b = mesh_.vertices[v1];
      const double t =
          (height_ / 2 - a.z / 2) / (b.z / 2 - a.z / 2);  // halves, since a difference of two heights may overflow
      mesh_.vertices.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), height_});
    }
    return place->second;
  }

  SurfaceMesh& mesh_;
  double height_;
  bool keep_above_;
  std::unordered_map<std::uint64_t, std::uint32_t> cuts_;
};

/// Adds objects to a scene, each with the vertices that its triangles use.
class ObjectMaker {
 public:
  explicit ObjectMaker(const Point3& factor) : factor_(factor) {}

  void begin(std::string name, bool from_formula) {
    object_ = {};
    object_.name = std::move(name);
    object_.vertex_begin = static_cast<std::uint32_t>(scene_.vertices.size());
    object_.face_begin = static_cast<std::uint32_t>(scene_.faces.size());
    from_formula_ = from_formula;
    largest_ = 0;
  }

  std::uint32_t add_vertex(Point3 p) {
    p *= factor_;
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (!(size <= kLargestCoordinate))
      throw InputError("surface", "has a coordinate beyond 1.6e60, too large to compute with");
    largest_ = std::max(largest_, size);
    scene_.vertices.push_back(p);
    return static_cast<std::uint32_t>(scene_.vertices.size() - 1);
  }

  void add_triangle(const std::array<std::uint32_t, 3>& v, const std::array<std::uint8_t, 3>& flags = {}) {
    scene_.faces.add_triangle(v[0], v[1], v[2]);
    for (const std::uint8_t f : flags) scene_.corner_flags.push_back(f & (kCornerCurve | kCornerContour));
  }

  void end() {
    object_.vertex_end = static_cast<std::uint32_t>(scene_.vertices.size());
    object_.face_end = static_cast<std::uint32_t>(scene_.faces.size());
    if (object_.face_begin == object_.face_end) return;
    object_.precision = from_formula_ ? largest_ * kFormulaRounding : half_ulp_double(largest_);
    scene_.objects.push_back(std::move(object_));
  }

  Scene finish() {
    scene_.up_axis = Axis::z;
    return std::move(scene_);
  }

 private:
  Point3 factor_;
  Scene scene_;
  Object object_;
  bool from_formula_ = false;
  double largest_ = 0;
};

void add_surface(const SurfaceMesh& mesh, ObjectMaker& maker) {
  maker.begin(mesh.name, mesh.from_formula);
  std::vector<std::uint32_t> number(mesh.vertices.size(), kNone);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& v = number[mesh.triangles[t][k]];
      if (v == kNone) v = maker.add_vertex(mesh.vertices[mesh.triangles[t][k]]);
      corners[k] = v;
    }
    maker.add_triangle(corners, mesh.flags[t]);
  }
  maker.end();
}

/// Adds the wall below one rim; its outer side is counter-clockwise.
void add_wall(const SurfaceMesh& mesh, std::size_t rim, double base, ObjectMaker& maker) {
  maker.begin(mesh.name + ", " + kRimNames[rim], mesh.from_formula);
  struct Upright {
    std::uint32_t top, foot;  ///< equal where the rim comes down to the base
  };
  std::unordered_map<std::uint32_t, Upright> uprights;
  const auto upright = [&](std::uint32_t v) {
    const auto [place, is_new] = uprights.try_emplace(v);
    if (is_new) {
      const Point3 p = mesh.vertices[v];
      place->second.top = maker.add_vertex(p);
      place->second.foot = p.z == base ? place->second.top : maker.add_vertex({p.x, p.y, base});
    }
    return place->second;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!(mesh.flags[t][k] & kRims[rim])) continue;
      const Upright a = upright(mesh.triangles[t][k]), b = upright(mesh.triangles[t][(k + 1) % 3]);
      if (a.foot != a.top) maker.add_triangle({b.top, a.top, a.foot});
      if (b.foot != b.top) maker.add_triangle({b.top, a.foot, b.foot});
    }
  }
  maker.end();
}

}  // namespace

SurfaceMesh make_surface_mesh(const SurfacePoints& surface) {
  SurfaceMesh mesh{.name = surface.name, .from_formula = surface.from_formula, .vertices = surface.points};
  const std::vector<std::uint32_t> vertex = vertices_of(surface, mesh.vertices);
  const std::size_t cells = surface.columns < 2 || surface.rows < 2 ? 0 : (surface.columns - 1) * (surface.rows - 1);
  mesh.triangles.reserve(2 * cells);
  mesh.flags.reserve(2 * cells);
  CellCutter cutter(surface, vertex, mesh);
  for (std::size_t j = 0; j + 1 < surface.rows; ++j) {
    for (std::size_t i = 0; i + 1 < surface.columns; ++i) cutter.cut(i, j);
  }
  return mesh;
}

void clip_heights(SurfaceMesh& mesh, double low, double high) {
  PlaneCut(mesh, low, true).run();
  PlaneCut(mesh, high, false).run();
}

std::optional<std::array<double, 2>> height_range(std::span<const SurfaceMesh> meshes) {
  std::optional<std::array<double, 2>> range;
  for (const SurfaceMesh& mesh : meshes) {
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t v : triangle) {
        const double z = mesh.vertices[v].z;
        if (!range) range = {z, z};
        range = {std::min((*range)[0], z), std::max((*range)[1], z)};
      }
    }
  }
  return range;
}

Scene surface_scene(std::span<const SurfaceMesh> meshes, const Point3& factor, std::optional<double> base) {
  ObjectMaker maker(factor);
  for (const SurfaceMesh& mesh : meshes) {
    add_surface(mesh, maker);
    if (!base) continue;
    for (std::size_t rim = 0; rim < std::size(kRims); ++rim) add_wall(mesh, rim, *base, maker);
  }
  return maker.finish();
}

}  // namespace ligne
