#pragma once
/// Strokes of many lines, in parallel.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "drawing/stroke.hpp"
#include "geometry/parallel.hpp"

namespace ligne {

/// Appends what work(i, strokes) makes for i in [0, n), in that order whatever the number of threads; make_work() gives the
/// work of a block of lines, with its own memory.
template <class MakeWork>
void make_strokes(std::size_t n, std::vector<Stroke>& strokes, MakeWork make_work) {
  constexpr std::size_t kBlock = 4096;
  const std::size_t blocks = (n + kBlock - 1) / kBlock;
  std::vector<std::vector<Stroke>> made(blocks);
  parallel_for(blocks, [&](std::size_t block) {
    auto work = make_work();
    for (std::size_t i = block * kBlock; i < std::min(n, (block + 1) * kBlock); ++i) work(i, made[block]);
  });
  for (const std::vector<Stroke>& part : made) strokes.insert(strokes.end(), part.begin(), part.end());
}

}  // namespace ligne
