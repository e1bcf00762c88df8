// The horizon against the default method on the same surface as a mesh, each line of one drawing looked up in the other,
// and no line drawn twice: random surfaces in views along an axis, where whole curves lie behind each other on one upright
// line of the page, and functions from all sides.

#include "height_functions.hpp"
#include "main/tier.hpp"
#include "scene/surfaces/surface_mesh.hpp"
#include "support/page_lines.hpp"

namespace ligne::test {
namespace {

/// Largest distance between the lines of two exact methods: the accuracy of a drawing.
constexpr double kAccuracyMm = 0.001;
/// Lines on each other are apart by roundings to a lattice of 8 nm. (A mesh takes lines for one that come as near as a
/// quarter of a micrometre by chance, where they meet at a small angle.)
constexpr double kOnLineMm = 0.00001;
class SampledHeights : public HeightSource {
 public:
  SampledHeights(std::vector<double> x, std::vector<double> y, std::vector<double> z)
      : HeightSource(std::move(x), std::move(y)), z_(std::move(z)) {}
  void read_row(std::size_t j, std::span<double> z) const override {
    std::copy_n(z_.begin() + static_cast<std::ptrdiff_t>(j * z.size()), z.size(), z.begin());
  }

 private:
  std::vector<double> z_;
};

enum class Kind { smooth, stepped, random, holed };
constexpr const char* kKindNames[] = {"smooth", "stepped", "random", "holed"};

/// A random surface with an odd number of samples along x and y, so that one of each lies in the middle.
SampledHeights random_surface(Kind kind, std::mt19937& random) {
  const auto draw = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  const auto nx = static_cast<std::size_t>(2 * draw(3, 8) + 1), ny = static_cast<std::size_t>(2 * draw(3, 8) + 1);
  const std::vector<double> x = positions(nx, 1), y = positions(ny, 0.8);
  const double a = draw(1, 9), b = draw(1, 9), c = draw(-9, 9) / 9.0, d = draw(2, 6) / 12.0;
  std::vector<double> z;
  for (const double v : y) {
    for (const double u : x) {
      const double smooth = d * std::sin(a * u * v + b * u + c * v);
      if (kind == Kind::smooth) z.push_back(smooth);
      if (kind == Kind::stepped) z.push_back(std::round(3 * smooth) / 3);
      if (kind == Kind::random) z.push_back(draw(-1000, 1000) / 2500.0);
      if (kind == Kind::holed) z.push_back(draw(0, 7) == 0 ? kNaN : smooth);
    }
  }
  return {x, y, z};
}

using Segments = std::vector<Segment>;

/// Curves with borders, and outlines.
struct DrawnSegments {
  Segments curves, outline;

