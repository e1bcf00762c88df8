// Regions on every scene of the corpus: together they are the scene as it lies on the page, no two overlap, and each shows
// the face that is in front there by the oracle.

#include <polyclipping/clipper.hpp>

#include "drawing/measures.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "main/tier.hpp"
#include "support/corpus_scene.hpp"
#include "support/judge.hpp"
#include "support/test.hpp"
#include "visibility/methods.hpp"
#include "visibility/registry.hpp"

namespace ligne::test {
namespace {

constexpr std::size_t kMostTriangles = 600;  ///< the area of larger scenes takes the reference too long
/// Places nearer to a side than this are not asked for: regions end within two steps of the lattice of where faces do.
constexpr double kFromSidesMm = 0.002;
/// Faces that differ less in depth touch or cross there.
constexpr double kSameDepthMm = 0.0005;

double twice_area_mm(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& r : regions) sum += 2 * area_of(r);
  return sum;
}

/// Twice the area that the scene's triangles cover on the page.
double covered(const ProjectedScene& scene) {
  std::vector<ContourFace> faces;
  for (const Triangle& t : scene.triangles) {
    if (scene.is_edge_on(t)) continue;
    const std::vector<std::vector<LatticePoint>> contour{
        {scene.vertices[t.v[0]].p, scene.vertices[t.v[1]].p, scene.vertices[t.v[2]].p}};
    if (orientation(contour[0][0], contour[0][1], contour[0][2]) == 0) continue;
    faces.push_back(make_contour_face(contour));
  }
  const ClipResult all = clip_contour_by_contour(faces, {});
  return twice_area(all.outside) * scene.lattice.step_mm * scene.lattice.step_mm;
}

/// Twice the area of the regions' union, by Clipper.
double united(const std::vector<Region>& regions, const Lattice& lattice) {
  ClipperLib::Clipper clipper;
  const double units = std::ldexp(1, kFineBits) / lattice.step_mm;
  for (const Region& r : regions) {
    ClipperLib::Paths paths;
    for (const auto& contour : r.contours) {
      ClipperLib::Path path;
      for (const Point2& p : contour)
        path.emplace_back(std::llround((p.x - lattice.origin_mm.x) * units),
                          std::llround((p.y - lattice.origin_mm.y) * units));
      paths.push_back(path);
    }
    clipper.AddPaths(paths, ClipperLib::ptSubject, true);
  }
  ClipperLib::Paths solution;
  clipper.Execute(ClipperLib::ctUnion, solution, ClipperLib::pftPositive, ClipperLib::pftPositive);
  double sum = 0;
  for (const auto& path : solution) sum += ClipperLib::Area(path);
  return 2 * sum / (units * units);
}

/// The regions behind no glass.
std::vector<Region> seen_directly(std::vector<Region> regions) {
  std::erase_if(regions, [](const Region& r) { return r.level > 0; });
  return regions;
}

/// Points of the regions against the oracle. Before a face there are as many of glass as its level.
void ask_oracle(const Scene& scene, const std::vector<Region>& regions, const oracle::Oracle& oracle, std::mt19937& random) {
  for (const Region& r : regions) {
    Rect box;
    for (const Point2& p : r.contours[0]) box.extend(p);
    std::uniform_real_distribution<double> x(box.min.x, box.max.x), y(box.min.y, box.max.y);
    for (int i = 0; i < 6; ++i) {
      const Point2 p{x(random), y(random)};
      if (!holds(r, p) || oracle.distance_to_sides(p) < kFromSidesMm) continue;
      const auto hits = oracle.faces_at(p);
      if (hits.size() <= r.level) {
        ADD_FAILURE() << "a region of face " << r.face << " where there is none, at " << p.x << ", " << p.y;
        continue;
      }
      for (std::size_t i = 0; i < r.level; ++i) EXPECT_TRUE(is_glass(scene, hits[i].face)) << "hides face " << r.face;
      const oracle::FaceHit& seen = hits[r.level];
      if (seen.face == r.face) continue;
      const auto own = std::find_if(hits.begin(), hits.end(), [&](const oracle::FaceHit& h) { return h.face == r.face; });
      if (own == hits.end()) {
        ADD_FAILURE() << "face " << r.face << " is not at " << p.x << ", " << p.y;
      } else {
        EXPECT_LT(own->depth_mm - seen.depth_mm, kSameDepthMm)
            << "face " << r.face << " shown before face " << seen.face << " at " << p.x << ", " << p.y;
      }
    }
  }
}

class Regions : public testing::TestWithParam<std::filesystem::path> {};

/// The length of all contours, mm.
double rim_of(const std::vector<Region>& regions) {
  double sum = 0;
  for (const Region& r : regions)
    for (const auto& contour : r.contours)
      for (std::size_t i = 0; i < contour.size(); ++i) sum += glm::distance(contour[i], contour[(i + 1) % contour.size()]);
  return sum;
}

/// Regions of all methods that give some. Where faces touch, an order may give the place to another one of them than their
/// numbers do.
TEST_P(Regions, AreWhatIsInFront) {
  const Scene scene = scene_of_file(GetParam());
  const std::string name = GetParam().stem().string();
  const Topology topology = build_topology(scene);
  std::mt19937 random(1);
  for (const StandardView& standard : rotated_views(scene, "regions in front, " + name, 1)) {
    const JudgedView judged(scene, name, standard);
    const ProjectedScene projected = project(scene, topology, judged.view(), {});
    const double area = projected.triangles.size() <= kMostTriangles ? covered(projected) : 0;
    for (const std::string method : {"atherton-weiler", "newell", "bsp", "convex-tree", "warnock"}) {
      const bool is_first = method == "atherton-weiler", is_rounded = method == "warnock";
      const bool by_order = !is_first && !is_rounded;
      if (by_order && !is_chosen("regions, " + family_of(GetParam()) + method, place_in_family(GetParam()), 2)) continue;
      if (is_rounded && has_glass(scene)) continue;  // it leaves glass out
      SCOPED_TRACE(standard.name + " " + method);
      const VisibilityResult result = find_method(method)->compute_visibility(projected, {});
      ASSERT_TRUE(result.regions.has_value());
      const std::vector<Region> regions = seen_directly(*result.regions);
      if (projected.triangles.size() <= kMostTriangles) {
        const double sum = twice_area_mm(regions);
        // Four faces and more through one line: rings of four facets are not broken, and pairs are decided partly by an
        // order and partly by their depths: a sliver of a step's width may be nobody's.
        const double part = name != "three_prisms_penetrating" ? 1e-9 : is_first ? 2e-9 : 1e-8;
        // Corners on the lattice lie half a step off in x and in y.
        const double rounding = is_rounded ? 2 * rim_of(regions) * projected.lattice.step_mm : 0;
        EXPECT_NEAR(sum, area, part * area + rounding);
        // Clipper adds up areas in doubles about a far origin.
        EXPECT_NEAR(united(regions, projected.lattice), sum, 4e-9 * area + rounding);
      }
      ask_oracle(scene, *result.regions, judged.oracle(), random);
    }
  }
}

/// Area by face, mm^2.
std::map<std::uint32_t, double> areas_of(const std::vector<Region>& regions) {
  std::map<std::uint32_t, double> areas;
  for (const Region& r : regions) areas[r.face] += area_of(r);
  return areas;
}

TEST_P(Regions, AreTheSameByTheClassicalStudy) {
  const Scene scene = scene_of_file(GetParam());
  const Topology topology = build_topology(scene);
  for (const StandardView& standard : rotated_views(scene, "regions classical, " + GetParam().stem().string(), 1)) {
    const JudgedView judged(scene, GetParam().stem().string(), standard);
    const ProjectedScene projected = project(scene, topology, judged.view(), {});
    const std::map<std::uint32_t, double> wanted =
        areas_of(*atherton_weiler_method().compute_visibility(projected, {}).regions);
    double whole = 0;
    for (const auto& [face, area] : wanted) whole += area;
    // Slivers where four faces pass through one line, a step wide, go to one face by this study and to another or to nobody
    // by that.
    const double part = GetParam().stem() == "three_prisms_penetrating" ? 1e-8 : 1e-9;
    struct Study {
      const char* name;
      unsigned study;
      const char* setting = "study";
      unsigned word = study;
    };
    constexpr Study kStudies[] = {{"polygons", 1},
                                  {"silhouettes", 2},
                                  {"general clip", 1, "clip", 0},
                                  {"silhouettes, general clip", 2, "clip", 0},
                                  {"octagons", 1, "zones", 1},
                                  {"hulls", 1, "zones", 2},
                                  {"contours", 1, "zones", 3},
                                  {"at once", 1, "inside", 1},
                                  {"silhouettes, at once", 2, "inside", 1}};
    for (const Study& study : kStudies) {
      SCOPED_TRACE(standard.name + " " + study.name);
      VisibilityOptions options;
      options.settings.set("study", ParameterWord{study.study});
      options.settings.set(study.setting, ParameterWord{study.word});
      const std::vector<Region> regions = *atherton_weiler_method().compute_visibility(projected, options).regions;
      std::map<std::uint32_t, double> areas = areas_of(regions);
      if (projected.triangles.size() <= kMostTriangles) {
        const double sum = twice_area_mm(seen_directly(regions));
        EXPECT_NEAR(sum, covered(projected), 1e-9 * sum);
      }
      for (const auto& [face, area] : wanted) areas[face] -= area;
      for (const auto& [face, difference] : areas) EXPECT_NEAR(difference, 0, part * whole) << "face " << face;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, Regions, testing::ValuesIn(corpus_files(kLargeSceneBytes)),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace ligne::test
