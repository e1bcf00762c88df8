/// --stream: a model of which a part is in memory gives the drawing of the whole, byte by byte.

#include "main/tier.hpp"
#include "program.hpp"
#include "support/mesh_text.hpp"

namespace ligne::test {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as numbers lie in memory");

/// The fewest faces of a model that is streamed.
constexpr std::uint32_t kFewest = 131'072;

/// Objects in the words of mesh_text.hpp.
std::string torus(int around, int along) {
  const std::string u = "(2*pi*u/" + std::to_string(around) + ")", v = "(2*pi*v/" + std::to_string(along) + ")";
  const std::string tube = "(2+0.2*sin(9*" + u + ")*sin(5*" + v + "))", ring = "(5+" + tube + "*cos" + v + ")";
  return "object\ngrid " + std::to_string(around) + " x " + std::to_string(along) + " triangles round ring: " + ring +
         "*cos" + u + "; " + ring + "*sin" + u + "; " + tube + "*sin" + v + "\n";
}
std::string wall(int cells, int size, int y) {
  const std::string n = std::to_string(cells), x = std::to_string(size) + "*(u/" + n + "-0.5); ";
  return "object\ngrid " + n + " x " + n + " triangles: " + x + std::to_string(y) + "; " + std::to_string(size) + "*(v/" +
         n + "-0.5)\n";
}
/// A ball of radius 1.5.
std::string ball(int x, int y, int z) {
  return "object\ngrid 40 x 20 triangles round: 1.5*sin(pi*v/20)*cos(pi*u/20); 1.5*sin(pi*v/20)*sin(pi*u/20); "
         "-1.5*cos(pi*v/20)\nmap: x+" +
         std::to_string(x) + "; y+" + std::to_string(y) + "; z+" + std::to_string(z) + "\n";
}
/// Behind a scene seen from the front: makes a model of it that is large enough.
const std::string kBoard = wall(256, 24, 12);

double uniform(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

void add_triangle(Scene& scene, std::initializer_list<Point3> corners) {
  const auto v = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), corners);
  scene.faces.add_triangle(v, v + 1, v + 2);
}

/// Adds triangles anywhere, which penetrate each other.
void add_soup(Scene& scene, std::size_t n, double size, unsigned seed) {
  std::mt19937 random(seed);
  const auto near = [&](Point3 p, double reach) {
    for (int k = 0; k < 3; ++k) p[k] += reach * uniform(random);
    return p;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point3 p = near({0, 0, 0}, 10);
    add_triangle(scene, {near(p, size), near(p, size), near(p, size)});
  }
}

std::string stl(const Scene& scene) {
  std::string bytes = std::string(80, ' ') + raw(static_cast<std::uint32_t>(scene.faces.size()));
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    bytes.append(12, '\0');  // the normal
    for (const std::uint32_t v : scene.faces.contour(f, 0))
      for (int k = 0; k < 3; ++k) bytes += raw(static_cast<float>(scene.vertices[v][k]));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string ply(const Scene& scene, const std::string& type = "float") {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(scene.vertices.size()) +
                      "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " +
                      std::to_string(scene.faces.size()) +
                      "\nproperty uchar shade\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Point3& p : scene.vertices)
    for (int k = 0; k < 3; ++k) bytes += type == "double" ? raw(p[k]) : raw(static_cast<float>(p[k]));
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    bytes += "\7\3";
    for (const std::uint32_t v : scene.faces.contour(f, 0)) bytes += raw(v);
  }
  return bytes;
}

class StreamTest : public DrawTest {
 protected:
  /// The drawing of what is in memory as a whole and that of what is streamed are one; returns what part of the facets the
  /// latter's study had.
  double same_drawing(const std::string& model, const Words& options) const {
    const auto drawing = [&](const std::string& name, const Words& more) {
      const Outcome outcome = run_well(Words{"draw", model, "--quality", "exact", "--method", "appel"} + options + more +
                                       Words{"-o", name + ".svg", "--stats-json", name + ".json"});
      return outcome.err;
    };
    const std::string whole = drawing("whole", "--stream off");
    for (const char* threads : chosen("threads, " + model + std::to_string(options.size()), 2, {"1", "2"})) {
      EXPECT_EQ(drawing("part", {"--stream", "on", "--threads", threads}), whole);
      EXPECT_TRUE(contents(file("part.svg")) == contents(file("whole.svg"))) << model << " with " << threads << " threads";
    }
    const auto facets = [&](const std::string& name) {
      return json::parse(contents(file(name + ".json")))["counts"]["facets"].get<double>();
    };
    return facets("part") / facets("whole");
  }

  struct Drawing {
    Words options;
    double most = 1;  ///< part of the facets that the streamed study may have
  };
  /// In the first tier one of two drawings.
  void same_drawings(const std::string& model, const std::vector<Drawing>& drawings) const {
    for (const Drawing& drawing : chosen("streams, " + model, 2, drawings))
      EXPECT_LE(same_drawing(model, drawing.options), drawing.most) << model;
  }
};

TEST_F(StreamTest, ATorusIsDrawnByThePartsWhereThereAreLines) {
  const Scene scene = mesh_of(torus(512, 200)).scene();
  write("torus.stl", stl(scene));
  write("torus.ply", ply(scene));
  write("double.ply", ply(scene, "double"));
  for (const char* model : chosen("torus", 3, {"torus.stl", "torus.ply", "double.ply"}))
    EXPECT_LT(same_drawing(model, {}), 0.25) << model;
  for (const Drawing& drawing :
       chosen("views of the torus", 3,
              {Drawing{"--view front", 0.2}, {"--eye 20,-15,12", 0.2}, {"--edges all", 0.65}})) {  // what is behind
    EXPECT_LT(same_drawing("torus.ply", drawing.options), drawing.most);
  }
}

