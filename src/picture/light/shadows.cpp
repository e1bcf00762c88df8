#include "picture/light/shadows.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "picture/light/face_carrier.hpp"
#include "picture/light/region_faces.hpp"
#include "view/tolerances.hpp"
#include "visibility/polygons/visible_faces.hpp"

namespace ligne {
namespace {

/// The page of a light. It has the size of A4, so that its lattice is as fine as that of a drawing.
const Rect kLightPage{{0, 0}, {297, 210}};

/// Narrowest lit or shadowed part, in mm. Narrower parts come from rounding when contours are mapped from the light's
/// page to the viewer's.
constexpr double kNarrowestMm = 0.001;

/// Smallest source number of edges of lit areas. Edges of regions have lower numbers.
constexpr std::uint32_t kLitSource = 0x80000000u;

/// Margin around the scene's bounding sphere in the single picture of a light outside of the scene.
constexpr double kOutside = 1.05;

struct Sphere {
  Point3 centre{0, 0, 0};
  double radius = 0;
};

Sphere sphere_round(const Scene& scene) {
  Point3 low(1e300), high(-1e300);
  for (const Point3& p : scene.vertices) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {(low + high) * 0.5, glm::length(high - low) * 0.5};
}

std::vector<CameraRequest> pictures_of(const Light& light, const Scene& scene) {
  CameraRequest request;
  request.up_axis = scene.up_axis;
  if (light.kind == Light::Kind::parallel) {
    request.direction = light.vector;
    return {request};
  }
  const Sphere sphere = sphere_round(scene);
  request.eye = light.vector;
  const double distance = glm::length(sphere.centre - light.vector);
  if (distance > kOutside * sphere.radius) {
    constexpr double kDegrees = 57.29577951308232;
    request.target = sphere.centre;
    request.fov_degrees = 2 * kDegrees * std::asin(std::min(1.0, sphere.radius / distance)) * kOutside;
    if (request.fov_degrees < 150) return {request};
  }
  std::vector<CameraRequest> pictures;  // the six sides of a cube around the light
  request.fov_degrees = 91;             // they overlap, so that no gaps are left between them
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Point3 forward(0);
      forward[axis] = sign * sphere.radius;
      request.target = light.vector + forward;
      pictures.push_back(request);
    }
  }
  return pictures;
}

/// The parts of each face that a light reaches, on the viewer's page: [face][k] holds the parts behind k of the
/// transparent faces that count.
using LitFaces = std::vector<std::vector<std::vector<ContourFace>>>;

double opacity_of(const Scene& scene, std::uint32_t face) {
  const std::uint32_t m = scene.face_material.empty() ? 0 : scene.face_material[face];
  return m < scene.materials.size() ? scene.materials[m].opacity : 1;
}

/// Returns the opacities of transparent faces, each once; only 1 if there are none.
std::vector<double> opacities_of(const Scene& scene) {
  std::vector<double> opacities;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    if (const double o = opacity_of(scene, f); o < 1) opacities.push_back(o);
  }
  std::sort(opacities.begin(), opacities.end());
  opacities.erase(std::unique(opacities.begin(), opacities.end()), opacities.end());
  if (opacities.empty()) opacities.push_back(1);
  return opacities;
}

/// A scene and its view.
struct PlacedScene {
  const Scene& scene;
  const Topology& topology;
  const View& view;
  const Lattice& lattice;
};

