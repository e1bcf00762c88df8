/// --stream: a model of which a part is in memory gives the drawing of the whole, byte by byte.

#include "draw_program.hpp"
#include "main/tier.hpp"

namespace ligne::test {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as numbers lie in memory");

using Corner = std::array<double, 3>;

struct Mesh {
  std::vector<Corner> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A grid of around x along quadrilaterals; `closed_u`, `closed_v`: its sides are joined.
Mesh grid(std::uint32_t around, std::uint32_t along, bool closed_u, bool closed_v,
          const std::function<Corner(double, double)>& place) {
  Mesh mesh;
  const std::uint32_t columns = closed_u ? around : around + 1, rows = closed_v ? along : along + 1;
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) mesh.vertices.push_back(place(double(i) / around, double(j) / along));
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t i1 = (i + 1) % columns, j1 = (j + 1) % rows;
      const std::uint32_t a = j * columns + i, b = j * columns + i1, c = j1 * columns + i1, d = j1 * columns + i;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

/// The fewest faces of a model that is streamed.
constexpr std::uint32_t kFewest = 131'072;

Mesh bumpy_torus(std::uint32_t around, std::uint32_t along, Corner middle = {0, 0, 0}, double tilt = 0) {
  constexpr double kTurn = 2 * 3.14159265358979323846;
  return grid(around, along, true, true, [=](double u, double v) {
    const double tube = 2 + 0.2 * std::sin(9 * kTurn * u) * std::sin(5 * kTurn * v), ring = 5 + tube * std::cos(kTurn * v);
    const double x = ring * std::cos(kTurn * u), y = ring * std::sin(kTurn * u), z = tube * std::sin(kTurn * v);
    return Corner{x + middle[0], y * std::cos(tilt) - z * std::sin(tilt) + middle[1],
                  y * std::sin(tilt) + z * std::cos(tilt) + middle[2]};
  });
}

Mesh ball(std::uint32_t around, double radius, Corner middle) {
  constexpr double kTurn = 2 * 3.14159265358979323846;
  return grid(around, around / 2, true, false, [=](double u, double v) {
    const double s = std::sin(kTurn * v / 2);
    return Corner{middle[0] + radius * s * std::cos(kTurn * u), middle[1] + radius * s * std::sin(kTurn * u),
                  middle[2] - radius * std::cos(kTurn * v / 2)};
  });
}

Mesh wall(std::uint32_t cells, double size, double y) {
  return grid(cells, cells, false, false, [=](double u, double v) { return Corner{size * (u - 0.5), y, size * (v - 0.5)}; });
}

void add(Mesh& mesh, const Mesh& other) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

/// Behind a scene seen from the front: makes a model of it that is large enough.
void add_board(Mesh& scene) { add(scene, wall(256, 24, 12)); }

/// Triangles anywhere, which penetrate each other.
Mesh soup(std::size_t n, double size, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Mesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Corner p{10 * uniform(), 10 * uniform(), 10 * uniform()};
    for (int k = 0; k < 3; ++k)
      mesh.vertices.push_back({p[0] + size * uniform(), p[1] + size * uniform(), p[2] + size * uniform()});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

std::string stl(const Mesh& mesh) {
  std::string bytes(80, ' ');
  put(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) put(bytes, 0.0f);
    for (const std::uint32_t v : t)
      for (const double c : mesh.vertices[v]) put(bytes, static_cast<float>(c));
    put(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string ply(const Mesh& mesh, const std::string& type = "float") {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(mesh.vertices.size()) +
                      "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " +
                      std::to_string(mesh.triangles.size()) +
                      "\nproperty uchar shade\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Corner& p : mesh.vertices)
    for (const double c : p) type == "double" ? put(bytes, c) : put(bytes, static_cast<float>(c));
  for (const auto& t : mesh.triangles) {
    put(bytes, std::uint8_t{7});
    put(bytes, std::uint8_t{3});
    for (const std::uint32_t v : t) put(bytes, v);
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
  const Mesh torus = bumpy_torus(512, 200);
  write("torus.stl", stl(torus));
  write("torus.ply", ply(torus));
  write("double.ply", ply(torus, "double"));
  for (const char* model : chosen("torus", 3, {"torus.stl", "torus.ply", "double.ply"}))
    EXPECT_LT(same_drawing(model, {}), 0.25) << model;
  for (const Drawing& drawing :
       chosen("views of the torus", 3,
              {Drawing{"--view front", 0.2}, {"--eye 20,-15,12", 0.2}, {"--edges all", 0.65}})) {  // what is behind
    EXPECT_LT(same_drawing("torus.ply", drawing.options), drawing.most);
  }
}

TEST_F(StreamTest, BallsBeforeAndBehindAWall) {
  Mesh scene = wall(60, 20, 0);
  for (int i = 0; i < 8; ++i) {
    add(scene, ball(40, 1.5, {-7 + 2.0 * i, 3, -7 + 2.0 * i}));
    add(scene, ball(40, 1.5, {7 - 2.0 * i, -4, -7 + 2.0 * i}));
  }
  add_board(scene);
  write("scene.ply", ply(scene));
  same_drawings(
      "scene.ply",
      {{"--view front", 0.15}, {"--view back --crease 5"}, {"--edges border,crease"}, {"--eye 4,-80,9 --min-length 1mm"}});
}

TEST_F(StreamTest, SurfacesThatPenetrate) {
  Mesh scene = bumpy_torus(120, 60);
  add(scene, bumpy_torus(120, 60, {5, 0, 0.3}, 1.3));
  add(scene, wall(30, 16, 1));
  add_board(scene);
  write("scene.stl", stl(scene));
  same_drawings("scene.stl", {{{}, 0.15}, {"--edges intersection"}});
  for (unsigned seed = 1; seed <= 3; ++seed) {
    if (!is_chosen("stream", seed, 3)) continue;
    Mesh triangles = soup(3000, 1.5, seed);
    add_board(triangles);
    write("soup.stl", stl(triangles));
    same_drawings("soup.stl", {{}, {"--edges all --view top"}});
  }
}

TEST_F(StreamTest, FacesWithoutAreaAndFacesStoredTwice) {
  Mesh scene = bumpy_torus(80, 40);
  const std::size_t n = scene.triangles.size();
  for (std::size_t i = 0; i < n; i += 7) {
    const auto t = scene.triangles[i];
    scene.triangles.push_back(t);
    scene.triangles.push_back({t[0], t[0], t[1]});
    scene.vertices.push_back(scene.vertices[t[1]]);
    scene.triangles.push_back({t[0], static_cast<std::uint32_t>(scene.vertices.size() - 1), t[2]});
  }
  add_board(scene);
  write("scene.ply", ply(scene));
  same_drawings("scene.ply", {{}, {"--edges all"}});
}

TEST_F(StreamTest, CrowdsStayWhole) {
  // Long needles that come out from behind a wall, where their ends crowd together in hundreds of places.
  Mesh scene = wall(50, 20, 0);
  std::mt19937 random(5);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int crowd = 0; crowd < 60; ++crowd) {
    const Corner end{18 * (uniform() - 0.5), 2, 18 * (uniform() - 0.5)};
    for (int i = 0; i < 40; ++i) {
      const auto v = static_cast<std::uint32_t>(scene.vertices.size());
      const double reach = i < 2 ? 30 : 0.3;  // of two in each crowd the other end is seen
      for (int k = 0; k < 2; ++k) scene.vertices.push_back({end[0] + 4e-6 * uniform(), 2, end[2] + 4e-6 * uniform()});
      scene.vertices.push_back({end[0] + reach * (uniform() - 0.5), 2 + uniform(), end[2] + reach * (uniform() - 0.5)});
      scene.triangles.push_back({v, v + 1, v + 2});
    }
  }
  add_board(scene);
  write("scene.ply", ply(scene, "double"));
  same_drawing("scene.ply", "--view front");
}

TEST_F(StreamTest, TakenWhereTheModelWouldFillHalfOfTheMemory) {
  write("torus.stl", stl(bumpy_torus(500, 250)));
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
  const Mesh torus = bumpy_torus(20, 10);
  write("torus.stl", stl(torus));
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
  write("large.stl", stl(wall(256, 24, 0)));
  refused("large.stl --quality exact --scale 100:1", "out of view");
  refused("cube.obj --quality exact", "neither binary STL nor binary PLY");
  std::string bytes = stl(torus);
  const float nan = std::nanf("");
  std::memcpy(&bytes[84 + 50 * 3 + 12], &nan, sizeof nan);
  write("nan.stl", bytes);
  refused("nan.stl --quality exact", "nan.stl: triangle 3 of 400: a coordinate is not finite", kFailed);
  Mesh wrong = torus;
  wrong.triangles[5][1] = 200;
  write("wrong.ply", ply(wrong));
  refused("wrong.ply --quality exact", "wrong.ply: face 5 names vertex 200 of 200", kFailed);
}

}  // namespace
}  // namespace ligne::test
