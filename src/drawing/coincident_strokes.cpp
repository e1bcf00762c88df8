/// Strokes that lie on each other: one stands for all.
///
/// Strokes are taken in the order of their precedence and compared with those that stand already. Where one of these has
/// precedence the new stroke loses the common interval, and what is left of it is tried again. Otherwise the new stroke
/// stands, and those that it precedes after all (depth decides in the middle of the common interval, which the order by
/// whole strokes can only guess) lose theirs and are tried again. So nothing that stands coincides with anything else
/// that stands, and whatever is taken away lies within the tolerance of the stroke to which it lost. Every trial takes
/// more than the tolerance from some stroke or lets one stand for good: the work ends. Since a new stroke is only held
/// against what stands, a thousand strokes on one line do not make a million pairs.
///
/// A cut puts the end of the loser onto the end of the winner, so that the two meet in one lattice point and the joining
/// of make_drawing.cpp sees that they continue each other.

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "drawing/drawing.hpp"
#include "drawing/stroke_index.hpp"
#include "drawing/stroke_overlap.hpp"
#include "geometry/parallel.hpp"

namespace ligne {
namespace {

// Adjustable: a stroke may cross this many cells of the index on the average.
constexpr double kCellsPerStroke = 64;

std::size_t rank(const Stroke& s) {
  const std::size_t group = !s.visible ? 2 : s.level > 0 ? 1 : 0;
  return group * kLineClassCount + static_cast<std::size_t>(s.line_class);
}

bool by_source(const Stroke& l, const Stroke& r) {
  return std::tie(l.source, l.t_from, l.t_to) < std::tie(r.source, r.t_from, r.t_to);
}

double depth(const Stroke& s, double fraction) { return (1 - fraction) * s.z_from + fraction * s.z_to; }

/// A place on a stroke where it is cut.
struct Cut {
  double fraction;
  LatticePoint p;
};

/// The piece of a stroke between two cuts.
Stroke piece(const Stroke& s, const Cut& from, const Cut& to) {
  const auto weight = [&](double fraction) {
    const double u = (source_parameter(s, fraction) - s.t_from) / (s.t_to - s.t_from);
    return static_cast<float>((1 - u) * s.w_from + u * s.w_to);
  };
  Stroke part = s;
  if (from.fraction > 0) {
    part.t_from = source_parameter(s, from.fraction);
    part.z_from = static_cast<float>(depth(s, from.fraction));
    part.w_from = weight(from.fraction);
    part.from = from.p;
  }
  if (to.fraction < 1) {
    part.t_to = source_parameter(s, to.fraction);
    part.z_to = static_cast<float>(depth(s, to.fraction));
    part.w_to = weight(to.fraction);
    part.to = to.p;
  }
  return part;
}

/// An interval that a stroke loses.
struct Loss {
  Cut from, to;
};

class Precedence {
 public:
  Precedence(double cell, double tolerance_steps, double tolerance_mm)
      : index_(cell, tolerance_steps), tolerance_steps_(tolerance_steps), tolerance_mm_(tolerance_mm) {}

  /// Strokes must come by rank.
  void add(const Stroke& stroke) {
    waiting_.push_back(stroke);
    while (!waiting_.empty()) {
      const Stroke s = waiting_.back();
      waiting_.pop_back();
      try_one(s);
    }
  }

  /// What stands is appended to `strokes`.
  void take(std::vector<Stroke>& strokes) const {
    for (std::size_t i = 0; i < standing_.size(); ++i) {
      if (stands_[i]) strokes.push_back(standing_[i]);
    }
  }

 private:
  /// A stroke that stands, and where the one on trial lies on it: a is the one on trial.
  struct Hit {
    std::uint32_t standing;
    StrokeOverlap common;
  };

  void try_one(const Stroke& stroke);
  bool precedes(const Stroke& stroke, const Stroke& standing, const StrokeOverlap& common) const;
  void cut(const Stroke& stroke, std::vector<Loss>& losses);