/// Adds the faces visible in one picture of a light. Only transparent faces of this opacity count.
void add_lit(const PlacedScene& placed, const CameraRequest& request, double opacity, LitFaces& lit) {
  const auto& [scene, topology, view, lattice] = placed;
  const Camera camera = make_camera(request, scene);
  const View light_view = make_view(scene, camera, {kLightPage}, kLightPage);
  ProjectedScene seen = project(scene, topology, light_view, {});
  for (std::uint32_t f = 0; f < seen.face_is_transparent.size(); ++f) {
    if (seen.face_is_transparent[f] && opacity_of(scene, f) != opacity) seen.face_is_transparent[f] = kClearFace;
  }
  const Facets facets = make_facets(seen, coincidence_mm(seen) / seen.lattice.step_mm);
  CellGrid::Options grid_options{.margin_steps = coincidence_mm(seen) / seen.lattice.step_mm + 1, .see_through = true};
  const CellGrid grid(seen, facets.facets, grid_options);
  const VisibleFaces visible = find_visible_faces(seen, facets.facets, grid, {});
  for (const Region& region : visible.regions) {
    const FacePlane plane = plane_of(scene, region.face);
    if (side_of_eye(camera, plane) * side_of_eye(view.camera, plane) <= 0) continue;
    const FaceBorder border(scene, region.face, view, lattice, kNarrowestMm);
    std::vector<std::vector<LatticePoint>> contours;
    bool drawn = true;
    for (const std::vector<Point2>& contour : region.contours) {
      std::vector<LatticePoint> points;
      drawn = drawn && carry(light_view, contour, plane, view, lattice, points);
      if (points.size() < 3) {
        drawn = drawn && !contours.empty();  // without an outer contour there is no face
        continue;
      }
      border.move_beyond(points);
      contours.push_back(std::move(points));
    }
    if (!drawn) continue;
    if (lit[region.face].size() <= region.level) lit[region.face].resize(region.level + 1);
    lit[region.face][region.level].push_back(make_contour_face(contours, kLitSource));
  }
}

bool narrow(const ContourFace& face, const Lattice& lattice) {
  double length = 0;
  for (const EdgeLoop& loop : face.contours) {
    for (const ContourEdge& e : loop) length += std::hypot(e.dx(), e.dy()) * (value(e.to) - value(e.from));
  }
  return twice_area(face) * lattice.step_mm < length * kNarrowestMm;
}

/// Whether the run lies along an edge of the face. There, the border of the lit area is only the rounded border of the
/// face.
bool along_border(const ContourEdge& run, const ContourFace& face, const Lattice& lattice) {
  const LatticeSegment& s = run.segment;
  const auto beside = [&](const LatticeSegment& border, SegmentParameter t) {
    const double x = s.a.x + value(t) * s.dx() - border.a.x, y = s.a.y + value(t) * s.dy() - border.a.y;
    const double length2 = border.dx() * border.dx() + border.dy() * border.dy();
    const double along = std::clamp((x * border.dx() + y * border.dy()) / length2, 0.0, 1.0);
    return std::hypot(x - along * border.dx(), y - along * border.dy()) * lattice.step_mm < kNarrowestMm;
  };
  for (const EdgeLoop& loop : face.contours) {
    for (const ContourEdge& e : loop) {
      if (beside(e.segment, run.from) && beside(e.segment, run.to)) return true;
    }
  }
  return false;
}

/// Cuts a region along the parts of its face that one light reaches.
class ShadowCut {
 public:
  ShadowCut(const Lattice& lattice, std::size_t light, std::size_t light_count, double opacity)
      : lattice_(lattice), light_(light), light_count_(light_count), opacity_(opacity) {}

  /// `lit` is indexed by the number of transparent faces that the light passed through.
  void cut(const Region& piece, const std::vector<std::vector<ContourFace>>& lit, CastShadows& out) const {
    const ContourFace whole = on_lattice(piece, lattice_);
    std::vector<ContourFace> rest{whole};
    const std::size_t first = out.regions.size();
    bool cut = false;
    for (std::size_t level = 0; level < lit.size(); ++level) {
      if (lit[level].empty() || rest.empty()) continue;
      ClipResult result = clip_contour_by_contour(rest, lit[level]);
      const Region like = lit_region(piece, level);
      if (first == out.regions.size() && !result.inside.empty() && all_narrow(result.outside)) {
        out.regions.push_back(like);  // wholly lit: the contours stay unchanged
        out.regions.back().contours = piece.contours;
        return;
      }
      for (const ContourFace& face : result.inside) {
        if (narrow(face, lattice_)) continue;
        out.regions.push_back(region_of(face, lattice_, like));
        if (level > 0) add_borders(face, whole, piece, out);
      }
      cut |= !result.inside.empty();
      rest = std::move(result.outside);
    }
    Region dark = without_contours(piece);
    dark.lights &= ~(1u << light_);
    if (!cut) {
      dark.contours = piece.contours;
      out.regions.push_back(std::move(dark));
      return;
    }
    for (const ContourFace& face : rest) {
      if (narrow(face, lattice_)) continue;
      out.regions.push_back(region_of(face, lattice_, dark));
      add_borders(face, whole, piece, out);
    }
  }

