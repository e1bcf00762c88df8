#include "scene/subdivision/subdivide.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/clean/clean.hpp"
#include "scene/clean/weld.hpp"
#include "scene/subdivision/control_mesh.hpp"
#include "scene/subdivision/masks.hpp"

namespace ligne {
namespace {

/// Largest edge length of the surface if no levels are requested, relative to the size of the scene: 2 to 3 mm on a
/// sheet of A4, fine enough for contours to look round. Taste.
constexpr double kEdgePart = 0.01;
/// Largest number of triangles if no levels are requested; they take about a second.
constexpr std::size_t kMaxDefaultTriangles = 1'000'000;

/// An object and its surface.
struct Surface {
  ControlMesh control;
  std::vector<Point3> points;
  std::vector<std::uint32_t> corners;  ///< three per triangle
  std::vector<std::uint8_t> flags;     ///< CornerFlag per corner
  std::size_t per_face = 0;            ///< triangles per face (Loop), or per corner, of the control mesh
};

std::size_t triangle_count(const ControlMesh& control, SubdivisionScheme scheme, unsigned levels) {
  const std::size_t grown = std::size_t{1} << 2 * levels;
  return scheme == SubdivisionScheme::loop ? control.face_source.size() * grown : control.mesh.corners.size() * grown / 2;
}

std::size_t triangle_count(const std::vector<Surface>& surfaces, SubdivisionScheme scheme, unsigned levels) {
  std::size_t sum = 0;
  for (const Surface& surface : surfaces) sum += triangle_count(surface.control, scheme, levels);
  return sum;
}

/// Mean length of the edges of all meshes, weighted by length, relative to the size of their common bounding box.
double edge_part(const std::vector<Surface>& surfaces) {
  Point3 low(HUGE_VAL), high(-HUGE_VAL);
  double sum = 0, squares = 0;
  for (const Surface& surface : surfaces) {
    const SubdivisionMesh& mesh = surface.control.mesh;
    for (const Point3& p : mesh.points) low = glm::min(low, p), high = glm::max(high, p);
    for (const SubdivisionEdge& edge : mesh.edges) {
      const double length = glm::distance(mesh.points[edge.ends[0]], mesh.points[edge.ends[1]]);
      sum += length, squares += length * length;
    }
  }
  const double size = glm::distance(low, high);
  return sum > 0 && size > 0 ? squares / sum / size : 0;
}

unsigned levels_by_size(const std::vector<Surface>& surfaces, SubdivisionScheme scheme) {
  unsigned levels = 1;
  for (double part = edge_part(surfaces) / 2; part > kEdgePart && levels < kMostSubdivisionLevels; part /= 2) {
    if (triangle_count(surfaces, scheme, levels + 1) > kMaxDefaultTriangles) break;
    ++levels;
  }
  return levels;
}

/// Flags of an edge inside a limit surface.
constexpr std::uint8_t kInsideSurface = kCornerSmooth | kCornerLimit;

/// Flags of the side that begins at a corner of the last level. A side whose sharpness has decayed is neither smooth nor
/// sharp: its angle decides.
std::uint8_t side_flags(const SubdivisionMesh& mesh, std::uint32_t corner, bool mark_creases) {
  const std::uint32_t e = mesh.corner_edge[corner];
  const std::uint8_t smooth = mark_creases ? kInsideSurface : 0;
  if (e >= mesh.edges.size()) return smooth;
  const std::uint8_t flags = mesh.edge_flags[e] & ~kCornerSharp;
  if (mesh.edge_sharpness[e] > 0) return mark_creases ? flags | kCornerSharp : flags;
  return mesh.edge_flags[e] & kCornerSharp ? flags : flags | smooth;
}

/// Cuts the quads of the last level along their shorter diagonals.
void cut_quads(const SubdivisionMesh& mesh, bool mark_creases, Surface& made) {
  const std::size_t quads = mesh.face_count();
  made.corners.resize(6 * quads);
  made.flags.resize(6 * quads);
  const std::uint8_t inner = kCornerInner | (mark_creases ? kInsideSurface : 0);
  parallel_each(quads, [&](std::size_t q) {
    const auto corner = [&](std::uint32_t k) { return static_cast<std::uint32_t>(4 * q) + (k & 3u); };
    const auto point = [&](std::uint32_t k) { return made.points[mesh.corners[corner(k)]]; };
    const std::uint32_t k = glm::distance(point(1), point(3)) < kShorterDiagonal * glm::distance(point(0), point(2));
    std::uint32_t* const corners = &made.corners[6 * q];
    std::uint8_t* const flags = &made.flags[6 * q];
    for (const std::uint32_t half : {0u, 1u}) {  // k, k + 1, k + 2 and k + 2, k + 3, k
      for (std::uint32_t i = 0; i < 3; ++i) {
        const std::uint32_t c = corner(k + 2 * half + i);
        corners[3 * half + i] = mesh.corners[c];
        flags[3 * half + i] = i == 2 ? inner : side_flags(mesh, c, mark_creases);
      }
    }
  });
}

void take_triangles(SubdivisionMesh& mesh, bool mark_creases, Surface& made) {
  made.flags.resize(mesh.corners.size());
  parallel_each(made.flags.size(),
                [&](std::size_t k) { made.flags[k] = side_flags(mesh, static_cast<std::uint32_t>(k), mark_creases); });
  made.corners = std::move(mesh.corners);
}

void make_surface(Surface& made, SubdivisionScheme scheme, unsigned levels, bool mark_creases) {
  SubdivisionMesh mesh = std::move(made.control.mesh);
  for (unsigned level = 1; level <= levels; ++level) {
    SubdivisionMesh next = refine(mesh, scheme, level == levels);
    next.points = refined_points(mesh, scheme);
    // Only the faces of the first level's corners are needed later.
    if (level == 1) {
      made.control.mesh = {};
      made.control.mesh.corner_face = std::move(mesh.corner_face);
    }
    mesh = std::move(next);
  }
  made.points = limit_points(mesh, scheme);
  if (scheme == SubdivisionScheme::loop) {
    made.per_face = std::size_t{1} << 2 * levels;
    take_triangles(mesh, mark_creases, made);
  } else {
    made.per_face = std::size_t{2} << 2 * (levels - 1);
    cut_quads(mesh, mark_creases, made);
  }
}

/// Rewrites a scene, object by object.
class SceneWriter {
 public:
  SceneWriter(Scene& scene, bool loop) : old_(scene), loop_(loop), first_new_(scene.faces.size() + 1, 0) {}

