#include "areas/seen_parts.hpp"

namespace ligne::svg {
void LineCutter::take_points(std::span<const Point2> line) {
  points_.clear();
  steps_.clear();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const StepPoint at = to_steps(line[i]);
    if (steps_.empty() || steps_.back() != at) {
      points_.push_back(line[i]);
      steps_.push_back(at);
    } else if (i + 1 == line.size() && points_.size() > 1) {
      points_.back() = line[i];  // the line keeps its exact last point
    }
  }
}

/// Merges short parts into their neighbours. If all parts are short, the longest decides for the whole segment.
void LineCutter::drop_short_parts(double length_steps) {
  if (parts_.size() < 2) return;
  const double least = kLeastPartSteps / length_steps;
  double from = 0, longest = 0;
  bool seen = parts_[0].seen;
  std::size_t kept = 0;
  for (const SeenPart part : parts_) {
    const double long_part = part.end - from;
    if (long_part > longest) {
      longest = long_part;
      seen = part.seen;
    }
    from = part.end;
    if (long_part <= least) {
      if (kept > 0) parts_[kept - 1].end = part.end;
    } else if (kept > 0 && parts_[kept - 1].seen == part.seen) {
      parts_[kept - 1].end = part.end;
    } else {
      parts_[kept++] = part;
    }
  }
  parts_.resize(kept);
  if (kept == 0) parts_.push_back({1, seen});
}

void LineCutter::add_parts(std::size_t k, Polylines& out) {
  const Point2 a = points_[k - 1], b = points_[k];
  drop_short_parts(
      std::hypot(static_cast<double>(steps_[k].x - steps_[k - 1].x), static_cast<double>(steps_[k].y - steps_[k - 1].y)));
  double from = 0;
  for (const SeenPart& part : parts_) {
    if (part.seen) {
      if (run_.empty()) run_.push_back(from == 0 ? a : a + (b - a) * from);
      run_.push_back(part.end == 1 ? b : a + (b - a) * part.end);
    } else {
      end(out);
    }
    from = part.end;
  }
}

void LineCutter::end(Polylines& out) {
  if (run_.size() > 1) out.add(run_);
  run_.clear();
}

}  // namespace ligne::svg
