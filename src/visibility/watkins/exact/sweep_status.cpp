#include "visibility/watkins/exact/sweep_status.hpp"

#include "visibility/watkins/exact/sweep_scene.hpp"

namespace ligne::watkins {

SweepStatus::SweepStatus() : slots_(1) {}

std::uint32_t SweepStatus::make_node() {
  if (free_nodes_.empty()) {
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
  }
  const std::uint32_t n = free_nodes_.back();
  free_nodes_.pop_back();
  return n;
}

void SweepStatus::free_node(std::uint32_t n) {
  ++nodes_[n].generation;
  free_nodes_.push_back(n);
}

std::uint32_t SweepStatus::insert_after(std::uint32_t slot) {
  std::uint32_t fresh;
  if (free_slots_.empty()) {
    slots_.emplace_back();
    fresh = static_cast<std::uint32_t>(slots_.size() - 1);
  } else {
    fresh = free_slots_.back();
    free_slots_.pop_back();
  }
  const std::uint32_t next = slots_[slot].next;
  slots_[fresh].previous = slot;
  slots_[fresh].next = next;
  slots_[slot].next = fresh;
  slots_[next].previous = fresh;

  if (order_.empty()) {
    order_.push_back(0);
    if (blocks_.empty()) blocks_.emplace_back();
    blocks_[0].rank = blocks_[0].count = 0;
    std::erase(free_blocks_, 0u);
  }
  std::uint32_t block = slot == kLeftEnd ? order_.front() : slots_[slot].block;
  if (blocks_[block].count == kBlock) {
    split(block);
    block = slot == kLeftEnd ? order_.front() : slots_[slot].block;
  }
  Block& b = blocks_[block];
  const std::uint32_t place = slot == kLeftEnd ? 0 : place_in_block(slot) + 1;
  std::copy_backward(b.slots + place, b.slots + b.count, b.slots + b.count + 1);
  b.slots[place] = fresh;
  ++b.count;
  slots_[fresh].block = block;
  return fresh;
}

void SweepStatus::erase(std::uint32_t slot) {
  Slot& s = slots_[slot];
  slots_[s.previous].next = s.next;
  slots_[s.next].previous = s.previous;
  s.cover.clear();
  Block& b = blocks_[s.block];
  const std::uint32_t place = place_in_block(slot);
  std::copy(b.slots + place + 1, b.slots + b.count, b.slots + place);
  if (--b.count == 0) {
    const std::size_t rank = b.rank;
    free_blocks_.push_back(s.block);
    order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(rank));
    renumber(rank);
  }
  free_slots_.push_back(slot);
}

std::uint32_t SweepStatus::place_in_block(std::uint32_t slot) const {
  const Block& b = blocks_[slots_[slot].block];
  return static_cast<std::uint32_t>(std::find(b.slots, b.slots + b.count, slot) - b.slots);
}

void SweepStatus::split(std::uint32_t block) {
  std::uint32_t fresh;
  if (free_blocks_.empty()) {
    blocks_.emplace_back();
    fresh = static_cast<std::uint32_t>(blocks_.size() - 1);
  } else {
    fresh = free_blocks_.back();
    free_blocks_.pop_back();
  }
  Block &left = blocks_[block], &right = blocks_[fresh];
  left.count = kBlock / 2;
  right.count = kBlock - left.count;
  std::copy(left.slots + left.count, left.slots + kBlock, right.slots);
  for (std::uint32_t i = 0; i < right.count; ++i) slots_[right.slots[i]].block = fresh;
  order_.insert(order_.begin() + left.rank + 1, fresh);
  renumber(left.rank);
}

void SweepStatus::renumber(std::size_t from) {
  for (std::size_t i = from; i < order_.size(); ++i) blocks_[order_[i]].rank = static_cast<std::uint32_t>(i);
}

bool SweepStatus::left_of(std::uint32_t slot, LatticePoint p) const {
  const SweepNode& n = nodes_[slots_[slot].node];
  return side(n.top, n.bottom, p) < 0;
}

std::uint32_t SweepStatus::last_left_of(LatticePoint p) const {
  const auto block =
      std::partition_point(order_.begin(), order_.end(), [&](std::uint32_t b) { return left_of(blocks_[b].slots[0], p); });
  if (block == order_.begin()) return kLeftEnd;
  const Block& b = blocks_[*(block - 1)];
  const std::uint32_t* const found =
      std::partition_point(b.slots, b.slots + b.count, [&](std::uint32_t s) { return left_of(s, p); });
  return *(found - 1);
}

}  // namespace ligne::watkins
