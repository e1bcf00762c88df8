/// Directions of principal curvature, evened out:
///
/// 1. Normals are evened out, so that small bumps do not count. Of each triangle the second fundamental form that fits the
///    change of the normals along its sides; at a node the mean of those of its triangles ([Rusinkiewicz2004], with forms
///    kept as tensors of space).
/// 2. A cross at the angle a in the tangent plane is the number exp(4 i a): quarter turns leave it as it is. Crosses z that
///    differ little from those of the curvature, the less the more it tells, and from their neighbours' are the least of
///    sum area c |z - u|^2 + length^2 sum w |z_i - turn_ij z_j|^2, one linear system, solved by conjugate gradients.
/// 3. Which of the cross's two directions is the first: neighbours agree along a spanning tree in which the surest of them
///    come first, and each tree has the direction in which the surface bends most.
/// 4. The first directions alone, as numbers exp(2 i a) that half turns leave as they are, are evened out once more: where
///    neighbours could not agree, strokes bend.

#include "picture/form_field.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "geometry/disjoint_sets.hpp"
#include "geometry/parallel.hpp"
#include "geometry/stop.hpp"

namespace ligne {
namespace {

using Complex = std::complex<double>;

// Adjustable.
constexpr double kFlatTurn = 0.02;        ///< radians over `length`: what bends less tells no direction
constexpr double kNormalPart = 0.5;       ///< of `length`: smaller bumps do not count
constexpr std::size_t kMostRounds = 300;  ///< of conjugate gradients: so many edges directions reach into flat parts
constexpr double kResidual = 1e-4;        ///< part of the first residual: directions, nothing that is hidden

constexpr double kQuarter = std::numbers::pi / 2;

struct TangentFrame {
  Point3 x{0, 0, 0}, y{0, 0, 0};
};

TangentFrame frame_of(const Point3& normal) {
  if (glm::dot(normal, normal) == 0) return {};
  const Point3 size = glm::abs(normal);
  const Point3 least = size.x <= size.y && size.x <= size.z ? Point3{1, 0, 0}
                       : size.y <= size.z                   ? Point3{0, 1, 0}
                                                            : Point3{0, 0, 1};
  const Point3 x = glm::normalize(glm::cross(normal, least));
  return {x, glm::cross(normal, x)};
}

double angle_in(const TangentFrame& frame, const Point3& direction) {
  return std::atan2(glm::dot(direction, frame.y), glm::dot(direction, frame.x));
}

/// Neighbouring nodes i < j; `turn` carries a cross of j to i.
struct Link {
  std::uint32_t i, j;
  double weight;
  double angle;  ///< by which directions of j are turned to be those of i
};

std::vector<Link> links_of(const FormMesh& mesh, const std::vector<TangentFrame>& frames) {
  std::vector<Link> links;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = glm::length(mesh.area_vector(t));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t].node[k], b = mesh.triangles[t].node[(k + 1) % 3];
      const Point3 side = mesh.points[b] - mesh.points[a];
      const double square = glm::dot(side, side);
      if (!(area > 0) || !(square > 0)) continue;
      // The weight of a side in a mesh of equilateral triangles, of which each has a half; above zero in any mesh.
      links.push_back({std::min(a, b), std::max(a, b), area / (3 * square), 0});
    }
  }
  parallel_sort(links.begin(), links.end(),
                [](const Link& a, const Link& b) { return std::tie(a.i, a.j, a.weight) < std::tie(b.i, b.j, b.weight); });
  std::size_t kept = 0;
  for (std::size_t l = 0; l < links.size(); ++l) {
    if (kept > 0 && links[kept - 1].i == links[l].i && links[kept - 1].j == links[l].j) {
      links[kept - 1].weight += links[l].weight;
    } else {
      links[kept++] = links[l];
    }
  }
  links.resize(kept);
  for (Link& link : links) {
    const Point3 side = mesh.points[link.j] - mesh.points[link.i];
    link.angle = angle_in(frames[link.i], side) - angle_in(frames[link.j], side);
  }
  return links;
}

