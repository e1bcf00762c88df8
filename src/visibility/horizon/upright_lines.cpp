#include "visibility/horizon/upright_lines.hpp"

#include <algorithm>
#include <cmath>

namespace ligne::horizon {

std::vector<Span>& UprightLines::drawn_at(double u) {
  const std::size_t first = columns_.at(u - least_), last = columns_.at(u + least_);
  for (std::size_t c = first; c <= last; ++c) {
    for (Upright& line : cells_[c]) {
      if (std::abs(line.u - u) <= least_) return line.drawn;
    }
  }
  return cells_[columns_.at(u)].emplace_back(Upright{u, {}}).drawn;
}

void UprightLines::draw(double u, std::vector<Span>& spans) {
  if (spans.empty()) return;
  std::vector<Span>& drawn = drawn_at(u);
  open_.clear();
  for (const Span& span : spans) {
    double at = span.from;
    const auto leave_open = [&](double to) {
      if (to - at > least_) open_.push_back({at, to});
    };
    const auto first =
        std::lower_bound(drawn.begin(), drawn.end(), span.from, [](const Span& d, double v) { return d.to < v; });
    auto last = first;
    Span all = span;
    for (; last != drawn.end() && last->from <= span.to; ++last) {
      leave_open(last->from);
      at = std::max(at, last->to);
      all = {std::min(all.from, last->from), std::max(all.to, last->to)};
    }
    leave_open(span.to);
    if (first == last) {
      drawn.insert(first, all);
    } else {
      *first = all;
      drawn.erase(first + 1, last);
    }
  }
  spans.swap(open_);
}

}  // namespace ligne::horizon
