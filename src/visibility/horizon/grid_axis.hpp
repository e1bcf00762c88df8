#pragma once
/// One axis of the grid: its samples, and the eye's place among them.

#include <cstddef>
#include <optional>
#include <vector>

namespace ligne::horizon {

/// Positions in ascending order: the samples, and the eye's position if it lies between two of them. The surface is
/// divided there, but gets no curve.
struct GridAxis {
  /// `eye`: the viewer's place along the axis; none in parallel projection.
  GridAxis(const std::vector<double>& samples, std::size_t stride, std::optional<double> eye);

  std::size_t sample_count;
  std::vector<double> at;
  std::vector<std::size_t> sample;  ///< sample at the position or before it
  std::vector<double> fraction;     ///< fraction of the way to the next sample; 0 at samples
  std::vector<bool> drawn;          ///< whether a curve is drawn there

  /// Positions from the nearest to the farthest, beginning with order[begin]; `sign` is the direction away from the viewer.
  /// If the eye is over a sample, order[0] is a position of the other part, which shows how the surface continues there.
  struct Part {
    std::vector<std::size_t> order;
    double sign;
    std::size_t begin = 0;
    std::size_t size() const { return order.size() - begin; }
  };
  /// Two parts if the eye lies inside the axis, else one. Without an eye, `forward` is the component of the viewing
  /// direction along the axis.
  std::vector<Part> parts(double forward) const;

  /// The eye's place, moved to a sample if it differs from it only by rounding.
  std::optional<double> eye() const { return eye_; }

 private:
  std::optional<double> eye_;
};

}  // namespace ligne::horizon