/// The z that make sum weight_i |z_i - wanted_i|^2 + length^2 sum w |z_i - turn^symmetry z_j|^2 least: values of nodes,
/// evened out. Values that turn as the frames do have the symmetry of what they stand for, others 0.
std::vector<Complex> evened(const std::vector<double>& weights, const std::vector<Complex>& wanted,
                            const std::vector<Link>& links, double length, int symmetry) {
  const std::size_t n = weights.size();
  std::vector<double> diagonal = weights;
  std::vector<Complex> z(n), residual(n), way(n), image(n);
  std::vector<Complex> turns;
  for (std::size_t i = 0; i < n; ++i) residual[i] = weights[i] * wanted[i];
  for (const Link& link : links) {
    const double weight = length * length * link.weight;
    turns.push_back(std::polar(weight, symmetry * link.angle));
    diagonal[link.i] += weight;
    diagonal[link.j] += weight;
  }
  const auto conditioned = [&](std::size_t i) { return diagonal[i] > 0 ? residual[i] / diagonal[i] : Complex{}; };
  const auto product = [&](const auto& a, const auto& b) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += (std::conj(a(i)) * b(i)).real();
    return sum;
  };
  const auto residual_at = [&](std::size_t i) { return residual[i]; };
  for (std::size_t i = 0; i < n; ++i) way[i] = conditioned(i);
  double size = product(residual_at, conditioned);
  const double enough = size * kResidual * kResidual;
  for (std::size_t round = 0; round < kMostRounds && size > enough; ++round) {
    check_stop();
    for (std::size_t i = 0; i < n; ++i) image[i] = diagonal[i] * way[i];
    for (std::size_t l = 0; l < links.size(); ++l) {
      image[links[l].i] -= turns[l] * way[links[l].j];
      image[links[l].j] -= std::conj(turns[l]) * way[links[l].i];
    }
    const double bend = product([&](std::size_t i) { return way[i]; }, [&](std::size_t i) { return image[i]; });
    if (!(bend > 0)) break;
    for (std::size_t i = 0; i < n; ++i) {
      z[i] += size / bend * way[i];
      residual[i] -= size / bend * image[i];
    }
    const double before = std::exchange(size, product(residual_at, conditioned));
    for (std::size_t i = 0; i < n; ++i) way[i] = conditioned(i) + size / before * way[i];
  }
  return z;
}

/// Normals without the bumps that are smaller than `length`.
std::vector<Point3> evened_normals(const FormMesh& mesh, const std::vector<Link>& links, double length) {
  std::vector<Complex> xy, z;
  for (const Point3& normal : mesh.normals) {
    xy.emplace_back(normal.x, normal.y);
    z.emplace_back(normal.z, 0);
  }
  xy = evened(mesh.areas, xy, links, length, 0);
  z = evened(mesh.areas, z, links, length, 0);
  std::vector<Point3> normals;
  for (std::size_t n = 0; n < xy.size(); ++n) normals.push_back(unit({xy[n].real(), xy[n].imag(), z[n].real()}));
  return normals;
}

/// xx, xy, xz, yy, yz, zz of a symmetric matrix.
using Tensor = std::array<double, 6>;

double applied(const Tensor& t, const Point3& a, const Point3& b) {
  return t[0] * a.x * b.x + t[1] * (a.x * b.y + a.y * b.x) + t[2] * (a.x * b.z + a.z * b.x) + t[3] * a.y * b.y +
         t[4] * (a.y * b.z + a.z * b.y) + t[5] * a.z * b.z;
}

/// The second fundamental form (e, f, g) in the frame that fits the changes of the normals along the sides best: normal
/// equations of e x + f y = n.x and f x + g y = n.y, which have a solution for a triangle that has an area.
std::array<double, 3> fitted_form(const FormMesh& mesh, const std::vector<Point3>& normals, std::uint32_t t,
                                  const TangentFrame& frame) {
  double xx = 0, xy = 0, yy = 0, right[3] = {0, 0, 0};
  for (int k = 0; k < 3; ++k) {
    const Point3 side = mesh.point(t, (k + 1) % 3) - mesh.point(t, k);
    const Point3 turn = normals[mesh.triangles[t].node[(k + 1) % 3]] - normals[mesh.triangles[t].node[k]];
    const double x = glm::dot(side, frame.x), y = glm::dot(side, frame.y);
    const double nx = glm::dot(turn, frame.x), ny = glm::dot(turn, frame.y);
    xx += x * x;
    xy += x * y;
    yy += y * y;
    right[0] += x * nx;
    right[1] += y * nx + x * ny;
    right[2] += y * ny;
  }
  // | xx xy 0; xy xx+yy xy; 0 xy yy | (e f g) = right
  const double det = xx * ((xx + yy) * yy - xy * xy) - xy * xy * yy;
  if (!(det > 0)) return {0, 0, 0};
  const double e = right[0] * ((xx + yy) * yy - xy * xy) - xy * (right[1] * yy - xy * right[2]);
  const double f = xx * (right[1] * yy - xy * right[2]) - right[0] * xy * yy;
  const double g = xx * ((xx + yy) * right[2] - right[1] * xy) - xy * (xy * right[2]) + right[0] * xy * xy;
  return {e / det, f / det, g / det};
}

