#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "visibility/common/clock.hpp"
#include "visibility/edges/edge_visibility.hpp"
#include "visibility/methods.hpp"
#include "visibility/newell/priority_list.hpp"
#include "visibility/order/paint_pieces.hpp"

// Phases: (1) elements: faces with their extents and planes, (2) the priority list, (3) every edge against the faces with
// pieces before the edge's own. See docs/methods/newell.md.

namespace ligne {
namespace {

using namespace newell;

enum class Show : std::uint8_t { splits, order, zones, slabs };
constexpr std::string_view kShowNames[] = {"splits", "order", "zones", "slabs"};
enum class ListedAs : std::uint8_t { faces, bodies };
enum class Zones : std::uint8_t { parallel, sequence };
constexpr std::string_view kZoneNames[] = {"parallel", "sequence"};
constexpr std::string_view kElementNames[] = {"faces", "bodies"};
constexpr MethodParameter kParameters[] = {
    {"show", "splits|order|zones|slabs",
     "layer debug: the pieces of cut faces, the painting order as numbers, or the sets of faces separated on the page "
     "(zones) or in depth (slabs)",
     "", kShowNames},
    experiment({"zones", "parallel|sequence",
                "how the lists of zones and slabs are sorted: concurrently or in sequence; the order is the same",
                "parallel", kZoneNames}),
    experiment({"newell-elements", "faces|bodies", "elements of the list: faces, or silhouettes of convex bodies", "faces",
                kElementNames}),
};

/// Shows the sets as rectangles. Slabs overlap on the page and are numbered in painting order.
void show_sets(const std::vector<PriorityList::FoundSet>& sets, bool numbers, VisibilityResult& result) {
  for (const PriorityList::FoundSet& set : sets) {
    const Point2 a(set.extents.low[0], set.extents.low[1]), b(set.extents.high[0], set.extents.high[1]);
    result.debug.push_back({a, {b.x, a.y}, b, {a.x, b.y}, a});
    if (numbers) result.debug_numbers.push_back({(a + b) * 0.5, set.number});
  }
}

/// The list of a view, reused for a similar view.
class KeptList final : public KeptVisibility {
 public:
  /// `before`: the list that this one was made from, or nullptr.
  KeptList(const PaintElements& elements, const std::vector<std::uint32_t>& farthest_first, const Camera& camera,
           const KeptList* before)
      : elements_{{}, elements.pieces()},
        forward_(camera.forward),
        first_size_(before ? before->first_size_ : farthest_first.size()) {
    for (const std::uint32_t e : farthest_first) elements_.list.push_back({elements[e].face, elements[e].parts});
  }

  /// A list is reused if the model was rotated by at most kMostDegrees, and if cuts have not made it longer than
  /// kMostElements times the first list. Tuned.
  static constexpr double kMostDegrees = 10, kMostElements = 4.0 / 3;
  bool serves(const Camera& camera) const {
    return glm::dot(forward_, camera.forward) >= std::cos(glm::radians(kMostDegrees)) &&
           static_cast<double>(elements_.list.size()) <= kMostElements * static_cast<double>(first_size_);
  }
  const EarlierElements& elements() const { return elements_; }

