#include "scene/patches/search/patch_finder.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <iterator>
#include <numeric>

#include "base/indices_where.hpp"
#include "base/large_vector.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"

namespace ligne {
namespace {

// Adjustable parameters.
/// Smallest ratio of the areas, and of the longest diagonals, of two facets of about the same size and form.
constexpr double kSameArea = 0.8, kSameLength = 0.9;
/// About this many seeds, spread evenly over all, are tried first. If fewer than kFewestSuccesses of them get a
/// surface, the object gets none at all.
constexpr std::size_t kSamples = 64;
constexpr std::ptrdiff_t kFewestSuccesses = 4;
/// The object also gets none if the surfaces of the samples together have fewer facets than one per kLeastShare seeds:
/// in a free form of a million facets, some rows of ten lie on cylinders.
constexpr std::size_t kLeastShare = 2000;
/// At least one in so many facets must lie on a surface that ends there instead of continuing smoothly.
constexpr std::size_t kFirmShare = 4;
/// Logarithm of the number of classes of seeds of similar lengths.
constexpr int kClassBits = 12;
/// Largest number of facets over which all surfaces together grow: a constant, plus so many for each facet of the object.
/// Parts need at most 200 for each; where rounding hides the bends of a ball of thousands of facets, many surfaces nearly
/// fit.
constexpr std::size_t kMostGrown = std::size_t{1} << 22, kMostGrownPerFacet = 256;
/// Largest number of seeds that are tried at once.
constexpr std::size_t kMostTrials = 8;

}  // namespace

// The search only keeps the reference to patch_of_, which is made after it.
PatchFinder::PatchFinder(const Scene& scene, const Topology& topology, const Object& object, const FacetGraph& graph)
    : SurfaceSearch(scene, topology, object, graph, patch_of_),
      patch_of_(graph.size(), kNone),
      has_failed_(graph.size(), 0) {}

std::vector<std::uint32_t> PatchFinder::run(std::vector<Patch>& patches) {
  std::vector<Seed> all = seeds();
  const std::size_t step = all.size() / kSamples;
  if (step >= 2) {
    if (find_few(every_seed(all, step), all.size(), patches)) {
      patches.clear();
      patch_of_.assign(graph_.size(), kNone);
      return std::move(patch_of_);
    }
  }
  parallel_sort(all.begin(), all.end());
  search(all, patches);
  join_bands(patches);
  find_fillets(all, patches);
  const std::vector<std::uint32_t> found_by = patch_of_;
  join_borders(patches);
  // Facets beside merged patches may lie only on the surface of the larger one.
  if (merge_patches(patches, found_by)) join_borders(patches);
  return std::move(patch_of_);
}

/// Whether a surface continues smoothly into its neighbours: corners leave it by more than rounding, and it would grow at a
/// tolerance of its sag. So each row of facets of a smooth tube lies on a cylinder; spheres never do. If the object is only
/// a part, facets at its border may continue.
bool PatchFinder::continues_smoothly(const Patch& patch, std::vector<std::uint32_t> facets) {
  fetch_points(facets);
  const double rounding = kPrecisions * object_.precision;
  const auto is_exact = [&](const Point3& p) { return std::abs(patch.surface.distance(p)) <= rounding; };
  if (patch.surface.kind == SurfaceKind::sphere || std::ranges::all_of(points_, is_exact)) return false;
  const auto is_at_border = [&](std::uint32_t f) { return at_border_[f] != 0; };
  if (!at_border_.empty() && std::ranges::any_of(facets, is_at_border)) return true;
  PatchCandidate c{.patch = patch, .facets = std::move(facets)};
  for (const std::uint32_t f : c.facets) c.area += graph_.area[f];
  return !ends_within(c, std::max(patch.sag, rounding));
}

/// Searches from samples of `count` seeds. Returns true if they give too few surfaces, or if there is no plane and most
/// surfaces continue smoothly: then the object gets no surfaces. Lofts between planes keep theirs.
bool PatchFinder::find_few(std::span<const Seed> samples, std::size_t count, std::vector<Patch>& patches) {
  search(samples, patches);
  const PatchFacets facets = facets_of(patches);
  std::size_t found = 0, loose = 0;
  for (const std::vector<std::uint32_t>& of_patch : facets) found += of_patch.size();
  const bool has_plane = std::ranges::any_of(graph_.is_plane, [](std::uint8_t is_plane) { return is_plane != 0; });
  for (std::size_t p = 0; p < patches.size() && !has_plane; ++p)
    loose += continues_smoothly(patches[p], facets[p]) ? facets[p].size() : 0;
  const auto succeeded = [&](const Seed& seed) { return patch_of_[seed.facet] != kNone; };
  return std::ranges::count_if(samples, succeeded) < kFewestSuccesses || kLeastShare * found < count ||
         kFirmShare * (found - loose) < found;
}

bool PatchFinder::seems_freeform(std::span<const std::uint32_t> facets, std::size_t count) {
  constexpr double kNearlyAll = 7.0 / 8;
  std::vector<Seed> samples;
  for (const std::uint32_t f : facets) {
    if (may_be_seed(f)) samples.push_back({longest_diagonal(f), f});
  }
  if (static_cast<double>(samples.size()) < kNearlyAll * static_cast<double>(facets.size())) return false;
  at_border_.assign(graph_.size(), 0);
  for (const Edge& edge : topology_.edges) {
    if (edge.face1 == kNone) at_border_[graph_.facet_of[edge.face0 - object_.face_begin]] = 1;
  }
  std::sort(samples.begin(), samples.end());
  std::vector<Patch> patches;
  return find_few(samples, count, patches);
}

/// Facets that may be curved, not sorted.
std::vector<PatchFinder::Seed> PatchFinder::seeds() const {
  const std::vector<std::uint32_t> facets =
      indices_where(graph_.size(), [&](std::size_t f) { return may_be_seed(static_cast<std::uint32_t>(f)); });
  std::vector<Seed> seeds = large_vector<Seed>(facets.size());
  parallel_each(facets.size(), [&](std::size_t i) { seeds[i] = {longest_diagonal(facets[i]), facets[i]}; });
  return seeds;
}

/// Every `step`-th of the sorted seeds, found without sorting the others.
std::vector<PatchFinder::Seed> PatchFinder::every_seed(std::span<const Seed> seeds, std::size_t step) {
  // Lengths are not negative, so their bits have their order. Longer seeds get lower numbers.
  const auto bits = [](const Seed& seed) { return std::bit_cast<std::uint64_t>(seed.length); };
  const auto [low, high] = std::ranges::minmax(seeds, {}, bits);
  const std::uint64_t most = bits(high);
  const int shift = std::max(0, static_cast<int>(std::bit_width(most - bits(low))) - kClassBits);
  const auto class_of = [&](const Seed& seed) { return (most - bits(seed)) >> shift; };
  std::vector<std::size_t> after(std::size_t{1} << kClassBits, 0);  // per class: number of seeds in it and before it
  for (const Seed& seed : seeds) ++after[class_of(seed)];
  std::partial_sum(after.begin(), after.end(), after.begin());
  const auto is_asked = [&](std::size_t c) {
    const std::size_t first = c > 0 ? after[c - 1] : 0;
    return (first + step - 1) / step * step < after[c];
  };
  std::vector<Seed> asked;
  std::ranges::copy_if(seeds, std::back_inserter(asked), [&](const Seed& seed) { return is_asked(class_of(seed)); });
  parallel_sort(asked.begin(), asked.end());
  std::vector<Seed> found;
  std::size_t place = 0;  // of the next seed of `asked` among all
  for (const Seed& seed : asked) {
    const std::size_t c = class_of(seed);
    place = std::max(place, c > 0 ? after[c - 1] : 0);
    if (place++ % step == 0) found.push_back(seed);
  }
  return found;
}

/// Whether the surfaces of the object have grown over as many facets as they may.
bool PatchFinder::has_grown_enough() const { return all_grown_ > kMostGrown + kMostGrownPerFacet * graph_.size(); }

/// Makes patches from seeds, and excludes those that are_alike() near a failed one. Stops when surfaces have grown over too
/// many facets. Several threads try seeds at once, each as if those before it failed. Only outcomes up to the first surface
/// count, so the result is the same as one by one. Later outcomes are kept unless that surface takes a facet they used.
void PatchFinder::search(std::span<const Seed> seeds, std::vector<Patch>& patches) {
  is_excluded_.assign(graph_.size(), 0);
  kept_.clear();
  const std::size_t threads = thread_count(), widest = threads > 1 ? kMostTrials : 1;
  const std::size_t first_width = std::min(threads, kMostTrials);
  for (std::size_t from = 0, width = first_width; from < seeds.size();) {
    std::vector<Trial> trials = next_trials(seeds, from, width);
    if (trials.empty()) return;
    try_all(seeds, trials);
    from = trials.back().number + 1;
    width = std::min(2 * width, widest);
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (has_grown_enough()) return;
      const Trial& trial = trials[i];
      const PatchCandidate& best = trial.outcome.best;
      all_grown_ += trial.outcome.grown;
      if (best.facets.empty()) {
        has_failed_[seeds[trial.number].facet] = 1;
        continue;
      }
      for (std::size_t k = i; k < trials.size(); ++k) {
        for (const std::uint32_t f : trials[k].alike) is_excluded_[f] = 0;
      }
      for (const std::uint32_t f : best.facets) patch_of_[f] = static_cast<std::uint32_t>(patches.size());
      patches.push_back(best.patch);
      from = trial.number + 1;
      width = first_width;
      keep_outcomes(std::span(trials).subspan(i + 1));
      break;
    }
  }
}

