#include "report/surface_facts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include <nlohmann/json.hpp>

#include "files/message_text.hpp"
#include "plotting/writers/number_text.hpp"

namespace ligne {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
/// Largest number of decimals of a size, the limit of power_of_ten().
constexpr int kMostDecimals = 15;

/// A surface with the values by which it is grouped.
struct Sized {
  SurfaceKind kind;
  bool outward, is_arc;
  double size, error;

  auto group() const { return std::tuple(kind, is_arc, outward); }
};

Sized sized(const FoundSurface& found) {
  const PatchSurface& s = found.surface;
  Sized of{s.kind, found.outward, s.kind == SurfaceKind::cylinder && found.turn <= kMostArcDegrees, s.radius, found.error};
  if (s.kind == SurfaceKind::torus) of.size = s.tube;
  if (s.kind == SurfaceKind::cone) {
    of.size = std::atan(std::abs(s.slope)) * kDegrees;
    of.error = std::atan2(found.error, found.along[1] - found.along[0]) * kDegrees;
  }
  return of;
}

/// Rounds the size to a decimal place no finer than its error.
double rounded_size(const Sized& surface) {
  const double digits = surface.error > 0 ? std::floor(-std::log10(surface.error)) : kMostDecimals;
  const auto power = static_cast<double>(power_of_ten(static_cast<int>(std::clamp<double>(digits, 0, kMostDecimals))));
  return std::round(surface.size * power) / power;
}

/// Makes a group of [begin, end). Its size is that of the surface with the smallest error.
SurfaceGroup group_of(const std::vector<Sized>& all, std::size_t begin, std::size_t end) {
  const auto best =
      std::min_element(all.begin() + static_cast<std::ptrdiff_t>(begin), all.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const Sized& l, const Sized& r) { return l.error < r.error; });
  return {best->kind, best->outward, best->is_arc, rounded_size(*best), end - begin};
}

/// Merges adjacent groups of equal rounded size: fits to few corners vary more than their errors say.
void add_group(std::vector<SurfaceGroup>& groups, const SurfaceGroup& group) {
  const auto key = [](const SurfaceGroup& g) { return std::tuple(g.kind, g.is_arc, g.outward, g.size); };
  if (!groups.empty() && key(groups.back()) == key(group)) {
    groups.back().count += group.count;
  } else {
    groups.push_back(group);
  }
}

void count(SurfaceFacts& facts, const Sized& surface) {
  // In the order of SurfaceKind.
  static constexpr std::size_t SurfaceFacts::*kOfKind[] = {&SurfaceFacts::cylinders, &SurfaceFacts::cones,
                                                           &SurfaceFacts::spheres,   &SurfaceFacts::tori,
                                                           &SurfaceFacts::extruded,  &SurfaceFacts::revolved};
  ++(facts.*kOfKind[static_cast<std::size_t>(surface.kind)]);
  if (surface.kind == SurfaceKind::cylinder) ++(surface.is_arc ? facts.arcs : surface.outward ? facts.bosses : facts.bores);
}

std::string counted(std::size_t n, const char* one, const char* more) {
  return std::to_string(n) + " " + (n == 1 ? one : more);
}

/// The words for one and for several surfaces of a kind: hollow ones, convex ones.
struct Nouns {
  SurfaceKind kind;
  bool is_arc;
  std::pair<const char*, const char*> hollow, convex;
};
constexpr Nouns kNouns[] = {
    {SurfaceKind::cylinder, false, {"bore", "bores"}, {"boss", "bosses"}},
    {SurfaceKind::cylinder, true, {"hollow arc", "hollow arcs"}, {"convex arc", "convex arcs"}},
    {SurfaceKind::cone, false, {"hollow cone", "hollow cones"}, {"convex cone", "convex cones"}},
    {SurfaceKind::sphere, false, {"hollow sphere", "hollow spheres"}, {"convex sphere", "convex spheres"}},
    {SurfaceKind::torus, false, {"hollow torus", "hollow tori"}, {"convex torus", "convex tori"}},
};

std::string noun_of(const SurfaceGroup& group) {
  for (const Nouns& nouns : kNouns) {
    if (nouns.kind != group.kind || nouns.is_arc != group.is_arc) continue;
    const auto& [one, more] = group.outward ? nouns.convex : nouns.hollow;
    return counted(group.count, one, more);
  }
  return "";
}

}  // namespace

SurfaceFacts surface_facts(const FoundSurfaces& found) {
  SurfaceFacts facts;
  std::vector<Sized> all;
  for (const FoundSurface& surface : found.list) {
    const Sized one = sized(surface);
    count(facts, one);
    if (surface.has_radius()) all.push_back(one);
  }
  std::ranges::stable_sort(
      all, [](const Sized& l, const Sized& r) { return std::tuple(l.group(), l.size) < std::tuple(r.group(), r.size); });
  for (std::size_t begin = 0, i = 1; i <= all.size(); ++i) {
    if (i < all.size() && all[i].group() == all[begin].group() &&
        all[i].size - all[begin].size <= all[i].error + all[begin].error) {
      continue;
    }
    add_group(facts.groups, group_of(all, begin, i));
    begin = i;
  }
  std::ranges::stable_sort(facts.groups, [](const SurfaceGroup& l, const SurfaceGroup& r) { return l.count > r.count; });
  return facts;
}

std::string counts_text(const SurfaceFacts& facts) {
  std::string text;
  const auto add = [&](std::size_t n, const char* one, const char* more) {
    if (n > 0) text += (text.empty() ? "" : ", ") + counted(n, one, more);
  };
  add(facts.bores, "bore", "bores");
  add(facts.bosses, "boss", "bosses");
  add(facts.arcs, "arc of a cylinder", "arcs of cylinders");
  add(facts.cones, "cone", "cones");
  add(facts.spheres, "sphere", "spheres");
  add(facts.tori, "torus", "tori");
  add(facts.extruded, "extruded surface", "extruded surfaces");
  add(facts.revolved, "revolved surface", "revolved surfaces");
  return text;
}

std::string group_text(const SurfaceGroup& group) {
  const std::string size = shortest(group.size);
  switch (group.kind) {
    case SurfaceKind::cone:
      return noun_of(group) + ", " + size + " degrees from the axis";
    case SurfaceKind::torus:
      return noun_of(group) + ", radius of the tube " + size;
    default:
      return noun_of(group) + ", radius " + size;
  }
}

nlohmann::ordered_json json_of(const SurfaceFacts& facts) {
  using Json = nlohmann::ordered_json;
  Json json{{"cylinders", facts.cylinders}, {"bosses", facts.bosses},     {"bores", facts.bores},
            {"arcs", facts.arcs},           {"cones", facts.cones},       {"spheres", facts.spheres},
            {"tori", facts.tori},           {"extruded", facts.extruded}, {"revolved", facts.revolved}};
  json["groups"] = Json::array();
  for (const SurfaceGroup& group : facts.groups) {
    Json entry{{"kind", kSurfaceKindNames[static_cast<std::size_t>(group.kind)]}, {"outward", group.outward}};
    if (group.kind == SurfaceKind::cylinder) entry["arc"] = group.is_arc;
    const char* const name = group.kind == SurfaceKind::cone    ? "degrees"
                             : group.kind == SurfaceKind::torus ? "tube"
                                                                : "radius";
    entry[name] = group.size;
    entry["count"] = group.count;
    json["groups"].push_back(std::move(entry));
  }
  return json;
}

}  // namespace ligne