  void add_surface(Object& object, Surface& surface) {
    const auto base = static_cast<std::uint32_t>(vertices_.size());
    vertices_.insert(vertices_.end(), surface.points.begin(), surface.points.end());
    const std::size_t triangles = surface.corners.size() / 3, first = faces_.size();
    const std::span<std::uint32_t> corners = faces_.append_triangles(triangles);
    parallel_each(corners.size(), [&](std::size_t k) { corners[k] = surface.corners[k] + base; });
    add_flags(surface.flags);
    const ControlMesh& control = surface.control;
    const auto source = [&](std::size_t triangle) {
      const std::size_t of = triangle / surface.per_face;
      return control.face_source[loop_ ? of : control.mesh.corner_face[of]];
    };
    if (!old_.face_material.empty()) {
      for (std::size_t t = 0; t < triangles; ++t) material_.push_back(old_.face_material[source(t)]);
    }
    if (!old_.face_source.empty()) {
      for (std::size_t t = 0; t < triangles; ++t) source_.push_back(old_.face_source[source(t)]);
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) first_new_[f] = kNone;
    end(object, first);
  }

  void copy(Object& object) {
    const auto base = static_cast<std::uint32_t>(vertices_.size()) - object.vertex_begin;
    const auto at = [](auto& values, std::size_t k) { return values.begin() + static_cast<std::ptrdiff_t>(k); };
    vertices_.insert(vertices_.end(), at(old_.vertices, object.vertex_begin), at(old_.vertices, object.vertex_end));
    const std::size_t first = faces_.size();
    std::vector<std::uint32_t> contour;
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      first_new_[f] = static_cast<std::uint32_t>(faces_.size());
      for (std::size_t c = 0; c < old_.faces.contour_count(f); ++c) {
        const auto corners = std::as_const(old_.faces).contour(f, c);
        contour.assign(corners.begin(), corners.end());
        for (std::uint32_t& v : contour) v += base;
        c == 0 ? faces_.add_face(contour) : faces_.add_hole(contour);
        if (old_.corner_flags.empty()) continue;
        add_flags(std::span(old_.corner_flags).subspan(old_.faces.corner_index(f, c), corners.size()));
      }
      if (!old_.face_material.empty()) material_.push_back(old_.face_material[f]);
      if (!old_.face_source.empty()) source_.push_back(old_.face_source[f]);
    }
    end(object, first);
  }

  void finish(Warnings& warnings) {
    const std::size_t dropped = std::erase_if(old_.details, [&](Detail& detail) {
      detail.face = first_new_[detail.face];
      return detail.face == kNone;
    });
    warnings.add("details of subdivided faces dropped", dropped);
    if (!flags_.empty()) flags_.resize(faces_.corners().size(), 0);
    old_.vertices = std::move(vertices_);
    old_.faces = std::move(faces_);
    old_.corner_flags = std::move(flags_);
    old_.face_material = std::move(material_);
    old_.face_source = std::move(source_);
  }

