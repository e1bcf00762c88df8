#include "geometry/polygons/monotone_chains.hpp"

#include <cassert>

#include "geometry/predicates.hpp"

namespace ligne {

MonotoneChains::Slab MonotoneChains::new_slab() {
  if (free_slabs_.empty()) {
    slabs_.emplace_back();
    return static_cast<Slab>(slabs_.size() - 1);
  }
  const Slab slab = free_slabs_.back();
  free_slabs_.pop_back();
  slabs_[slab] = {};
  return slab;
}

void MonotoneChains::push(Chain& chain, Index p) {
  std::uint32_t link = static_cast<std::uint32_t>(links_.size());
  if (free_links_.empty()) {
    links_.push_back({p, chain.last});
  } else {
    link = free_links_.back();
    free_links_.pop_back();
    links_[link] = {p, chain.last};
  }
  chain.last = link;
}

void MonotoneChains::pop(Chain& chain) {
  free_links_.push_back(chain.last);
  chain.last = links_[chain.last].previous;
}

void MonotoneChains::cut(Side side, Index before, Index last, Index p) {
  if (side == Side::lower) {
    triangles_.push_back({before, last, p});
  } else {
    triangles_.push_back({last, before, p});
  }
  const Triple& t = triangles_.back();
  assert(orientation_sign(p_[t[0]], p_[t[1]], p_[t[2]]) > 0);
  (void)t;
}

void MonotoneChains::fan(Chain& chain, Index p) {
  while (links_[chain.last].previous != kNone) {
    const Link last = links_[chain.last];
    cut(chain.side, links_[last.previous].position, last.position, p);
    pop(chain);
  }
  pop(chain);
}

void MonotoneChains::add(Chain& chain, Index p, Side side) {
  const Link last = links_[chain.last];
  if (last.previous == kNone) {
    chain.side = side;
  } else if (chain.side != side) {
    fan(chain, p);
    chain.side = side;
    push(chain, last.position);
  } else {
    const int inside = side == Side::lower ? 1 : -1;
    while (links_[chain.last].previous != kNone) {
      const Index top = links_[chain.last].position, before = links_[links_[chain.last].previous].position;
      if (orientation_sign(p_[before], p_[top], p_[p]) != inside) break;
      cut(side, before, top, p);
      pop(chain);
    }
  }
  push(chain, p);
}

MonotoneChains::Slab MonotoneChains::start(Index p) {
  const Slab slab = new_slab();
  push(slabs_[slab].lower, p);
  return slab;
}

void MonotoneChains::add_lower(Slab slab, Index p) {
  Chains& chains = slabs_[slab];
  if (chains.met) {
    fan(chains.lower, p);
    chains.lower = chains.upper;
    chains.met = false;
  }
  add(chains.lower, p, Side::lower);
}

void MonotoneChains::add_upper(Slab slab, Index p) {
  Chains& chains = slabs_[slab];
  if (chains.met) {
    fan(chains.upper, p);
    chains.met = false;
  }
  add(chains.lower, p, Side::upper);
}

void MonotoneChains::end(Slab slab, Index p) {
  Chains& chains = slabs_[slab];
  fan(chains.lower, p);
  if (chains.met) fan(chains.upper, p);
  free_slabs_.push_back(slab);
}

MonotoneChains::Slab MonotoneChains::split(Slab slab, Index p) {
  const Slab above = new_slab();
  Chains &lower = slabs_[slab], &upper = slabs_[above];
  if (lower.met) {
    lower.met = false;
    upper.lower = lower.upper;
  } else {
    // The last corner sees p. The part beyond the line between them begins with that line.
    const Index last = links_[lower.lower.last].position;
    Chain& begun = lower.lower.side == Side::lower ? lower.lower : upper.lower;
    if (lower.lower.side == Side::lower) upper.lower = lower.lower;
    begun = {};
    push(begun, last);
  }
  add(lower.lower, p, Side::upper);
  add(upper.lower, p, Side::lower);
  return above;
}

void MonotoneChains::merge(Slab lower, Slab upper, Index p) {
  add_upper(lower, p);
  add_lower(upper, p);
  slabs_[lower].upper = slabs_[upper].lower;
  slabs_[lower].met = true;
  free_slabs_.push_back(upper);
}

}  // namespace ligne
