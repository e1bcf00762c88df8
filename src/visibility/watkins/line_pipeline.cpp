#include "visibility/watkins/line_pipeline.hpp"

#include <algorithm>
#include <array>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "visibility/common/clock.hpp"

namespace ligne::watkins {

void LineScan::begin_preparing(std::uint32_t first) {
  any_slot_ = make_slot(scene_.unlisted, {});
  begin(first);
}

/// Segments are made on every line, since the second task may have to study a line after a penetration without an edge.
void LineScan::prepare(std::uint32_t line, PreparedLine& out) {
  out.line = line;
  out.first = must_study_;
  advance_edges(line);
  out.exchanged = sort(line);
  out.study = out.first || opens_ || !options_.coherence || out.exchanged || changes_matter(line);
  must_study_ = false;
  if (scene_.grid.whole) {
    collect_segments(whole_segments_);
    out.whole_segments = whole_segments_;
  } else {
    collect_segments(real_segments_);
    out.real_segments = real_segments_;
  }
  if (out.study) opens_ = has_opening();
  out.slots = slots_;
  out.order = order_;
  out.gone = gone_;
  out.ended_edges.swap(ended_edges_);
  ended_edges_.clear();
  out.ends = ends_;
  for (const std::uint32_t slot : gone_) free_slots_.push_back(slot);
}

void LineScan::begin_studying(std::uint32_t first) {
  any_slot_ = make_slot(scene_.unlisted, {});
  begin(first);
  prepared_ = true;
}

void LineScan::study_prepared(PreparedLine& prepared) {
  const bool study = prepared.study || must_study_ || !penetrating_.empty();
  if (!study) {  // the list is that of the line before, and so are the edges that bound spans
    for (const std::uint32_t slot : prepared.order) {
      ActiveEdge& now = prepared.slots[slot];
      const ActiveEdge& before = slots_[slot];
      now.boundary = before.boundary;
      now.before = before.before;
      now.after = before.after;
    }
  }
  slots_.swap(prepared.slots);
  order_.swap(prepared.order);
  ended_edges_.swap(prepared.ended_edges);
  for (const std::uint32_t slot : prepared.gone) listener_.ended(*this, slot);
  if (study) {
    ends_.swap(prepared.ends);
    real_segments_.swap(prepared.real_segments);
    whole_segments_.swap(prepared.whole_segments);
    if (whole_) {
      study_segments(*whole_, whole_segments_);
    } else {
      study_segments(*real_, real_segments_);
    }
    count_study(prepared.first, prepared.exchanged);
  } else {
    follow_edges();
  }
  if (!order_.empty()) ++counts_.lines;
  listener_.line(*this, prepared.line, study);
}

void LineScan::finish_studying() {
  for (const std::uint32_t slot : order_) listener_.ended(*this, slot);
}

PipelineTimes scan_in_two_tasks(LineScan& preparing, LineScan& studying, std::uint32_t first, std::uint32_t end,
                                std::uint32_t ahead) {
  PipelineTimes times;
  std::array<std::vector<PreparedLine>, 2> batches;
  std::uint32_t next = first;
  const auto prepare = [&](std::vector<PreparedLine>& batch) {
    Clock clock;
    batch.resize(std::min(ahead, end - next));
    for (PreparedLine& line : batch) preparing.prepare(next++, line);
    times.preparing += clock.lap();
  };
  const auto study = [&](std::vector<PreparedLine>& batch) {
    Clock clock;
    for (PreparedLine& line : batch) studying.study_prepared(line);
    times.studying += clock.lap();
  };
  preparing.begin_preparing(first);
  studying.begin_studying(first);
  prepare(batches[0]);
  for (std::size_t now = 0; !batches[now].empty(); now = 1 - now) {
    parallel_tasks(2, [&](std::size_t task) { task == 0 ? study(batches[now]) : prepare(batches[1 - now]); });
  }
  studying.finish_studying();
  return times;
}

}  // namespace ligne::watkins