TEST_F(StreamTest, BallsBeforeAndBehindAWall) {
  std::string scene = wall(60, 20, 0);
  for (int at = -7; at < 8; at += 2) scene += ball(at, 3, at) + ball(-at, -4, at);
  write("scene.ply", ply(mesh_of(scene + kBoard).scene()));
  same_drawings(
      "scene.ply",
      {{"--view front", 0.15}, {"--view back --crease 5"}, {"--edges border,crease"}, {"--eye 4,-80,9 --min-length 1mm"}});
}

TEST_F(StreamTest, SurfacesThatPenetrate) {
  const std::string tilted = "map: x+5; y*cos(1.3)-z*sin(1.3); y*sin(1.3)+z*cos(1.3)+0.3\n";
  write("scene.stl", stl(mesh_of(torus(120, 60) + torus(120, 60) + tilted + wall(30, 16, 1) + kBoard).scene()));
  same_drawings("scene.stl", {{{}, 0.15}, {"--edges intersection"}});
  for (unsigned seed = 1; seed <= 3; ++seed) {
    if (!is_chosen("stream", seed, 3)) continue;
    Scene soup = mesh_of(kBoard).scene();
    add_soup(soup, 3000, 1.5, seed);
    write("soup.stl", stl(soup));
    same_drawings("soup.stl", {{}, {"--edges all --view top"}});
  }
}

TEST_F(StreamTest, FacesWithoutAreaAndFacesStoredTwice) {
  Scene scene = mesh_of(torus(80, 40) + kBoard).scene();
  for (std::size_t i = 0; i < 80 * 40 * 2; i += 7) {
    const auto contour = scene.faces.contour(i, 0);
    const std::array<std::uint32_t, 3> t{contour[0], contour[1], contour[2]};
    scene.faces.add_triangle(t[0], t[1], t[2]);
    scene.faces.add_triangle(t[0], t[0], t[1]);
    scene.vertices.push_back(scene.vertices[t[1]]);
    scene.faces.add_triangle(t[0], static_cast<std::uint32_t>(scene.vertices.size() - 1), t[2]);
  }
  write("scene.ply", ply(scene));
  same_drawings("scene.ply", {{}, {"--edges all"}});
}

TEST_F(StreamTest, CrowdsStayWhole) {
  // Long needles that come out from behind a wall, where their ends crowd together in hundreds of places.
  Scene scene = mesh_of(wall(50, 20, 0) + kBoard).scene();
  std::mt19937 random(5);
  const auto off = [&](double size) { return size * (uniform(random) - 0.5); };
  for (int crowd = 0; crowd < 60; ++crowd) {
    const Point3 end{off(18), 2, off(18)};
    for (int i = 0; i < 40; ++i) {
      const double reach = i < 2 ? 30 : 0.3;  // of two in each crowd the other end is seen
      add_triangle(scene, {end + Point3{off(4e-6), 0, off(4e-6)}, end + Point3{off(4e-6), 0, off(4e-6)},
                           end + Point3{off(reach), uniform(random), off(reach)}});
    }
  }
  write("scene.ply", ply(scene, "double"));
  same_drawing("scene.ply", "--view front");
}

TEST_F(StreamTest, TakenWhereTheModelWouldFillHalfOfTheMemory) {
  write("torus.stl", stl(mesh_of(torus(500, 250)).scene()));
  const auto choice = [&](const std::string& limit) {
    EXPECT_EQ(
        run({"draw", "torus.stl", "--quality", "exact", "--max-memory", limit, "-o", "a.svg", "--stats-json", "a.json"})
            .status,
        kDone);
    return json::parse(contents(file("a.json")))["stages"].contains("find covers");
  };
  EXPECT_TRUE(choice("60M"));
  EXPECT_FALSE(choice("1G"));
}

TEST_F(StreamTest, RefusesWhatItCanNotDraw) {
  Scene scene = mesh_of(torus(20, 10)).scene();
  write("torus.stl", stl(scene));
  const auto refused = [&](const Words& options, const std::string& why, int status = kUsage) {
    const Outcome outcome = run("draw" + options + "--stream on -o a.svg");
    EXPECT_EQ(outcome.status, status);
    expect_parts(outcome.err, {why});
    EXPECT_EQ(outcome.error_lines(), 1u);
    EXPECT_FALSE(exists("a.svg"));
  };
  refused("torus.stl", "clear lines");
  refused("torus.stl --quality exact --hidden dashed", "hidden lines");
  refused("torus.stl --quality exact --method watkins", "only method appel");
  refused("torus.stl torus.stl --quality exact", "several models");
  refused("torus.stl --quality exact", "it has fewer than " + std::to_string(kFewest) + " faces");
  write("large.stl", stl(mesh_of(kBoard).scene()));
  refused("large.stl --quality exact --scale 100:1", "out of view");
  refused("cube.obj --quality exact", "neither binary STL nor binary PLY");
  std::string bytes = stl(scene);
  const float nan = std::nanf("");
  std::memcpy(&bytes[84 + 50 * 3 + 12], &nan, sizeof nan);
  write("nan.stl", bytes);
  refused("nan.stl --quality exact", "nan.stl: triangle 3 of 400: a coordinate is not finite", kFailed);
  scene.faces.corners()[3 * 5 + 1] = 200;
  write("wrong.ply", ply(scene));
  refused("wrong.ply --quality exact", "wrong.ply: face 5 names vertex 200 of 200", kFailed);
}

}  // namespace
}  // namespace ligne::test