/// The next seeds to try, `most` of which are not known to fail. Each excludes others as if it had failed.
std::vector<PatchFinder::Trial> PatchFinder::next_trials(std::span<const Seed> seeds, std::size_t from, std::size_t most) {
  std::vector<Trial> trials;
  std::size_t count = 0;
  for (std::size_t i = from; i < seeds.size() && count < most; ++i) {
    const std::uint32_t seed = seeds[i].facet;
    if (patch_of_[seed] != kNone || is_excluded_[seed]) continue;
    Trial& trial = trials.emplace_back();
    trial.number = i;
    for (const std::uint32_t f : around(seed, kRingSteps, kMostRing)) {
      if (is_excluded_[f] || !are_alike(seeds[i], f)) continue;
      is_excluded_[f] = 1;
      trial.alike.push_back(f);
    }
    count += !has_failed_[seed];
  }
  return trials;
}

/// Keeps the outcomes that do not count yet and used no facet that a patch has taken since.
void PatchFinder::keep_outcomes(std::span<Trial> trials) {
  for (Trial& trial : trials) {
    if (trial.is_done) kept_.push_back(std::move(trial));
  }
  std::erase_if(kept_, [&](const Trial& trial) {
    return std::ranges::any_of(trial.outcome.asked, [&](std::uint32_t f) { return patch_of_[f] != kNone; });
  });
}