std::vector<Tensor> curvatures(const FormMesh& mesh, const std::vector<Point3>& normals) {
  std::vector<Tensor> sums(mesh.points.size(), Tensor{});
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Point3 area = mesh.area_vector(t);
    const double size = glm::length(area);
    if (!(size > 0)) continue;
    const TangentFrame frame = frame_of(area / size);
    const auto [e, f, g] = fitted_form(mesh, normals, t, frame);
    Tensor tensor{};
    std::size_t at = 0;
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) {
        tensor[at++] = e * frame.x[i] * frame.x[j] + f * (frame.x[i] * frame.y[j] + frame.y[i] * frame.x[j]) +
                       g * frame.y[i] * frame.y[j];
      }
    }
    for (const std::uint32_t node : mesh.triangles[t].node) {
      for (std::size_t i = 0; i < tensor.size(); ++i) sums[node][i] += tensor[i] * (size / 6);
    }
  }
  for (std::uint32_t n = 0; n < sums.size(); ++n) {
    for (double& value : sums[n]) value = mesh.areas[n] > 0 ? value / mesh.areas[n] : 0;
  }
  return sums;
}

/// What the curvature tells of a node.
struct Told {
  Complex cross{0, 0};  ///< of unit length, or zero
  double weight = 0;    ///< area times how much it tells, at most 1
  double first = 0;     ///< angle of the direction that bends most
  double first_weight = 0;
};

/// Both principal curvatures turn the normal by at most these radians over `length`; more of it tells no more.
double trust(double difference, double length) {
  const double turn = std::min(1.0, difference * length);
  return turn < kFlatTurn ? 0 : turn;
}

std::vector<Told> tell(const FormMesh& mesh, const std::vector<TangentFrame>& frames, const std::vector<Link>& links,
                       double length) {
  const std::vector<Tensor> tensors = curvatures(mesh, evened_normals(mesh, links, kNormalPart * length));
  std::vector<Told> told(tensors.size());
  for (std::uint32_t n = 0; n < told.size(); ++n) {
    const double e = applied(tensors[n], frames[n].x, frames[n].x), f = applied(tensors[n], frames[n].x, frames[n].y),
                 g = applied(tensors[n], frames[n].y, frames[n].y);
    const double difference = std::hypot(e - g, 2 * f), mean = e + g;  // k1 - k2, k1 + k2
    if (!(difference > 0)) continue;
    const double larger = std::atan2(2 * f, e - g) / 2;  // direction of the larger curvature, sign and all
    told[n].first = mean >= 0 ? larger : larger + kQuarter;
    told[n].cross = std::polar(1.0, 4 * larger);
    told[n].weight = mesh.areas[n] * trust(difference, length);
    told[n].first_weight = mesh.areas[n] * trust(std::min(difference, std::abs(mean)), length);  // |k1| - |k2|
  }
  return told;
}

/// Of each node whether its first direction is a quarter turn beyond the angle of the cross (see step 3).
std::vector<char> first_directions(const std::vector<double>& angles, const std::vector<char>& known,
                                   const std::vector<Told>& told, const std::vector<Link>& links) {
  const std::size_t n = angles.size();
  std::vector<std::uint32_t> order(links.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto sureness = [&](std::uint32_t l) {
    return std::min(told[links[l].i].first_weight, told[links[l].j].first_weight);
  };
  parallel_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = sureness(a), y = sureness(b);
    return x != y ? x > y : a < b;
  });
  DisjointSets trees(n);
  std::vector<std::vector<std::pair<std::uint32_t, char>>> branches(n);
  for (const std::uint32_t l : order) {
    const Link& link = links[l];
    if (!known[link.i] || !known[link.j] || trees.find(link.i) == trees.find(link.j)) continue;
    trees.join(link.i, link.j);
    const bool quarter = std::abs(std::cos(angles[link.i] - angles[link.j] - link.angle)) < std::sqrt(0.5);
    branches[link.i].emplace_back(link.j, quarter);
    branches[link.j].emplace_back(link.i, quarter);
  }
  std::vector<char> turned(n, 0), seen(n, 0);
  std::vector<std::uint32_t> tree;
  for (std::uint32_t root = 0; root < n; ++root) {
    if (seen[root]) continue;
    seen[root] = 1;
    tree.assign(1, root);
    double for_turn = 0;
    for (std::size_t k = 0; k < tree.size(); ++k) {
      const std::uint32_t at = tree[k];
      const double cosine = std::cos(told[at].first - angles[at]);
      for_turn += told[at].first_weight * (turned[at] ? -1 : 1) * (1 - 2 * cosine * cosine);
      for (const auto& [next, quarter] : branches[at]) {
        if (seen[next]) continue;
        seen[next] = 1;
        turned[next] = static_cast<char>(turned[at] ^ quarter);
        tree.push_back(next);
      }
    }
    if (for_turn > 0) {
      for (const std::uint32_t node : tree) turned[node] = static_cast<char>(!turned[node]);
    }
  }
  return turned;
}

