#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include "inputs.hpp"

namespace ligne::bench {

namespace {

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec3 operator*(double s, const Vec3& a) { return {s * a[0], s * a[1], s * a[2]}; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 unit(const Vec3& a) { return (1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])) * a; }

/// An edge of the mesh under subdivision.
struct SplitEdge {
  std::uint32_t a = 0, b = 0;  ///< a < b
  std::uint32_t faces = 0;
  Vec3 opposite{0, 0, 0};  ///< sum of the corners opposite to it
  bool open() const { return faces != 2; }
};

/// All edges in the order of (a, b), and of each triangle the edges opposite to its corners.
std::pair<std::vector<SplitEdge>, std::vector<Corner3>> find_edges(const TriangleMesh& mesh) {
  struct Side {
    std::uint32_t a, b, triangle, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(mesh.triangles[t][(k + 1) % 3], mesh.triangles[t][(k + 2) % 3]);
      sides.push_back({a, b, t, k});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& l, const Side& r) {
    return std::pair(std::pair(l.a, l.b), l.triangle) < std::pair(std::pair(r.a, r.b), r.triangle);
  });
  std::vector<SplitEdge> edges;
  std::vector<Corner3> edge_of(mesh.triangles.size());
  for (const Side& s : sides) {
    if (edges.empty() || edges.back().a != s.a || edges.back().b != s.b) edges.push_back({s.a, s.b, 0, {0, 0, 0}});
    SplitEdge& e = edges.back();
    ++e.faces;
    e.opposite = e.opposite + mesh.positions[mesh.triangles[s.triangle][s.corner]];
    edge_of[s.triangle][s.corner] = static_cast<std::uint32_t>(edges.size() - 1);
  }
  return {std::move(edges), std::move(edge_of)};
}

/// cos and sin of i / 2^bits of a full turn, from half-angle formulas.
class UnitCircle {
 public:
  explicit UnitCircle(int bits) : bits_(bits) {
    std::array<double, 2> half{-1, 0};
    for (int k = 0; k < bits; ++k) {
      turns_.push_back(half);
      half = k == 0 ? std::array<double, 2>{0, 1}
                    : std::array<double, 2>{std::sqrt((1 + half[0]) / 2), half[1] / std::sqrt(2 * (1 + half[0]))};
    }
  }
  std::array<double, 2> operator()(std::uint64_t i) const {
    std::array<double, 2> z{1, 0};
    for (int k = 0; k < bits_; ++k) {
      if ((i >> (bits_ - 1 - k)) & 1u) {
        const auto& w = turns_[static_cast<std::size_t>(k)];
        z = {z[0] * w[0] - z[1] * w[1], z[0] * w[1] + z[1] * w[0]};
      }
    }
    return z;
  }

 private:
  int bits_;
  std::vector<std::array<double, 2>> turns_;  ///< 1/2, 1/4, 1/8, ... of a turn
};

}  // namespace

TriangleMesh read_obj(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": can not be opened");
  TriangleMesh mesh;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const bool vertex = line.starts_with("v "), face = line.starts_with("f ");
    if (!vertex && !face) continue;
    std::vector<double> values;
    std::size_t at = 2;
    while ((at = line.find_first_not_of(" \t\r", at)) != std::string::npos) {
      double value = 0;
      if (std::from_chars(line.data() + at, line.data() + line.size(), value).ec != std::errc()) {
        throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": a number is expected");
      }
      values.push_back(value);
      at = std::min(line.find_first_of(" \t\r", at), line.size());
    }
    if (values.size() < 3)
      throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": three values are expected");
    if (vertex) {
      mesh.positions.push_back({values[0], values[1], values[2]});
      continue;
    }
    for (double v : values) {
      if (!(v >= 1 && v <= static_cast<double>(mesh.positions.size()))) {
        throw std::runtime_error(file.string() + ":" + std::to_string(number) + ": no vertex of that number");
      }
    }
    const auto index = [&](std::size_t k) { return static_cast<std::uint32_t>(values[k]) - 1; };
    for (std::size_t k = 2; k < values.size(); ++k) mesh.triangles.push_back({index(0), index(k - 1), index(k)});
  }
  return mesh;
}

