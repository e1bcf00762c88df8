#include "visibility/common/open_parts.hpp"

#include <algorithm>
#include <cstddef>

namespace ligne {

bool are_ascending(std::span<const LinePart> parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!(parts[i].from < parts[i].to) || (i > 0 && parts[i].from < parts[i - 1].to)) return false;
  }
  return true;
}

void OpenParts::take(double from, double to) {
  spare_.clear();
  for (const LinePart& part : open_) {
    if (to <= part.from || from >= part.to) {
      spare_.push_back(part);
      continue;
    }
    if (part.from < from) spare_.push_back({part.from, from});
    if (to < part.to) spare_.push_back({to, part.to});
  }
  open_.swap(spare_);
}

/// Takes the intervals that are covered both on the left and on the right. One sweep runs over both unions.
void OpenParts::take_one_sided() {
  struct Event {
    double t;
    int left, right;
  };
  std::vector<Event> events;
  for (const HiddenInterval& h : one_sided_) {
    const bool left = h.sides == HiddenSides::left;
    events.push_back({h.from, left ? 1 : 0, left ? 0 : 1});
    events.push_back({h.to, left ? -1 : 0, left ? 0 : -1});
  }
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t < b.t; });
  int left = 0, right = 0;
  for (std::size_t i = 0; i + 1 < events.size() && !open_.empty(); ++i) {
    left += events[i].left;
    right += events[i].right;
    if (left > 0 && right > 0 && events[i].t < events[i + 1].t) take(events[i].t, events[i + 1].t);
  }
}

void drop_short_parts(std::vector<LinePart>& parts, double length, double least) {
  if (parts.empty() || (parts.size() == 1 && parts[0].from == 0 && parts[0].to == 1)) return;
  if (length <= least) {
    double visible = 0;
    for (const LinePart& p : parts) visible += p.to - p.from;
    parts.assign(visible > 0.5 ? 1 : 0, LinePart{0, 1, parts.front().level});
    return;
  }
  std::size_t n = 0;
  for (const LinePart& p : parts) {
    const bool continues = n > 0 && (p.from - parts[n - 1].to) * length <= least;
    if (continues && (parts[n - 1].level == p.level || (p.to - p.from) * length <= least)) {
      parts[n - 1].to = p.to;
      continue;
    }
    if (continues) parts[n - 1].to = p.from;
    parts[n++] = p;
  }
  parts.resize(n);
  std::erase_if(parts, [&](const LinePart& p) { return (p.to - p.from) * length <= least; });
  if (!parts.empty() && parts.front().from * length <= least) parts.front().from = 0;
  if (!parts.empty() && (1 - parts.back().to) * length <= least) parts.back().to = 1;
}

}  // namespace ligne
