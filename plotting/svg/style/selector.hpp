#pragma once
/// Selectors of style sheets (Selectors 4): the elements to which a rule applies. Private to plotting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <pugixml.hpp>

namespace ligne::svg {

/// An unknown part of a style sheet; what() names it, as a plural noun.
struct UnknownStyle : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

struct Selector;

/// "[name]", "[name=value]", "[name~=value]" and so on.
struct AttributeTest {
  std::string name, value;
  char how = '\0';  ///< the sign before "="; '=' if there is none; '\0' if any value fits
};

/// ":nth-child(an+b)" and similar.
struct PlaceTest {
  long step = 0, offset = 1;
  bool from_end = false, of_type = false;
};

/// ":is(...)", ":where(...)": one of these holds; ":not(...)": none.
struct GroupTest {
  std::vector<Selector> any_of;
  bool negated = false;
};

/// Conditions on one element; empty ones hold for all.
struct Compound {
  std::string element, id;
  std::vector<std::string> classes;
  std::vector<AttributeTest> attributes;
  std::vector<PlaceTest> places;
  std::vector<GroupTest> groups;
  bool is_root = false, is_empty = false;
  char combinator = ' ';  ///< its relation to the compound before: ' ', '>', '+' or '~'
};

struct Selector {
  std::vector<Compound> path;  ///< from the outside to the element itself
  std::uint32_t weight = 0;    ///< specificity: a million for each id, a thousand for each class, one for each element
  bool never = false;          ///< a state that paper does not have (:hover), or a part of no element (::before)
};

/// Takes one selector, up to a comma or the end. Throws UnknownStyle.
Selector take_selector(std::string_view& text);

/// Numbers of an element among its siblings, from 1, counted from the front and from the end: among all siblings, and
/// among those of its name.
struct SiblingPlace {
  std::array<long, 2> of_all{0, 0}, of_type{0, 0};
};

/// Work on the selectors of a drawing, and the places that they have needed.
struct StyleWork {
  std::size_t comparisons = 0;
  std::unordered_map<const void*, SiblingPlace> places;  ///< places of elements, and of their siblings, made on first
                                                         ///< use
};

/// Whether the selector holds for an element. Throws WorkLimitError if all calls together take more than kMostStyleWork.
bool holds(const Selector& selector, const pugi::xml_node& node, StyleWork& work);

/// Most comparisons of elements with parts of selectors, in all.
inline constexpr std::size_t kMostStyleWork = 200'000'000;

}  // namespace ligne::svg