/// What of `v` lies in the plane.
Point3 in_plane(const Point3& v, const Point3& normal) { return unit(v - normal * glm::dot(normal, v)); }

}  // namespace

FormField curvature_field(const FormMesh& mesh, double length, const std::function<Point3(std::uint32_t)>& otherwise) {
  std::vector<TangentFrame> frames;
  for (const Point3& normal : mesh.normals) frames.push_back(frame_of(normal));
  const std::vector<Link> links = links_of(mesh, frames);
  const std::vector<Told> told = tell(mesh, frames, links, length);
  std::vector<double> weights;
  std::vector<Complex> wanted;
  for (const Told& t : told) {
    weights.push_back(t.weight);
    wanted.push_back(t.cross);
  }
  const std::vector<Complex> crosses = evened(weights, wanted, links, length, 4);
  std::vector<double> angles(crosses.size());
  std::vector<char> known(crosses.size());
  for (std::uint32_t n = 0; n < angles.size(); ++n) {
    known[n] = std::abs(crosses[n]) > 0;
    angles[n] = std::arg(crosses[n]) / 4;
  }
  const std::vector<char> turned = first_directions(angles, known, told, links);
  for (std::size_t n = 0; n < angles.size(); ++n) wanted[n] = std::polar(1.0, 2 * (angles[n] + (turned[n] ? kQuarter : 0)));
  const std::vector<Complex> lines = evened(weights, wanted, links, length, 2);
  FormField::Directions directions(lines.size());
  for (std::uint32_t n = 0; n < directions.size(); ++n) {
    const bool told_any = std::abs(lines[n]) > 0;
    const double angle = std::arg(lines[n]) / 2;
    const Point3 along = told_any ? frames[n].x * std::cos(angle) + frames[n].y * std::sin(angle) : otherwise(n);
    directions[n] = {along, glm::cross(mesh.normals[n], along)};
  }
  return FormField(std::move(directions));
}

Point3 FormField::at(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, bool second) const {
  if (of_node_.empty()) {
    const Point3 normal = mesh.area_vector(triangle);
    const Point3 ways[] = {glm::cross(Point3{0, 1, 0}, normal), glm::cross(normal, Point3{1, 0, 0})};
    const Point3 way = unit(ways[second]);
    return way == Point3{0, 0, 0} ? unit(glm::cross(normal, ways[!second])) : way;  // the triangle lies in such a plane
  }
  const auto largest = std::max_element(weights.begin(), weights.end()) - weights.begin();
  const std::uint32_t node = mesh.triangles[triangle].node[static_cast<std::size_t>(largest)];
  bool same = second;
  return onward(mesh, triangle, weights, of_node_[node][second], same);
}

Point3 FormField::onward(const FormMesh& mesh, std::uint32_t triangle, const Weights& weights, const Point3& along,
                         bool& second) const {
  if (of_node_.empty()) {
    const Point3 ways[] = {at(mesh, triangle, weights, false), at(mesh, triangle, weights, true)};
    const double dots[] = {glm::dot(ways[0], along), glm::dot(ways[1], along)};
    second = std::abs(dots[1]) > std::abs(dots[0]);
    return dots[second] < 0 ? -ways[second] : ways[second];
  }
  Point3 sum{0, 0, 0};
  double for_second = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& ways = of_node_[mesh.triangles[triangle].node[k]];
    const double dots[] = {glm::dot(ways[0], along), glm::dot(ways[1], along)};
    const bool nearer = std::abs(dots[1]) > std::abs(dots[0]);
    sum += ways[nearer] * (weights[k] * (dots[nearer] < 0 ? -1 : 1));
    for_second += nearer ? weights[k] : -weights[k];
  }
  second = for_second > 0;
  return in_plane(sum, unit(mesh.area_vector(triangle)));
}

Point3 unit(const Point3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : Point3{0, 0, 0};
}

}  // namespace ligne