 private:
  static Region without_contours(const Region& r) { return {r.face, {}, r.level, r.lights, r.light_shares, r.material}; }

  Region lit_region(const Region& piece, std::size_t level) const {
    Region like = without_contours(piece);
    like.lights |= 1u << light_;
    if (level > 0) {
      if (like.light_shares.empty()) like.light_shares.assign(light_count_, 1);
      like.light_shares[light_] *= std::pow(1 - opacity_, double(level));
    }
    return like;
  }
  bool all_narrow(const std::vector<ContourFace>& faces) const {
    return std::all_of(faces.begin(), faces.end(), [&](const ContourFace& face) { return narrow(face, lattice_); });
  }
  /// Adds the borders between this face, which has less light, and areas with more.
  void add_borders(const ContourFace& face, const ContourFace& whole, const Region& piece, CastShadows& out) const {
    const auto snapped = [&](FinePoint p) { return lattice_.snap(to_mm(lattice_, p)); };
    for (const EdgeLoop& loop : face.contours) {
      for (const ContourEdge& e : loop) {
        if (e.source < kLitSource || along_border(e, whole, lattice_)) continue;
        const ShadowBorder border{piece.face, piece.level, snapped(e.begin()), snapped(e.end())};
        if (border.from != border.to) out.borders.push_back(border);
      }
    }
  }

  const Lattice& lattice_;
  std::size_t light_, light_count_;
  double opacity_;
};

}  // namespace

CastShadows cast_shadows(const Scene& scene, const Topology& topology, const View& view, std::span<const Light> lights,
                         const std::vector<Region>& regions) {
  const Lattice lattice = page_lattice(view);
  const std::vector<double> opacities = opacities_of(scene);
  const std::size_t light_count = std::min(lights.size(), kMostLights);
  CastShadows all{regions, {}};
  for (Region& r : all.regions) r.lights = 0;
  for (std::size_t i = 0; i < light_count; ++i) {
    for (const double opacity : opacities) {
      LitFaces lit(scene.faces.size());
      for (const CameraRequest& request : pictures_of(lights[i], scene))
        add_lit({scene, topology, view, lattice}, request, opacity, lit);
      const ShadowCut work(lattice, i, light_count, opacity);
      std::vector<CastShadows> cut(all.regions.size());
      parallel_for(cut.size(), [&](std::size_t k) {
        const Region& piece = all.regions[k];
        // A place that is dark without transparent faces stays dark for every opacity.
        if (lit[piece.face].empty() || (opacity != opacities.front() && !(piece.lights >> i & 1u))) {
          cut[k].regions.push_back(piece);
        } else {
          work.cut(piece, lit[piece.face], cut[k]);
        }
      });
      all.regions.clear();
      for (CastShadows& c : cut) {
        std::move(c.regions.begin(), c.regions.end(), std::back_inserter(all.regions));
        all.borders.insert(all.borders.end(), c.borders.begin(), c.borders.end());
      }
    }
  }
  return all;
}

void add_shadow_strokes(const Scene& scene, const View& view, const std::vector<ShadowBorder>& borders, StrokeModel& model) {
  for (const ShadowBorder& border : borders) {
    const FacePlane plane = plane_of(scene, border.face);
    Stroke stroke;
    SourceEdge source;
    source.faces[0] = border.face;
    stroke.from = border.from;
    stroke.to = border.to;
    if (!point_on_face(view, model.lattice.to_mm(border.from), plane, source.ends[0])) continue;
    if (!point_on_face(view, model.lattice.to_mm(border.to), plane, source.ends[1])) continue;
    const HomogeneousPoint from = to_homogeneous(view, source.ends[0]), to = to_homogeneous(view, source.ends[1]);
    stroke.z_from = static_cast<float>(from.z / from.w);
    stroke.z_to = static_cast<float>(to.z / to.w);
    stroke.w_from = static_cast<float>(from.w);
    stroke.w_to = static_cast<float>(to.w);
    stroke.line_class = LineClass::shadow;
    stroke.level = static_cast<std::uint8_t>(std::min(border.level, 255u));
    stroke.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
    model.intersections.push_back(source);
    model.strokes.push_back(stroke);
  }
}

}  // namespace ligne
