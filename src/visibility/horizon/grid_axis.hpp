#pragma once
/// One axis of the grid: its samples, and the eye's place among them.

#include <cstddef>
#include <optional>
#include <vector>

namespace ligne::horizon {

/// Positions in ascending order: the samples, and the eye's where it lies between two of them. There the surface is divided,
/// without a curve.
struct GridAxis {
  /// `eye`: the viewer's place along the axis, nothing in parallel projection.
  GridAxis(const std::vector<double>& samples, std::size_t stride, std::optional<double> eye);

  std::size_t sample_count;
  std::vector<double> at;
  std::vector<std::size_t> sample;  ///< sample at the position or before it
  std::vector<double> fraction;     ///< of the way to the next sample; 0 at samples
  std::vector<bool> drawn;          ///< whether there is a curve

  /// Positions from the nearest to the farthest; `sign` gives the direction away from the viewer. The part begins with
  /// order[begin]: where that is a sample below the eye, the one before it belongs to the other part, and says what the
  /// surface does beyond.
  struct Part {
    std::vector<std::size_t> order;
    double sign;
    std::size_t begin = 0;
    std::size_t size() const { return order.size() - begin; }
  };
  /// Two parts where the eye lies inside, else one. Without an eye `forward` is the line of sight along the axis.
  std::vector<Part> parts(double forward) const;

  /// The eye's place: where it is over a sample but for a rounding, the sample's.
  std::optional<double> eye() const { return eye_; }

 private:
  std::optional<double> eye_;
};

}  // namespace ligne::horizon