 private:
  void end(Object& object, std::size_t first_face) {
    object.vertex_begin = last_vertex_;
    object.vertex_end = last_vertex_ = static_cast<std::uint32_t>(vertices_.size());
    object.face_begin = static_cast<std::uint32_t>(first_face);
    object.face_end = static_cast<std::uint32_t>(faces_.size());
  }

  /// Adds flags of the last corners. The list of flags stays empty until a corner has one.
  void add_flags(std::span<const std::uint8_t> flags) {
    if (flags_.empty() && std::ranges::all_of(flags, [](std::uint8_t f) { return f == 0; })) return;
    flags_.resize(faces_.corners().size() - flags.size(), 0);
    flags_.insert(flags_.end(), flags.begin(), flags.end());
  }

  Scene& old_;
  bool loop_;
  std::vector<std::uint32_t> first_new_;  ///< per face of the old scene; kNone: subdivided
  std::uint32_t last_vertex_ = 0;
  std::vector<Point3> vertices_;
  PolygonFaces faces_;
  std::vector<std::uint8_t> flags_;
  std::vector<std::uint32_t> material_, source_;
};

void warn_of_left_out(const std::vector<Surface>& surfaces, const CreaseTags& tags, Warnings& warnings) {
  std::size_t tagged = 0;
  for (const Surface& surface : surfaces) {
    const LeftOutFaces& left_out = surface.control.left_out;
    warnings.add(kDegenerateFaces, left_out.degenerate);
    warnings.add(kFacesNotFinite, left_out.not_finite);
    tagged += surface.control.tagged;
  }
  if (!tags.edges.empty() && tagged == 0) warnings.add("crease tags name no edge of the model", tags.edges.size());
}

std::string too_many(const SubdivisionRequest& request, const std::vector<Surface>& surfaces, unsigned levels) {
  const SubdivisionScheme scheme = request.how.scheme;
  unsigned fitting = levels;
  while (fitting > 0 && triangle_count(surfaces, scheme, fitting) > kMostSubdividedTriangles) --fitting;
  return std::to_string(levels) + (levels == 1 ? " level" : " levels") + " of subdivision would make " +
         std::to_string(triangle_count(surfaces, scheme, levels)) + " triangles of it, more than " +
         std::to_string(kMostSubdividedTriangles) +
         (fitting > 0 ? ": " + std::to_string(fitting) + " would do" : ": it is no control mesh");
}

}  // namespace

SubdivisionReport subdivide(Scene& scene, const SubdivisionRequest& request, CreaseTags tags, const std::string& name,
                            Warnings& warnings) {
  make_single_object(scene);
  tags.sort();
  const SubdivisionScheme scheme = request.how.scheme;
  const bool loop = scheme == SubdivisionScheme::loop;
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (!request.is_wanted || request.is_wanted(scene.objects[i], i)) wanted.push_back(i);
  }
  std::vector<Surface> surfaces(wanted.size());
  {
    const Weld weld = weld_vertices(scene);
    parallel_tasks(wanted.size(), [&](std::size_t i) {
      surfaces[i].control = make_control_mesh(scene, scene.objects[wanted[i]], weld.first, tags, loop);
    });
  }
  warn_of_left_out(surfaces, tags, warnings);
  SubdivisionReport report;
  report.levels = request.how.levels ? *request.how.levels : levels_by_size(surfaces, scheme);
  report.triangles = triangle_count(surfaces, scheme, report.levels);
  if (report.triangles > kMostSubdividedTriangles) throw InputError(name, too_many(request, surfaces, report.levels));
  for (const Surface& surface : surfaces) {
    const SubdivisionMesh& mesh = surface.control.mesh;
    report.faces += surface.control.face_source.size();
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
      report.sharp_edges += mesh.edge_sharpness[e] > 0 && mesh.edges[e].sides[1] != kNone;
    }
  }
  parallel_tasks(surfaces.size(),
                 [&](std::size_t i) { make_surface(surfaces[i], scheme, report.levels, request.mark_creases); });
  SceneWriter writer(scene, loop);
  std::size_t next = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    if (next < wanted.size() && wanted[next] == i) {
      writer.add_surface(scene.objects[i], surfaces[next]);
      surfaces[next++] = {};
    } else {
      writer.copy(scene.objects[i]);
    }
  }
  writer.finish(warnings);
  return report;
}

}  // namespace ligne