TriangleMesh subdivide(const TriangleMesh& mesh) {
  const auto [edges, edge_of] = find_edges(mesh);
  const std::size_t n = mesh.positions.size();
  struct Ring {
    Vec3 sum{0, 0, 0};
    double count = 0;
  };
  std::vector<Ring> inner(n), open(n);  // neighbours along all edges, along open ones
  std::vector<std::uint8_t> fixed(n, 0);
  TriangleMesh fine;
  fine.positions.resize(n + edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const SplitEdge& e = edges[i];
    const Vec3 &pa = mesh.positions[e.a], &pb = mesh.positions[e.b];
    for (auto* rings : {&inner, &open}) {
      if (rings == &open && !e.open()) continue;
      Ring &a = (*rings)[e.a], &b = (*rings)[e.b];
      a.sum = a.sum + pb, b.sum = b.sum + pa;
      ++a.count, ++b.count;
    }
    if (e.faces > 2) fixed[e.a] = fixed[e.b] = 1;
    fine.positions[n + i] = e.open() ? 0.5 * (pa + pb) : 0.375 * (pa + pb) + 0.125 * e.opposite;
  }
  for (std::size_t v = 0; v < n; ++v) {
    const Vec3& p = mesh.positions[v];
    if (fixed[v] || inner[v].count == 0 || (open[v].count != 0 && open[v].count != 2)) {
      fine.positions[v] = p;
    } else if (open[v].count == 2) {
      fine.positions[v] = 0.75 * p + 0.125 * open[v].sum;
    } else {
      const double beta = inner[v].count == 3 ? 3.0 / 16 : 3 / (8 * inner[v].count);
      fine.positions[v] = (1 - inner[v].count * beta) * p + beta * inner[v].sum;
    }
  }
  fine.triangles.reserve(4 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const auto middle = [&, t = t](std::size_t k) { return static_cast<std::uint32_t>(n + edge_of[t][k]); };
    fine.triangles.push_back({a, middle(2), middle(1)});
    fine.triangles.push_back({middle(2), b, middle(0)});
    fine.triangles.push_back({middle(1), middle(0), c});
    fine.triangles.push_back({middle(0), middle(1), middle(2)});
  }
  return fine;
}

TriangleMesh torus_knot(int log2_along, int log2_around) {
  constexpr double kRing = 2, kPipe = 1, kTube = 0.45;
  constexpr std::uint64_t kTurns = 2, kWindings = 3;
  const std::uint64_t along = 1ull << log2_along, around = 1ull << log2_around;
  const UnitCircle circle_along(log2_along), circle_around(log2_around);
  TriangleMesh mesh;
  for (std::uint64_t i = 0; i < along; ++i) {
    const auto [cu, su] = circle_along(i * kTurns % along);
    const auto [cv, sv] = circle_along(i * kWindings % along);
    const double radius = kRing + kPipe * cv;
    const Vec3 centre{radius * cu, radius * su, kPipe * sv};
    const double du = static_cast<double>(kTurns), dv = static_cast<double>(kWindings);
    const Vec3 tangent =
        unit({-kPipe * dv * sv * cu - du * radius * su, -kPipe * dv * sv * su + du * radius * cu, kPipe * dv * cv});
    const Vec3 normal{cv * cu, cv * su, sv};  // of the torus, so at right angles with the curve
    const Vec3 binormal = cross(tangent, normal);
    for (std::uint64_t j = 0; j < around; ++j) {
      const auto [c, s] = circle_around(j);
      mesh.positions.push_back(centre + kTube * (c * normal + s * binormal));
    }
  }
  const auto index = [&](std::uint64_t i, std::uint64_t j) {
    return static_cast<std::uint32_t>((i % along) * around + j % around);
  };
  for (std::uint64_t i = 0; i < along; ++i) {
    for (std::uint64_t j = 0; j < around; ++j) {
      mesh.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace ligne::bench