/// Gives trials the outcomes that are kept for them. Forgets those whose turn is over.
void PatchFinder::take_outcomes(std::vector<Trial>& trials) {
  for (Trial& kept : kept_) {
    const auto trial = std::ranges::find(trials, kept.number, &Trial::number);
    if (trial == trials.end() || trial->is_done) continue;
    trial->outcome = std::move(kept.outcome);
    trial->is_done = true;
    kept.is_done = false;
  }
  const std::size_t first = trials.front().number;
  std::erase_if(kept_, [&](const Trial& kept) { return !kept.is_done || kept.number < first; });
}

/// Searches from the seeds that are not known to fail, in order, up to the first that finds a surface. Idle threads may try
/// later ones.
void PatchFinder::try_all(std::span<const Seed> seeds, std::vector<Trial>& trials) {
  for (Trial& trial : trials) trial.is_done = has_failed_[seeds[trial.number].facet] != 0;
  take_outcomes(trials);
  std::atomic<std::size_t> next = 0, first_found = trials.size();
  const auto unknown = static_cast<std::size_t>(std::ranges::count(trials, false, &Trial::is_done));
  const auto work = [&](std::size_t worker) {
    SurfaceSearch& search = worker == 0 ? *this : others_[worker - 1];
    for (std::size_t i = next++; i < trials.size() && i < first_found; i = next++) {
      Trial& trial = trials[i];
      if (!trial.is_done) trial.outcome = search.search_from(seeds[trial.number].facet, tubes_);
      trial.is_done = true;
      if (trial.outcome.best.facets.empty()) continue;
      for (std::size_t first = first_found; i < first && !first_found.compare_exchange_weak(first, i);) {
      }
    }
  };
  const std::size_t workers = std::min(thread_count(), unknown);
  while (others_.size() + 1 < workers) others_.emplace_back(scene_, topology_, object_, graph_, patch_of_);
  if (workers <= 1) {
    work(0);
  } else {
    parallel_tasks_apart(workers, work);
  }
}

/// Whether a facet near a failed seed will probably fail too: a neighbour that is not much smaller, or any facet of about
/// the same size and form. Smaller ones may belong to a fillet beside a plane or a free form.
bool PatchFinder::are_alike(const Seed& failed, std::uint32_t f) const {
  const double area = graph_.area[failed.facet], part = graph_.area[f] / area;
  if (part < kLikeArea) return false;
  const auto arcs = graph_.arcs_of(failed.facet);
  if (std::ranges::any_of(arcs, [&](const FacetGraph::Arc& arc) { return arc.facet == f; })) return true;
  return part >= kSameArea && part * kSameArea <= 1 && longest_diagonal(f) >= kSameLength * failed.length;
}

}  // namespace ligne
