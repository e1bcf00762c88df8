/// Every point of a clear drawing lies within the sag of the mesh there and half a pen of a visible line of the exact one,
/// and what is left out is as short as cleanup promises.

#include "clear/clear_against_exact.hpp"
#include "clear/write_stl.hpp"
#include "main/tier.hpp"
#include "support/test.hpp"

namespace ligne::test {
namespace {

// Parts with roundings, tessellated at any accuracy: shells through rings that are rounded rectangles.

using PartTriangles = std::vector<std::array<Point3, 3>>;

inline constexpr std::string_view kRoundedParts[] = {"plate", "tray", "tube", "arch", "elbow"};

constexpr double kQuarter = 3.14159265358979323846 / 2;

/// A rounded rectangle in the plane of two axes: half of its straight sides, and the radius of its corners.
struct Ring {
  Point3 centre;
  double half_u, half_v, radius;
  Point3 u{1, 0, 0}, v{0, 1, 0};
};

std::vector<Point3> points_of(const Ring& ring, int steps) {
  std::vector<Point3> points;
  for (int corner = 0; corner < 4; ++corner) {
    const double x = corner == 0 || corner == 3 ? ring.half_u : -ring.half_u, y = corner < 2 ? ring.half_v : -ring.half_v;
    // A circle has no straight sides: its corners share their ends.
    const int last = ring.half_u == 0 && ring.half_v == 0 ? steps - 1 : steps;
    for (int k = 0; k <= last; ++k) {
      const double turn = kQuarter * (corner + double(k) / steps);
      points.push_back(ring.centre + (x + ring.radius * std::cos(turn)) * ring.u +
                       (y + ring.radius * std::sin(turn)) * ring.v);
    }
  }
  return points;
}

void add(PartTriangles& to, const Point3& a, const Point3& b, const Point3& c) {
  if (a != b && b != c && c != a) to.push_back({a, b, c});
}

/// The shell through the rings, counter-clockwise as seen from the end, closed by a flat side at either end.
PartTriangles loft(const std::vector<Ring>& rings, int steps) {
  PartTriangles triangles;
  std::vector<Point3> below = points_of(rings.front(), steps);
  for (std::size_t i = 2; i < below.size(); ++i) add(triangles, below[0], below[i], below[i - 1]);
  for (std::size_t r = 1; r < rings.size(); ++r) {
    const std::vector<Point3> above = points_of(rings[r], steps);
    for (std::size_t i = 0; i < below.size(); ++i) {
      const std::size_t j = (i + 1) % below.size();
      add(triangles, below[i], below[j], above[j]);
      add(triangles, below[i], above[j], above[i]);
    }
    below = above;
  }
  for (std::size_t i = 2; i < below.size(); ++i) add(triangles, below[0], below[i - 1], below[i]);
  return triangles;
}

/// Rings along an arc of a profile: `out` and `up` are the centre of the arc, from the ring's straight sides and its plane.
void add_arc(std::vector<Ring>& rings, const Ring& straight, double out, double up, double radius, double from, double to,
             int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double turn = from + (to - from) * k / steps;
    Ring ring = straight;
    ring.radius = out + radius * std::cos(turn);
    ring.centre.z = up + radius * std::sin(turn);
    rings.push_back(ring);
  }
}

std::vector<Ring> plate(int steps) {
  const Ring straight{{0, 0, 0}, 17, 12, 0};
  std::vector<Ring> rings;
  add_arc(rings, straight, 0.01, 3, 3, -kQuarter, 0, steps);
  add_arc(rings, straight, 0.01, 11, 3, 0, kQuarter, steps);
  return rings;
}

std::vector<Ring> tray(int steps) {
  const Ring straight{{0, 0, 0}, 30, 18, 0};
  std::vector<Ring> rings;
  add_arc(rings, straight, 4, 4, 4, -kQuarter, -0.1, steps);                // outside at the bottom
  add_arc(rings, straight, 9, 25, 1, -0.1, 2 * kQuarter - 0.1, 2 * steps);  // rim
  add_arc(rings, straight, 3, 5, 3, -0.1, -kQuarter, steps);                // inside at the bottom
  return rings;
}

std::vector<Ring> tube(int steps) {
  const Ring straight{{0, 0, 0}, 0, 0, 0};
  std::vector<Ring> rings;
  rings.push_back({{0, 0, 0}, 0, 0, 14});
  add_arc(rings, straight, 11, 14, 3, 0, kQuarter, steps);               // rounding of the shoulder
  add_arc(rings, straight, 10, 19, 2, -kQuarter, -2 * kQuarter, steps);  // fillet above it
  rings.push_back({{0, 0, 34}, 0, 0, 8});
  rings.push_back({{0, 0, 34}, 0, 0, 5});
  rings.push_back({{0, 0, 6}, 0, 0, 5});
  return rings;
}

/// Rings of one shape round an axis of that distance, from an angle to another one.
void bend(std::vector<Ring>& rings, double half_u, double half_v, double radius, double distance, double angle, int steps) {
  for (int k = 0; k <= steps; ++k) {
    const double turn = angle * k / steps;
    rings.push_back({distance * Point3(std::cos(turn), 0, std::sin(turn)),
                     half_u,
                     half_v,
                     radius,
                     {-std::cos(turn), 0, -std::sin(turn)},
                     {0, 1, 0}});
  }
}

std::vector<Ring> arch(int steps) {
  std::vector<Ring> rings;
  bend(rings, 3, 8, 2, 25, 2 * kQuarter, 2 * steps);
  return rings;
}

std::vector<Ring> elbow(int steps) {
  std::vector<Ring> rings;
  bend(rings, 0, 0, 7, 20, kQuarter, steps);
  Ring first = rings.front(), last = rings.back();
  first.centre.z -= 15;
  last.centre.x -= 15;
  rings.insert(rings.begin(), first);
  rings.push_back(last);
  return rings;
}

/// - plate: 40 x 30 x 14 with fillets of 3 along all edges;
/// - tray: open at the top, with tapered walls, a round rim, and fillets inside and outside;
/// - tube: round, with a shoulder that has a fillet below and a rounding above, and a bore;
/// - arch: half a turn of a bar with rounded edges;
/// - elbow: a round pipe through a quarter of a turn, with straight ends.
/// `steps`: facets to a quarter of a turn of each rounding.
PartTriangles rounded_part(std::string_view name, int steps) {
  if (name == "plate") return loft(plate(steps), steps);
  if (name == "tray") return loft(tray(steps), steps);
  if (name == "tube") return loft(tube(steps), steps);
  if (name == "arch") return loft(arch(steps), steps);
  if (name == "elbow") return loft(elbow(steps), steps);
  throw std::runtime_error("no such part: " + std::string(name));
}

namespace fs = std::filesystem;

const std::string kViews[] = {"iso", "front", "right", "top"};

/// The views in which a model is drawn: in the first tier one of them, which the seed chooses.
std::vector<std::string> views_of(const std::string& model) { return chosen("clear, " + model, std::size(kViews), kViews); }

/// Cleanup closes gaps of up to twelve pens between lines that continue each other, and leads ends on by up to three
/// (docs/clear-lines.md, "Short bits").
constexpr double kLongestBridgeMm = 12 * kPenMm, kFarthestBridgeMm = 3 * kPenMm;
/// An outline of the mesh that its contour does not follow, as beyond a cusp, is as long as two edges or a spur.
constexpr int kLeftOutEdges = 2;
constexpr double kLongestSpurMm = 12 * kPenMm;
/// Before the sheet nothing is left out but bits.
constexpr double kLongestBitMm = 1.5 * kPenMm;

/// Scans have folds and grain that clear lines leave out whatever their length (docs/clear-lines.md, "Scans").
enum class Kind : std::uint8_t { exact_shape, scan };

void expect_close(const fs::path& file, const std::string& view, Kind kind,
                  const std::optional<Point3>& axis = std::nullopt) {
  SCOPED_TRACE("./ligne.sh draw " + file.string() + " --view " + view);
  const ClearDifferences found = compare_clear(file, view, axis);
  if (found.exact_mm > kLongestSpurMm) {
    EXPECT_GT(found.clear_mm, 0);
  }
  EXPECT_TRUE(found.outside.empty()) << "ink outside the body:\n" << text_of(found.outside);
  for (const Run& run : found.added)
    EXPECT_TRUE(run.length_mm <= kLongestBridgeMm && run.farthest_mm <= kFarthestBridgeMm) << "ink where no line is:\n"
                                                                                           << text_of({run});
  for (const Run& run : found.left_out) {
    if (run.layer != "outline") continue;
    const bool is_bit = run.length_mm <= (kind == Kind::scan ? kLongestSpurMm : kLongestBitMm);
    const bool is_fold = kind == Kind::scan || run.segments <= kLeftOutEdges || run.length_mm <= kLongestSpurMm;
    EXPECT_TRUE(is_bit || (is_fold && !run.before_the_sheet)) << "an outline left out:\n" << text_of({run});
  }
}

TEST(ClearAgainstExact, Corpus) {
  for (const fs::directory_entry& entry : fs::directory_iterator(LIGNE_SOURCE_DIR "/tests/corpus")) {
    if (entry.path().extension() != ".json") continue;
    for (const std::string& view : views_of(entry.path().stem())) expect_close(entry.path(), view, Kind::exact_shape);
  }
}

/// The axis about which a part was turned.
std::optional<Point3> axis_of(std::string_view part) {
  if (part == "tube") return Point3(0, 0, 1);
  if (part == "arch") return Point3(0, 1, 0);
  return std::nullopt;
}

class MadePart : public testing::TestWithParam<std::tuple<std::string_view, int>> {};

TEST_P(MadePart, IsClose) {
  const auto& [name, steps] = GetParam();
  const TemporaryFolder folder;
  const fs::path file = folder / (std::string(name) + "-" + std::to_string(steps) + ".stl");
  write_stl(rounded_part(name, steps), file);
  for (const std::string& view : views_of(std::string(name) + "-" + std::to_string(steps)))
    expect_close(file, view, Kind::exact_shape, axis_of(name));
}

INSTANTIATE_TEST_SUITE_P(ClearAgainstExact, MadePart,
                         testing::Combine(testing::ValuesIn(kRoundedParts), testing::Values(3, 4, 6, 12)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + std::to_string(std::get<1>(info.param));
                         });

class SharedModel : public testing::TestWithParam<const char*> {};

TEST_P(SharedModel, IsClose) {
  const fs::path file = fs::path(LIGNE_MODELS_DIR) / GetParam();
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string name = GetParam();
  const Kind kind = name == "stanford-bunny.obj" || name == "rocker-arm.obj" ? Kind::scan : Kind::exact_shape;
  for (const std::string& view : views_of(name)) expect_close(file, view, kind);
}

INSTANTIATE_TEST_SUITE_P(ClearAgainstExact, SharedModel,
                         testing::Values("1002_tray_bottom.stl", "2CylinderEngine.glb", "CITY.ASC", "beetle.obj",
                                         "chair_model.obj", "cornell_box.obj", "cycloidal.ply", "featuretype.stl",
                                         "no_indices_3storybuilding.glb", "octagonal_pocket.ply", "quadknot.obj",
                                         "rocker-arm.obj", "simple_pole.glb", "spider.obj", "stanford-bunny.obj",
                                         "teapot.obj"),
                         kNameOfFile);

/// A prism of n sides stands for a cylinder, from which the middles of its sides lie r (1 - cos(pi / n)) away.
TEST(MeshSags, OfAPrismIsThatOfItsCylinder) {
  constexpr int kSides = 16;
  constexpr double kRadius = 10, kTurn = 2 * 3.14159265358979323846 / kSides;
  Scene scene;
  for (int i = 0; i < 2 * kSides; ++i)
    scene.vertices.push_back({kRadius * std::cos(kTurn * (i / 2)), kRadius * std::sin(kTurn * (i / 2)), i % 2 ? 30.0 : 0.0});
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
    scene.faces.add_face(std::array{a, b, b + 1, a + 1});
  }
  scene.objects.push_back({});
  scene.objects.back().vertex_end = 2 * kSides;
  scene.objects.back().face_end = kSides;
  CameraRequest camera;
  camera.named_view = "front";
  const View view = make_view(scene, make_camera(camera, scene), {{{10, 10}, {287, 200}}}, {{0, 0}, {297, 210}});
  const MeshSags sags(scene, build_topology(scene), view, 60);
  // Each side has two edges at which it bends; the sum of two is a surface that bends both ways.
  const double rise = kRadius * (1 - std::cos(kTurn / 2)) * view.scale;
  const Point2 middle = page_point(view, {0, 0, 15});
  ASSERT_TRUE(sags.at(middle, 0));
  EXPECT_NEAR(*sags.at(middle, 0), 2 * rise, 1e-9);
  const Point2 side = page_point(view, {kRadius, 0, 15});
  EXPECT_TRUE(sags.at(side + Point2(1.9 * rise, 0), 0));
  EXPECT_FALSE(sags.at(side + Point2(2.1 * rise, 0), 0)) << "outside";
}

}  // namespace
}  // namespace ligne::test