  StrokeIndex index_;
  double tolerance_steps_, tolerance_mm_;
  std::vector<Stroke> standing_, waiting_;
  std::vector<char> stands_;
  std::vector<std::uint32_t> seen_;  ///< number of the trial in which a standing stroke was met last
  std::uint32_t trial_ = 0;
  std::vector<Hit> hits_;
  std::vector<Loss> losses_;
};

/// `stroke`, which comes later in the order, goes before the one that stands.
bool Precedence::precedes(const Stroke& stroke, const Stroke& standing, const StrokeOverlap& common) const {
  if (rank(stroke) != rank(standing)) return rank(stroke) < rank(standing);
  const double z = depth(stroke, (common.a_from + common.a_to) / 2);
  const double z_standing = depth(standing, (common.b_from + common.b_to) / 2);
  if (std::abs(z - z_standing) > tolerance_mm_) return z < z_standing;
  return by_source(stroke, standing);
}

/// Puts what the losses leave of the stroke on the list of those to be tried.
void Precedence::cut(const Stroke& stroke, std::vector<Loss>& losses) {
  std::sort(losses.begin(), losses.end(), [](const Loss& l, const Loss& r) {
    return std::tie(l.from.fraction, l.to.fraction) < std::tie(r.from.fraction, r.to.fraction);
  });
  const double stroke_length = length(stroke.from, stroke.to);
  Cut from{0, stroke.from};
  const auto keep = [&](const Cut& to) {
    if ((to.fraction - from.fraction) * stroke_length <= tolerance_steps_) return;
    const Stroke part = piece(stroke, from, to);
    if (part.from != part.to && part.t_from < part.t_to) waiting_.push_back(part);
  };
  for (const Loss& loss : losses) {
    keep(loss.from);
    if (loss.to.fraction > from.fraction) from = loss.to;
  }
  keep({1, stroke.to});
}

void Precedence::try_one(const Stroke& stroke) {
  ++trial_;
  hits_.clear();
  index_.query(stroke.from, stroke.to, [&](std::uint32_t i) {
    if (!stands_[i] || seen_[i] == trial_) return;
    seen_[i] = trial_;
    const Stroke& standing = standing_[i];
    if (!stroke.may_coincide && !standing.may_coincide) return;
    if (const auto common = overlap(stroke.from, stroke.to, standing.from, standing.to, tolerance_steps_)) {
      hits_.push_back({i, *common});
    }
  });

  losses_.clear();
  for (const auto& [i, common] : hits_) {
    const Stroke& standing = standing_[i];
    if (precedes(stroke, standing, common)) continue;
    const auto end = [&](double fraction) { return fraction < 0.5 ? standing.from : standing.to; };
    losses_.push_back({{common.a_from, end(common.b_from)}, {common.a_to, end(common.b_to)}});
  }
  if (!losses_.empty()) return cut(stroke, losses_);

  for (const auto& [i, common] : hits_) {
    stands_[i] = false;
    const auto end = [&](double fraction) { return fraction < 0.5 ? stroke.from : stroke.to; };
    Loss loss{{common.b_from, end(common.a_from)}, {common.b_to, end(common.a_to)}};
    if (loss.from.fraction > loss.to.fraction) std::swap(loss.from, loss.to);
    losses_.assign(1, loss);
    cut(standing_[i], losses_);
  }
  index_.insert(stroke.from, stroke.to);
  standing_.push_back(stroke);
  stands_.push_back(true);
  seen_.push_back(0);
}

double median(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Cells as small as the common stroke, or as the mean distance of strokes when these are long, but never so small that the
/// strokes cross more than kCellsPerStroke of them on the average, and always larger than the reach of the tolerance.
double cell_size(const std::vector<Stroke>& strokes, double tolerance_steps) {
  std::vector<float> lengths;
  LatticePoint min{kLatticeLimit, kLatticeLimit}, max{-kLatticeLimit, -kLatticeLimit};
  double sum = 0;
  for (const Stroke& s : strokes) {
    lengths.push_back(static_cast<float>(length(s.from, s.to)));
    sum += lengths.back();
    for (const LatticePoint p : {s.from, s.to}) {
      min = {std::min(min.x, p.x), std::min(min.y, p.y)};
      max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
  }
  const double n = static_cast<double>(lengths.size());
  const double side = std::max(double(max.x) - min.x, double(max.y) - min.y);
  return std::max({std::min<double>(median(lengths), side / std::sqrt(n)), sum / n / kCellsPerStroke, 8 * tolerance_steps});
}

/// A stroke in the order in which they are tried.
struct Turn {
  std::size_t rank;
  double depth;  ///< in steps of the tolerance, so that equal depths are equal
  Stroke stroke;

  Turn(const Stroke& s, double tolerance_mm)
      : rank(ligne::rank(s)), depth(std::floor(ligne::depth(s, 0.5) / tolerance_mm)), stroke(s) {
    if (!std::isfinite(depth)) depth = 0;
  }
  bool operator<(const Turn& other) const {
    if (rank != other.rank) return rank < other.rank;
    if (depth != other.depth) return depth < other.depth;
    return by_source(stroke, other.stroke);
  }
};

bool long_enough(const Stroke& s, double tolerance_steps) { return length(s.from, s.to) > tolerance_steps; }

/// A coarse raster of the page in which strokes are marked: most strokes of a large drawing lie in no marked square, and
/// this is found out faster than in a hash table.
class MarkedSquares {
 public:
  MarkedSquares(const std::vector<Stroke>& strokes, double margin) : marks_(kSide * kSide, 0), margin_(margin) {
    for (const Stroke& s : strokes) {
      const bool too_large = for_each_square(s, [&](std::size_t k) {
        marks_[k] = 1;
        return false;
      });
      everywhere_ = everywhere_ || too_large;
    }
  }
  /// May the stroke lie on one of those marked? True where that would take long to decide.
  bool near(const Stroke& s) const {
    return everywhere_ || for_each_square(s, [&](std::size_t k) { return marks_[k] != 0; });
  }

 private:
  static constexpr std::size_t kSide = 2048;
  static constexpr std::size_t kLargest = 256;  ///< bounding boxes of more squares are not looked at

  std::size_t square(double v) const {
    return static_cast<std::size_t>((v + kLatticeLimit) * (double(kSide) / (2.0 * kLatticeLimit + 1)));
  }
  /// Squares of the stroke's bounding box, until visit returns true; true too when there are too many.
  template <class Visit>
  bool for_each_square(const Stroke& s, const Visit& visit) const {
    const double limit = kLatticeLimit;
    const std::size_t left = square(std::max(std::min(s.from.x, s.to.x) - margin_, -limit));
    const std::size_t right = square(std::min(std::max(s.from.x, s.to.x) + margin_, limit));
    const std::size_t top = square(std::max(std::min(s.from.y, s.to.y) - margin_, -limit));
    const std::size_t bottom = square(std::min(std::max(s.from.y, s.to.y) + margin_, limit));
    if ((bottom - top + 1) * (right - left + 1) > kLargest) return true;
    for (std::size_t y = top; y <= bottom; ++y) {
      for (std::size_t x = left; x <= right; ++x) {
        if (visit(y * kSide + x)) return true;
      }
    }
    return false;
  }

  std::vector<std::uint8_t> marks_;
  double margin_;
  bool everywhere_ = false;
};

/// Marks the strokes that take part: those that may coincide, and those of the others that lie on one of them.
std::vector<char> participants(const std::vector<Stroke>& strokes, const std::vector<Stroke>& flagged, double cell,
                               double tolerance_steps) {
  StrokeIndex index(cell, tolerance_steps);
  for (const Stroke& s : flagged) index.insert(s.from, s.to);
  const MarkedSquares squares(flagged, tolerance_steps);
  std::vector<char> takes_part(strokes.size(), 0);
  constexpr std::size_t kGrain = 4096;
  parallel_blocks(strokes.size(), kGrain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Stroke& s = strokes[i];
      if (s.may_coincide) {
        takes_part[i] = long_enough(s, tolerance_steps);
        continue;
      }
      if (!squares.near(s)) continue;
      index.query(s.from, s.to, [&](std::uint32_t k) {
        if (takes_part[i]) return;
        takes_part[i] = overlap(s.from, s.to, flagged[k].from, flagged[k].to, tolerance_steps).has_value();
      });
    }
  });
  return takes_part;
}

}  // namespace

void remove_coincident_strokes(StrokeModel& model, double tolerance_mm) {
  std::vector<Stroke>& strokes = model.strokes;
  // The lattice knows nothing finer than its step.
  const double tolerance_steps = std::max(tolerance_mm / model.lattice.step_mm, 1.0);
  std::vector<Stroke> flagged;
  for (const Stroke& s : strokes) {
    if (s.may_coincide && long_enough(s, tolerance_steps)) flagged.push_back(s);
  }
  if (flagged.empty()) return;
  const double cell = cell_size(flagged, tolerance_steps);
  const std::vector<char> takes_part = participants(strokes, flagged, cell, tolerance_steps);
  std::vector<Turn> turns;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (takes_part[i]) {
      turns.emplace_back(strokes[i], tolerance_mm);
    } else {
      strokes[kept++] = strokes[i];
    }
  }
  strokes.resize(kept);
  std::stable_sort(turns.begin(), turns.end());
  Precedence precedence(cell, tolerance_steps, tolerance_mm);
  for (const Turn& turn : turns) precedence.add(turn.stroke);
  precedence.take(strokes);
}

}  // namespace ligne
