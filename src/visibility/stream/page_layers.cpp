#include "visibility/stream/page_layers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/hash.hpp"
#include "base/parallel_each.hpp"
#include "view/clip.hpp"
#include "view/edge_classes.hpp"
#include "view/edge_on.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {
namespace {

/// Factor on the sine of the "edge on" angle: a face seen at a smaller angle than that is odd.
constexpr double kOddSines = 64;
/// Least height of a plain facet on the page, in coincidence tolerances. Merging of vertices may move a corner by one
/// tolerance; a facet of this height then keeps its kind, and its depth tolerance grows by at most half.
constexpr double kHeightInCoincidences = 4;
/// Factor on the depth tolerance in the padding of depths: more than it grows.
constexpr double kToleranceGrowth = 2;
/// Padding of depths and of the margin of squares, in coincidence tolerances.
constexpr double kPadInCoincidences = 4;

constexpr double kUnit = 127;  ///< scale of the bytes of looks

Point3 triangle_normal(const Point3* p) {
  const Point3 sum = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

constexpr auto kRelaxed = std::memory_order_relaxed;

/// A side of a facet, directed from its lower point to its higher point: both facets at the side get the same one.
struct StreamSide {
  LatticePoint from, to;
  std::uint64_t number;  ///< number added to the sum; negative if the facet runs along the side from the higher point

  StreamSide(const StreamFacet& f, int k) {
    const int next = k == 2 ? 0 : k + 1;
    const bool forward = f.p[k] < f.p[next];
    const int a = forward ? k : next, b = forward ? next : k;
    from = f.p[a];
    to = f.p[b];
    const std::uint64_t both = f.corner[a] * kGoldenRatio + std::rotl(f.corner[b] * 0xc2b2ae3d27d4eb4fu, 32);
    const std::uint64_t side = (both ^ (both >> 29)) * 0xbf58476d1ce4e5b9u;
    number = forward ? side : std::uint64_t{0} - side;
  }
};

/// A square with the margin round it.
struct WideSquare {
  double left, right, top, bottom;
  WideSquare(double x, double y, double size, double margin)
      : left(x - margin), right(x + size + margin), top(y - margin), bottom(y + size + margin) {}

  /// Whether the side has a point in the square. Rounding does not make it differ between the two facets at the side.
  bool meets(const StreamSide& s) const {
    if (std::max(s.from.x, s.to.x) < left || std::min(s.from.x, s.to.x) > right) return false;
    if (std::max(s.from.y, s.to.y) < top || std::min(s.from.y, s.to.y) > bottom) return false;
    const double dx = double(s.to.x) - s.from.x, dy = double(s.to.y) - s.from.y;
    const double x = (left + right) / 2, y = (top + bottom) / 2;
    const double centre = dx * (y - s.from.y) - dy * (x - s.from.x);
    return std::abs(centre) <= (std::abs(dx) * (bottom - top) + std::abs(dy) * (right - left)) / 2;
  }
};

/// Whether a plain facet lies over the point. Exactly one of the facets round the point does, even if it lies on a
/// side: the point counts as moved slightly to the right, and much less down.
bool is_over(const StreamFacet& f, double x, double y) {
  for (int k = 0; k < 3; ++k) {
    const LatticePoint a = f.p[k], b = f.p[k == 2 ? 0 : k + 1];
    const double dx = double(b.x) - a.x, dy = double(b.y) - a.y;
    const double e = dx * (y - a.y) - dy * (x - a.x);
    if (e < 0 || (e == 0 && !(dy < 0 || (dy == 0 && dx > 0)))) return false;
  }
  return true;
}

std::uint64_t slices_of(const StreamFacet& f) { return (~std::uint64_t{0} >> (63 - (f.farthest - f.nearest))) << f.nearest; }

}  // namespace

/// Calls visit(square, sum, over) for the squares that a facet meets: the sum of the numbers of its sides there, and
/// whether it is over the square's centre.
template <class Visit>
void PageLayers::for_each_square(const StreamFacet& f, Visit visit) const {
  const std::int64_t left = std::min({f.p[0].x, f.p[1].x, f.p[2].x}), right = std::max({f.p[0].x, f.p[1].x, f.p[2].x});
  const std::int64_t top = std::min({f.p[0].y, f.p[1].y, f.p[2].y}), bottom = std::max({f.p[0].y, f.p[1].y, f.p[2].y});
  const std::int64_t column0 = squares_.column_of(left - margin_), column1 = squares_.column_of(right + margin_);
  const std::int64_t row0 = squares_.row_of(top - margin_), row1 = squares_.row_of(bottom + margin_);
  const StreamSide sides[3] = {{f, 0}, {f, 1}, {f, 2}};
  const bool plain = f.kind == StreamFacet::Kind::plain;
  const auto over_middle = [&](std::int64_t x, std::int64_t y) {
    const std::int64_t mx = x + squares_.size / 2, my = y + squares_.size / 2;
    if (!plain || mx < left || mx > right || my < top || my > bottom) return false;
    return is_over(f, static_cast<double>(mx), static_cast<double>(my));
  };
  for (std::int64_t row = row0; row <= row1; ++row) {
    for (std::int64_t column = column0; column <= column1; ++column) {
      const std::int64_t x = squares_.x + column * squares_.size, y = squares_.y + row * squares_.size;
      const bool over = over_middle(x, y);
      if (column0 == column1 && row0 == row1) {
        visit(squares_.number(column, row), sides[0].number + sides[1].number + sides[2].number, over);
        return;
      }
      const WideSquare square(static_cast<double>(x), static_cast<double>(y), static_cast<double>(squares_.size),
                              static_cast<double>(margin_));
      std::uint64_t sum = 0;
      bool meets = over;
      for (const StreamSide& side : sides) {
        if (!square.meets(side)) continue;
        sum += side.number;
        meets = true;
      }
      if (meets) visit(squares_.number(column, row), sum, over);
    }
  }
}

void PageLayers::add_depths(const StreamFacet& facet) {
  for_each_square(facet, [&](std::size_t number, std::uint64_t, bool) {
    std::atomic<std::uint64_t>& slices = of_[number].slices;
    const std::uint64_t mine = slices_of(facet);
    if ((slices.load(kRelaxed) & mine) != mine) slices.fetch_or(mine, kRelaxed);
  });
}

void PageLayers::find_layers() {
  parallel_each(of_.size(), [&](std::size_t i) {
    std::uint64_t left = of_[i].slices.load(kRelaxed), ends = 0;
    for (int layer = 0; layer < 2; ++layer) {
      std::uint64_t last = kNoSlice;
      if (left != 0) {
        const int first = std::countr_zero(left);
        const int length = std::countr_one(left >> first);
        last = static_cast<std::uint64_t>(first + length - 1);
        left = last == kSlices - 1 ? 0 : left >> (last + 1) << (last + 1);
      }
      ends |= last << (8 * layer);
    }
    of_[i].slices.store(ends, kRelaxed);
  });
}

void PageLayers::add(const StreamFacet& facet) {
  for_each_square(facet, [&](std::size_t number, std::uint64_t sum, bool over) {
    Square& square = of_[number];
    const int layer = facet.farthest <= layer_end(square, 0) ? 0 : facet.farthest <= layer_end(square, 1) ? 1 : 2;
    if (layer == 2) return;
    if (facet.kind == StreamFacet::Kind::plain) {
      square.sum[static_cast<std::size_t>(layer)].fetch_add(sum, kRelaxed);
      if (over) square.over[static_cast<std::size_t>(layer)].fetch_add(1, kRelaxed);
    }
    if (layer == 1) return;
    std::uint64_t looks = square.looks.load(kRelaxed);
    for (;;) {
      const std::uint64_t all = merged_looks(looks, facet.looks);
      if (all == looks || square.looks.compare_exchange_weak(looks, all, kRelaxed)) return;
    }
  });
}

void PageLayers::find_covers(bool blanks, double crease_cosine) {
  blank_.assign(of_.size(), 0);
  parallel_each(of_.size(), [&](std::size_t i) {
    Square& square = of_[i];
    std::uint8_t cover = kNoSlice;
    for (std::size_t layer = 2; layer-- > 0;) {
      if (square.sum[layer].load(kRelaxed) == 0 && square.over[layer].load(kRelaxed) > 0) {
        cover = layer_end(square, static_cast<int>(layer));
      }
    }
    const bool once = square.sum[0].load(kRelaxed) == 0 && square.over[0].load(kRelaxed) == 1;
    blank_[i] = blanks && once && look_alike(square.looks.load(kRelaxed), crease_cosine);
    square.slices.store(cover, kRelaxed);
  });
}

bool PageLayers::can_be_left_out(const StreamFacet& facet) const {
  bool can = true;
  for_each_square(facet, [&](std::size_t number, std::uint64_t, bool) {
    can = can && (blank_[number] || facet.nearest > layer_end(of_[number], 0));
  });
  return can;
}

OccludedCells PageLayers::take_blank() {
  std::vector<Square>().swap(of_);
  return {squares_, std::move(blank_)};
}

std::size_t PageLayers::blank_count() const { return static_cast<std::size_t>(std::ranges::count(blank_, 1)); }

std::uint64_t place_number(const Point3& p) {
  return mix_bits(mix_bits(mix_bits(bits_of_number(p.x) + kGoldenRatio) + bits_of_number(p.y)) + bits_of_number(p.z));
}

std::uint64_t packed_look(const Point3& unit_normal, std::uint64_t bits) {
  std::uint64_t packed = bits;
  for (int k = 0; k < 6; ++k) {
    const double component = k % 2 == 0 ? unit_normal[k / 2] : -unit_normal[k / 2];
    packed |= static_cast<std::uint64_t>(std::clamp(std::ceil(component * kUnit) + kUnit, 0.0, 2 * kUnit)) << (8 * k);
  }
  return packed;
}

std::uint64_t merged_looks(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = (a | b) & ~((std::uint64_t{1} << 48) - 1);
  for (int k = 0; k < 48; k += 8) result |= std::max(a >> k & 0xff, b >> k & 0xff) << k;
  return result;
}

bool look_alike(std::uint64_t looks, double crease_cosine) {
  if (looks & kLooksOdd) return false;
  if (((looks & kLooksHere) != 0) == ((looks & kLooksAway) != 0)) return false;
  if (((looks & kLooksRight) != 0) == ((looks & kLooksLeft) != 0)) return false;
  double square = 0;  // bound on the squared distance of two normals: |a - b|^2 = 2 - 2 a b
  for (int k = 0; k < 48; k += 16) {
    const double highest = static_cast<double>(looks >> k & 0xff) - kUnit;
    const double lowest = kUnit - static_cast<double>(looks >> (k + 8) & 0xff);
    square += (highest - lowest) * (highest - lowest) / (kUnit * kUnit);
  }
  constexpr double kFloatRounding = 0x1p-20;  // normals are compared as floats
  return 1 - square / 2 > crease_cosine + kFloatRounding;
}

StreamFacets::StreamFacets(const View& view, double precision, double largest, double near, double far)
    : precision_(precision), sight_rounding_(ligne::view_rounding(view.camera, largest)), near_(near) {
  page_.view = view;
  page_.lattice = page_lattice(view);
  page_.input_error_mm = projected_error_mm(view, precision, largest);
  per_mm_ = far > near ? kSlices / (far - near) : 0;
  const double coincidence = coincidence_mm(page_), steps = coincidence / page_.lattice.step_mm;
  pad_mm_ = kPadInCoincidences * coincidence;
  least_height_ = std::ceil(kHeightInCoincidences * steps) + 1;
  margin_ = 2 * static_cast<std::int64_t>(std::ceil(kPadInCoincidences * steps) + 2);
}

std::uint8_t StreamFacets::slice(double z) const {
  return static_cast<std::uint8_t>(std::clamp((z - near_) * per_mm_, 0.0, double{kSlices - 1}));
}

std::array<double, 3> StreamFacets::page_place(const Point3& p) const {
  const HomogeneousPoint h = to_homogeneous(page_.view, p);
  return {h.x / h.w, h.y / h.w, h.z / h.w};
}

StreamFacet StreamFacets::make(const Point3* corners) const {
  StreamFacet facet;
  if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return facet;
  const ClipVolume volume = line_volume(page_.view, page_.lattice);
  std::array<double, 3> z{};
  for (std::size_t k = 0; k < 3; ++k) {
    const HomogeneousPoint h = to_homogeneous(page_.view, corners[k]);
    if (!volume.contains(h)) {
      facet.kind = StreamFacet::Kind::outside;
      return facet;
    }
    facet.p[k] = page_.lattice.snap({h.x / h.w, h.y / h.w});
    z[k] = h.z / h.w;
    facet.corner[k] = place_number(corners[k]);
  }
  const Camera& camera = page_.view.camera;
  const Point3 normal = triangle_normal(corners);
  const Point3 sight = camera.perspective ? corners[0] - camera.eye : camera.forward;
  const double facing = glm::dot(normal, sight);
  const double z_near = std::min({z[0], z[1], z[2]}), z_far = std::max({z[0], z[1], z[2]});
  const double area = orientation(facet.p[0], facet.p[1], facet.p[2]);
  const LatticePoint a = facet.p[0], b = facet.p[1], c = facet.p[2];
  const double abx = double(b.x) - a.x, aby = double(b.y) - a.y, acx = double(c.x) - a.x, acy = double(c.y) - a.y;
  const double size =
      std::max({std::abs(abx) + std::abs(aby), std::abs(acx) + std::abs(acy), std::abs(acx - abx) + std::abs(acy - aby)});
  const bool odd = std::abs(facing) <= kOddSines * kEdgeOnSine * glm::length(sight) ||
                   std::abs(area) <= least_height_ * size ||
                   is_seen_edge_on(corners[0], corners[1], corners[2], camera, precision_, sight_rounding_);
  facet.kind = odd ? StreamFacet::Kind::odd : StreamFacet::Kind::plain;
  double pad = pad_mm_;
  if (area != 0) {
    const double zb = z[1] - z[0], zc = z[2] - z[0];
    const double gradient = (std::abs(zb * acy - zc * aby) + std::abs(zc * abx - zb * acx)) / std::abs(area);
    pad += kToleranceGrowth * depth_tolerance_mm(page_, gradient, z_near);
  }
  facet.nearest = slice(z_near - pad);
  facet.farthest = slice(z_far + pad);
  if (odd) {
    facet.looks = kLooksOdd;
    return facet;
  }
  facet.looks = packed_look(normal, (facing < 0 ? kLooksHere : kLooksAway) | (area > 0 ? kLooksRight : kLooksLeft));
  if (area < 0) {
    std::swap(facet.p[1], facet.p[2]);
    std::swap(facet.corner[1], facet.corner[2]);
  }
  return facet;
}

}  // namespace ligne
