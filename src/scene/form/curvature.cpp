#include "scene/form/curvature.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.hpp"
#include "base/stop.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr std::size_t kMostRounds = 300;  ///< of conjugate gradients; directions spread this many edges into flat parts
constexpr double kResidual = 1e-4;        ///< relative to the first residual; enough for directions, which hide nothing

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

/// Components xx, xy, xz, yy, yz, zz of a symmetric matrix.
using Tensor = std::array<double, 6>;

double applied(const Tensor& t, const Point3& a, const Point3& b) {
  return t[0] * a.x * b.x + t[1] * (a.x * b.y + a.y * b.x) + t[2] * (a.x * b.z + a.z * b.x) + t[3] * a.y * b.y +
         t[4] * (a.y * b.z + a.z * b.y) + t[5] * a.z * b.z;
}

/// The second fundamental form (e, f, g) in the frame that best fits the changes of the normals along the sides: normal
/// equations of e x + f y = n.x and f x + g y = n.y, which have a solution for a triangle with area.
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

}  // namespace

std::vector<TangentFrame> tangent_frames(const FormMesh& mesh) {
  std::vector<TangentFrame> frames;
  for (const Point3& normal : mesh.normals) frames.push_back(frame_of(normal));
  return frames;
}

std::vector<FormLink> form_links(const FormMesh& mesh, const std::vector<TangentFrame>& frames) {
  std::vector<FormLink> links;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const double area = glm::length(mesh.area_vector(t));
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.triangles[t].node[k], b = mesh.triangles[t].node[(k + 1) % 3];
      const Point3 side = mesh.points[b] - mesh.points[a];
      const double square = glm::dot(side, side);
      if (!(area > 0) || !(square > 0)) continue;
      // Weight of a side in a mesh of equilateral triangles, half from each of its triangles; positive in any mesh.
      links.push_back({std::min(a, b), std::max(a, b), area / (3 * square), 0});
    }
  }
  parallel_sort(links.begin(), links.end(), [](const FormLink& a, const FormLink& b) {
    return std::tie(a.i, a.j, a.weight) < std::tie(b.i, b.j, b.weight);
  });
  std::size_t kept = 0;
  for (std::size_t l = 0; l < links.size(); ++l) {
    if (kept > 0 && links[kept - 1].i == links[l].i && links[kept - 1].j == links[l].j) {
      links[kept - 1].weight += links[l].weight;
    } else {
      links[kept++] = links[l];
    }
  }
  links.resize(kept);
  for (FormLink& link : links) {
    const Point3 side = mesh.points[link.j] - mesh.points[link.i];
    link.angle = angle_in(frames[link.i], side) - angle_in(frames[link.j], side);
  }
  return links;
}

std::vector<Complex> evened(const std::vector<double>& weights, const std::vector<Complex>& wanted,
                            const std::vector<FormLink>& links, double length, int symmetry) {
  const std::size_t n = weights.size();
  std::vector<double> diagonal = weights;
  std::vector<Complex> z(n), residual(n), way(n), image(n);
  std::vector<Complex> turns;
  for (std::size_t i = 0; i < n; ++i) residual[i] = weights[i] * wanted[i];
  for (const FormLink& link : links) {
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

std::vector<Point3> evened_normals(const FormMesh& mesh, const std::vector<FormLink>& links, double length) {
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

std::vector<SecondForm> second_forms(const FormMesh& mesh, const std::vector<TangentFrame>& frames,
                                     const std::vector<Point3>& normals) {
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
  std::vector<SecondForm> forms(sums.size());
  for (std::uint32_t n = 0; n < sums.size(); ++n) {
    for (double& value : sums[n]) value = mesh.areas[n] > 0 ? value / mesh.areas[n] : 0;
    forms[n] = {applied(sums[n], frames[n].x, frames[n].x), applied(sums[n], frames[n].x, frames[n].y),
                applied(sums[n], frames[n].y, frames[n].y)};
  }
  return forms;
}

}  // namespace ligne