 private:
  EarlierElements elements_;
  Point3 forward_;
  std::size_t first_size_;  ///< length of the first list, made without an earlier one
};

void report(const ListCounts& counts, Statistics& statistics) {
  statistics.count("zones", counts.zones);
  statistics.count("slabs", counts.slabs);
  statistics.count("lists sorted", counts.lists);
  statistics.count("compared ahead", counts.ahead);
  statistics.count("pairs of a convex body, not compared", counts.one_body);
  statistics.count("pairs compared", counts.compared);
  statistics.count("disjoint in x", counts.apart_in_x);
  statistics.count("disjoint in y", counts.apart_in_y);
  statistics.count("behind the plane of the other", counts.behind_plane);
  statistics.count("other element in front of the plane", counts.before_plane);
  statistics.count("projections compared", counts.projections);
  statistics.count("disjoint projections", counts.disjoint);
  statistics.count("depths compared", counts.depths);
  statistics.count("no part in front", counts.farther);
  statistics.count("moved to the head", counts.moved);
  statistics.count("cuts by a plane", counts.plane_cuts);
  statistics.count("cuts on the page", counts.page_cuts);
}

VisibilityResult newell_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  Clock clock;
  const auto* kept = dynamic_cast<const KeptList*>(options.earlier);
  const bool takes_over = kept && kept->serves(scene.view.camera);
  const bool whole_bodies = options.settings.choice("newell-elements", ListedAs::faces) == ListedAs::bodies;
  PaintElements elements(scene, takes_over ? &kept->elements() : nullptr, whole_bodies);
  const double seconds_of_elements = clock.lap();
  const std::size_t listed = elements.size();
  const bool shows = options.settings.has("show");
  const Show show = options.settings.choice("show", Show::splits);
  const bool parallel = options.settings.choice("zones", Zones::parallel) == Zones::parallel;
  PriorityList list(elements, {shows && show >= Show::zones, parallel});
  const std::vector<std::uint32_t> farthest_first = list.sort();
  const double seconds_of_list = clock.lap();

  FaceRanks ranks(scene.model->faces.size());
  PaintPieces pieces(scene, elements.pieces());
  PaintOrder order, numbered;
  std::vector<std::uint32_t> number_of_piece;
  const bool numbers = shows && show == Show::order;
  for (std::size_t i = 0; i < farthest_first.size(); ++i) {
    const Element& element = elements[farthest_first[i]];
    ranks.add(element.face, static_cast<std::uint32_t>(farthest_first.size() - i));
    if (options.wanted & kOrder) pieces.add_whole(element.parts, element.page_plane, order);
    if (!numbers) continue;
    for (const std::uint32_t part : element.parts) pieces.add(part, numbered);  // parts are convex, so a number fits inside
    number_of_piece.resize(numbered.pieces.size(), static_cast<std::uint32_t>(i + 1));
  }
  std::vector<std::vector<Point2>> cut;
  if (shows && show == Show::splits) cut = pieces.outlines_of_cut();
  VisibilityResult result = edge_visibility(scene, options, &ranks);
  result.debug = std::move(cut);
  if (numbers) result.debug_numbers = order_numbers(numbered, number_of_piece);
  if (shows && show == Show::zones) show_sets(list.zones(), false, result);
  if (shows && show == Show::slabs) show_sets(list.slabs(), true, result);
  if (options.wanted & kOrder) result.order = std::move(order);
  if (options.keep == Keep::for_next_view) {
    result.kept = std::make_shared<KeptList>(elements, farthest_first, scene.view.camera, takes_over ? kept : nullptr);
  }
  Statistics& statistics = result.statistics;
  statistics.seconds.insert(statistics.seconds.begin(), {{"elements", seconds_of_elements}, {"list", seconds_of_list}});
  statistics.count("elements of the previous view", elements.in_order());
  statistics.count("faces in the list", elements.face_count());
  if (whole_bodies) {
    statistics.count("elements in the list", listed);
    statistics.count("bodies kept as one element", elements.whole_bodies());
    statistics.count("bodies opened", list.counts().opened);
  }
  statistics.count("convex bodies", elements.bodies().count());
  statistics.count("faces of convex bodies", elements.bodies().faces());
  statistics.count("heights computed to find them", elements.bodies().heights());
  if (scene.model->stated.any_of_shape()) {
    statistics.count("pairs across separating planes, not compared", list.counts().separated);
    statistics.count("pairs not compared in reverse", list.counts().one_way);
  }
  statistics.count("final elements", farthest_first.size());
  report(list.counts(), statistics);
  return result;
}

}  // namespace

const Method& newell_method() {
  static const FunctionMethod method(
      {.name = "newell",
       .summary =
           "a list of faces sorted by depth, then checked and corrected pair by pair; faces that have no order are cut",
       .products = kStrokes | kRegions | kOrder,
       .paper = "M. Newell, R. Newell, T. Sancha, A solution to the hidden surface problem, 1972",
       .parameters = kParameters,
       .transparency = TransparencyMode::seen_through},
      newell_visibility);
  return method;
}

}  // namespace ligne
