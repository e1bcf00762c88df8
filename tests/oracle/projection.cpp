#include "oracle/parts.hpp"

namespace oracle {
namespace {

/// Share of the target's distance within which nothing is drawn (docs/numerics.md, "The near plane").
constexpr double kNearPart = 1e-3;

}  // namespace

Projection::Projection(const View& view)
    : perspective_(view.perspective),
      eye_(exact(view.eye)),
      forward_(perspective_ ? exact(view.target) - eye_ : exact(view.direction)),
      offset_(view.offset) {
  right_ = cross(forward_, exact(view.up));
  down_ = cross(forward_, right_);
  right2_ = dot(right_, right_), down2_ = dot(down_, down_), forward2_ = dot(forward_, forward_);
  near_ = forward2_ * Exact(kNearPart);
  const double f = length(forward_);
  const double unit = perspective_ ? view.scale * f * f : view.scale;
  mm_x_ = unit / length(right_);
  mm_y_ = unit / length(down_);
  // Parallel: depth = scale F / |f|. Perspective: scale (D - D^2 / w) with D = |f| and w = F / |f|.
  mm_z_ = perspective_ ? view.scale * f * f * f : view.scale / f;
  depth_0_ = perspective_ ? view.scale * f : 0;
}

SightPoint Projection::sight_point(const Vector3& p) const {
  const Vector3 d = p - eye_;
  return {dot(right_, d), dot(down_, d), dot(forward_, d)};
}

PagePoint Projection::page_point(const SightPoint& p) const {
  if (!perspective_) return {p.x, p.y, p.f};
  return {p.x / p.f, p.y / p.f, -1 / p.f};
}

// Any d is X right / |right|^2 + Y down / |down|^2 + F forward / |forward|^2. Put into normal . d = h this is the plane in
// X, Y and F; in perspective everything is then divided by F.
PagePlane Projection::page_plane(const Vector3& normal, const Vector3& on_plane, double eye_error, bool& edge_on) const {
  const Exact h = dot(normal, on_plane - eye_);
  const Exact nx = dot(normal, right_) / right2_, ny = dot(normal, down_) / down2_, nf = dot(normal, forward_) / forward2_;
  edge_on = perspective_ ? h * h <= Exact(eye_error) * Exact(eye_error) * dot(normal, normal) : nf == 0;
  if (edge_on) return {};
  if (perspective_) return {-nf / h, -nx / h, -ny / h};
  return {h / nf, -nx / nf, -ny / nf};
}

Vector3 Projection::model_point(const PagePoint& p) const {
  const Exact f = perspective_ ? -1 / p.z : p.z;
  const Exact x = perspective_ ? p.x * f : p.x, y = perspective_ ? p.y * f : p.y;
  return eye_ + (x / right2_) * right_ + (y / down2_) * down_ + (f / forward2_) * forward_;
}

double Projection::magnification(const PagePoint& p) const {
  return perspective_ ? -to_double(p.z) * to_double(forward2_) : 1;
}

}  // namespace oracle