  Segments all() const {
    Segments segments = curves;
    segments.insert(segments.end(), outline.begin(), outline.end());
    return segments;
  }
};

DrawnSegments by_horizon(const HeightSource& heights, const View& view, const HorizonOptions& options) {
  Statistics statistics;
  const HorizonLines lines = horizon_lines(heights, view, options, statistics);
  DrawnSegments drawn;
  for (const Polylines* part : {&lines.curves, &lines.border})
    for_segments(*part, [&](Point2 a, Point2 b) { drawn.curves.push_back({a, b}); });
  for_segments(lines.outline, [&](Point2 a, Point2 b) { drawn.outline.push_back({a, b}); });
  return drawn;
}

/// 1: the upper side is seen, -1: the lower one, 0: edge on.
int turned(const Scene& scene, std::uint32_t face, const Camera& camera) {
  constexpr double kRounding = 1e-11;
  const Point3 on_face = scene.vertices[scene.faces.contour(face, 0)[0]];
  const Point3 sight = camera.perspective ? on_face - camera.eye : camera.forward, normal = face_normal(scene, face);
  const double d = glm::dot(normal, sight) / glm::length(sight);
  return std::abs(d) <= kRounding ? 0 : d < 0 ? 1 : -1;
}

DrawnSegments by_mesh(const HeightSource& heights, const View& view, const HorizonOptions& options) {
  SurfacePoints points = points_of(heights);
  points.x_stride = options.x_stride;
  points.y_stride = options.y_stride;
  const SurfaceMesh mesh = make_surface_mesh(points);
  const Scene scene = surface_scene({&mesh, 1}, {1, 1, 1}, std::nullopt);
  const Topology topology = build_topology(scene);
  EdgeSelection selection;
  for (const LineClass c : {LineClass::horizon, LineClass::outline, LineClass::border}) selection.classes.add(c);
  ProjectedScene projected = project(scene, topology, view, selection);
  projected.with_intersections = false;
  VisibilityResult result = find_method("appel")->compute_visibility(projected, {});
  // A mesh takes faces that are edge on within a micrometre for edge on; the horizon those that are so but for a rounding.
  std::erase_if(result.strokes->strokes, [&](const Stroke& s) {
    const Edge& edge = topology.edges[s.source];
    return s.line_class == LineClass::outline &&
           turned(scene, edge.face0, view.camera) == turned(scene, edge.face1, view.camera);
  });
  remove_coincident_strokes(*result.strokes, coincidence_mm(projected));
  DrawnSegments drawn;
  for (const Stroke& s : result.strokes->strokes)
    if (s.visible)
      (s.line_class == LineClass::outline ? drawn.outline : drawn.curves)
          .push_back({projected.lattice.to_mm(s.from), projected.lattice.to_mm(s.to)});
  return drawn;
}

std::string words(Point2 p, Point2 q) {
  return "(" + std::to_string(p.x) + ", " + std::to_string(p.y) + ") - (" + std::to_string(q.x) + ", " +
         std::to_string(q.y) + ")";
}

bool apart(const Segment& a, const Segment& b) {
  return std::min(a.from.x, a.to.x) > std::max(b.from.x, b.to.x) + kAccuracyMm ||
         std::max(a.from.x, a.to.x) < std::min(b.from.x, b.to.x) - kAccuracyMm;
}

/// Length of what is drawn twice.
double twice(const Segments& segments, std::string& worst) {
  double sum = 0, longest = 0;
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (std::size_t k = i + 1; k < segments.size(); ++k) {
      if (apart(segments[i], segments[k])) continue;
      const double common = common_length(segments[i], segments[k], kOnLineMm);
      if (common <= 2 * kAccuracyMm) continue;
      sum += common;
      if (common <= longest) continue;
      longest = common;
      worst = words(segments[i].from, segments[i].to) + " and " + words(segments[k].from, segments[k].to);
    }
  return sum;
}

/// Length of what is in `segments` and in none of `others`; `worst`: where the longest such part is.
double missing(const Segments& segments, const Segments& others, std::string& worst) {
  double sum = 0, longest = 0;
  for (const Segment& s : segments) {
    std::vector<Range> found;
    for (const Segment& o : others) {
      if (apart(s, o)) continue;
      if (const auto range = along(s, o, kAccuracyMm)) found.push_back(*range);
    }
    for (const Range& gap : gaps(std::move(found), 0, s.length())) {
      if (gap.length() <= 2 * kAccuracyMm) continue;
      sum += gap.length();
      if (gap.length() <= longest) continue;
      longest = gap.length();
      worst = words(s.at(gap.from), s.at(gap.to));
    }
  }
  return sum;
}

void compare(const HeightSource& heights, const CameraRequest& request, const HorizonOptions& options,
             const std::string& where) {
  const View view = view_of(heights, request);
  const Segments horizon = by_horizon(heights, view, options).all(), mesh = by_mesh(heights, view, options).all();
  std::string worst;
  EXPECT_LT(missing(mesh, horizon, worst), 0.01) << where << ": the horizon leaves out " << worst;
  EXPECT_LT(missing(horizon, mesh, worst), 0.01) << where << ": the horizon draws " << worst;
  EXPECT_LT(twice(horizon, worst), 0.01) << where << ": the horizon draws twice " << worst;
}

struct Families {
  const char* name;
  bool x, y;
};
constexpr Families kFamilies[] = {{"x", true, false}, {"y", false, true}, {"xy", true, true}};

/// Calls test(heights, options, what they are) for random surfaces of all kinds with all families of curves.
template <class Test>
void for_surfaces(unsigned seed, Test test) {
  std::mt19937 random(seed);
  for (const Kind kind : {Kind::smooth, Kind::stepped, Kind::random, Kind::holed})
    for (const Families& families : kFamilies) {
      const SampledHeights heights = random_surface(kind, random);
      HorizonOptions options;
      const std::size_t stride = std::uniform_int_distribution<std::size_t>(1, 2)(random);
      options.x_stride = families.x ? stride : 0;
      options.y_stride = families.y ? stride : 0;
      options.outline = true;
      test(heights, options,
           std::string(kKindNames[static_cast<int>(kind)]) + " " + std::to_string(heights.x().size()) + " x " +
               std::to_string(heights.y().size()) + ", lines " + families.name + " every " + std::to_string(stride) +
               ", seed " + std::to_string(seed));
    }
}

/// Compares random surfaces in all these views.
void compare_all(unsigned seed, const std::vector<CameraRequest>& views) {
  for_surfaces(seed, [&](const HeightSource& heights, const HorizonOptions& options, const std::string& what) {
    for (std::size_t i = 0; i < views.size(); ++i) compare(heights, views[i], options, what + ", view " + std::to_string(i));
  });
}

// The cosine of 90 degrees is 6e-17 in doubles: these views are along an axis but for a rounding.
TEST(HorizonAlongAxes, AgreesWithTheMesh) {
  std::vector<CameraRequest> views;
  for (const double azimuth : {-180.0, -90.0, 0.0, 90.0, 180.0, 270.0})
    for (const double elevation : {0.0, 10.0, 30.0, 90.0, -30.0}) views.push_back(along_angles(azimuth, elevation));
  for (const unsigned seed : chosen("along axes", 2, {1u, 2u, 3u, 4u})) compare_all(seed, views);
}

TEST(HorizonAlongAxes, AgreesWhenTheViewIsAlongAnAxisExactly) {
  compare_all(11, {along({0, 1, -0.4}), along({-1, 0, -0.4}), along({0, -1, 0.3}), along({1, 0, 0}), along({0, 1, 0}),
                   along({0, 0, -1})});
}

// From a rounding to the first angle at which rows are apart on the page.
TEST(HorizonAlongAxes, AgreesWhenTheViewIsNearlyAlongAnAxis) {
  std::vector<CameraRequest> views;
  for (const double off : {1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, -1e-12, -1e-9, 1e-3})
    for (const Point3& direction : {Point3{-1, off, -0.4}, Point3{off, 1, -0.5}, Point3{1, off, 0.3}})
      views.push_back(along(direction));
  compare_all(21, views);
}

// The eye stands in the plane of a curve, so that this one is upright.
TEST(HorizonAlongAxes, AgreesInPerspective) {
  for (unsigned seed = 31; seed <= 33; ++seed) {
    for_surfaces(seed, [](const HeightSource& heights, const HorizonOptions& options, const std::string& what) {
      const double x = heights.x()[heights.x().size() / 2 - 1], y = heights.y()[heights.y().size() / 2];
      for (const Point3& eye :
           {Point3{x, -3, 1}, Point3{x, 3, 0.3}, Point3{-3.5, y, 1.2}, Point3{3, y, -1}, Point3{3, y, 0}}) {
        const Point3 target = std::abs(eye.x) > 2 ? Point3{0, y, 0} : Point3{x, 0, 0};
        compare(heights, from_eye(eye, target, 100), options,
                what + ", eye " + std::to_string(eye.x) + ", " + std::to_string(eye.y) + ", " + std::to_string(eye.z));
      }
    });
  }
}

// Functions, from all sides.

double rough(double x, double y) {
  return 0.15 * std::sin(917.3 * x + 1.3) * std::sin(631.7 * y + 0.4) + 0.1 * std::sin(4 * x);
}

struct Surface {
  const char* name;
  Function f;
};

const std::vector<Surface>& surfaces() {
  static const std::vector<Surface> all{
      {"waves", waves},
      {"sombrero", sombrero},
      {"rough", rough},
      {"waves with a hole", [](double x, double y) { return std::hypot(x - 0.1, y + 0.2) < 0.35 ? kNaN : waves(x, y); }},
      {"round sombrero", [](double x, double y) { return std::hypot(x, y) > 0.93 ? kNaN : sombrero(x, y); }},
      {"rough with many holes",
       [](double x, double y) { return std::sin(411.7 * x) * std::sin(523.1 * y) > 0.7 ? kNaN : rough(x, y); }},
      {"strips", [](double x, double y) { return std::sin(20 * x) > 0.6 ? kNaN : waves(x, y) + 0.2 * x; }}};
  return all;
}

HorizonOptions with_outlines() {
  HorizonOptions options;
  options.outline = true;
  return options;
}

// From all sides, in perspective, and along the axes and their diagonals.
TEST(HorizonAndMesh, AgreeFromAllSides) {
  std::vector<CameraRequest> views;
  for (const double elevation : chosen("elevations", 2, {-35.0, 3.0, 28.0, 71.0}))
    for (double azimuth = 11; azimuth < 360; azimuth += 51) views.push_back(along_angles(azimuth, elevation));
  for (const Point3& eye : {Point3{-3, -2.5, 2}, Point3{2.2, 3.1, 0.4}, Point3{2.5, -2.8, -1.5}})
    views.push_back(from_eye(eye, {0, 0, 0}, 100));
  for (const Point3& direction :
       {Point3{0, 1, -0.4}, Point3{-1, 0, -0.4}, Point3{0, 0, -1}, Point3{1, 1, -1}, Point3{1, -1, -0.5}})
    views.push_back(along(direction));
  for (const Surface& surface : surfaces())
    for (std::size_t i = 0; i < views.size(); ++i)
      compare(FunctionHeights(surface.f, positions(30), positions(37)), views[i], with_outlines(),
              std::string(surface.name) + ", view " + std::to_string(i));
}

double whole_length(const Segments& segments) {
  double sum = 0;
  for (const Segment& s : segments) sum += s.length();
  return sum;
}

// Where the eye stands over the ground or beside it the cells in its row and column are cut differently, and of an edge
// straight before it one bank is looked at.
TEST(HorizonAndMesh, AgreeNearlyWithTheEyeOverTheGround) {
  for (const Surface& surface : surfaces())
    for (const Point3& eye :
         {Point3{-4, 0.5 / 3, 1}, Point3{-3, 0.11, 1}, Point3{0.21, 2.7, 1.2}, Point3{0.33, -0.12, 2.5}}) {
      const FunctionHeights heights(surface.f, positions(60), positions(67));
      const View view = view_of(heights, from_eye(eye, {0.05, 0, 0}, 100));
      const DrawnSegments horizon = by_horizon(heights, view, with_outlines()),
                          mesh = by_mesh(heights, view, with_outlines());
      const double curves = whole_length(mesh.curves), outline = whole_length(mesh.outline);
      EXPECT_NEAR(whole_length(horizon.curves), curves, 0.01 * curves) << surface.name << ", eye " << eye.x;
      EXPECT_NEAR(whole_length(horizon.outline), outline, 1e-3 + 0.001 * curves + 0.1 * outline)
          << surface.name << ", eye " << eye.x;
    }
}

}  // namespace
}  // namespace ligne::test
