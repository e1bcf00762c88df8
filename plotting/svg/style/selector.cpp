#include "plotting/svg/style/selector.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "areas/work_limit_error.hpp"
#include "files/message_text.hpp"
#include "plotting/svg/style/css_text.hpp"
#include "plotting/svg/values.hpp"
#include "plotting/svg/xml.hpp"

namespace ligne::svg {
namespace {

/// Specificity of an id, a class and an element.
constexpr std::uint32_t kIdWeight = 1'000'000, kClassWeight = 1'000, kElementWeight = 1;
/// Deepest nesting of selectors.
constexpr int kDeepestSelector = 8;

[[noreturn]] void fail_selector() { throw UnknownStyle("style rules with unknown selectors"); }

std::string take_name(std::string_view& text) {
  std::string name = take_css_name(text);
  if (name.empty()) fail_selector();
  return name;
}

/// Reads the text between "[" and "]".
AttributeTest attribute_test(std::string_view inside) {
  AttributeTest test;
  const std::size_t equals = inside.find('=');
  std::string_view left = inside.substr(0, equals);
  if (equals != std::string_view::npos) {
    test.how = '=';
    if (!left.empty() && std::string_view("~|^$*").find(left.back()) != std::string_view::npos) {
      test.how = left.back();
      left.remove_suffix(1);
    }
    std::string_view right = trimmed(inside.substr(equals + 1));
    if (right.size() >= 2 && (right.front() == '"' || right.front() == '\'') && right.back() == right.front())
      right = right.substr(1, right.size() - 2);
    test.value = right;
  }
  test.name = trimmed(left);
  if (test.name.empty()) fail_selector();
  return test;
}

/// "odd", "even", "3", "2n+1", "-n + 3" (CSS Syntax 3, 6).
PlaceTest place_test(std::string_view given) {
  std::string text;
  for (const char c : given) {
    if (kBlanks.find(c) == std::string_view::npos) text += c;
  }
  PlaceTest test;
  if (text == "odd" || text == "even") {
    test.step = 2;
    test.offset = text == "odd" ? 1 : 0;
    return test;
  }
  const auto number = [](std::string_view digits) {
    long value = 0;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    constexpr long kMost = 1'000'000'000;
    if (error != std::errc() || end != digits.data() + digits.size() || value > kMost || value < -kMost) fail_selector();
    return value;
  };
  const std::size_t n = text.find('n');
  if (n == std::string::npos) {
    test.offset = number(text);
    return test;
  }
  const std::string step = text.substr(0, n);
  test.step = step.empty() || step == "+" ? 1 : step == "-" ? -1 : number(step);
  test.offset = n + 1 == text.size() ? 0 : number(std::string_view(text).substr(n + 1));
  return test;
}

Selector take_nested(std::string_view& text, int depth);

/// The selectors between the brackets of ":is(...)".
GroupTest group_test(std::string_view inside, int depth, std::uint32_t& weight) {
  if (depth == kDeepestSelector) fail_selector();
  GroupTest test;
  weight = 0;
  while (!trimmed(inside).empty()) {
    Selector selector = take_nested(inside, depth + 1);
    weight = std::max(weight, selector.weight);
    if (!selector.never) test.any_of.push_back(std::move(selector));
  }
  return test;
}

/// Tests for ":first-child" and similar names, which are ":nth-child" of a fixed place.
std::optional<std::vector<PlaceTest>> named_places(std::string_view name) {
  const bool of_type = name.ends_with("-of-type");
  const PlaceTest first{0, 1, false, of_type}, last{0, 1, true, of_type};
  if (name == "first-child" || name == "first-of-type") return std::vector{first};
  if (name == "last-child" || name == "last-of-type") return std::vector{last};
  if (name == "only-child" || name == "only-of-type") return std::vector{first, last};
  return {};
}

/// Reads one ":name" or ":name(...)".
void take_pseudo_class(std::string_view& text, Compound& compound, Selector& selector, int depth) {
  constexpr std::string_view kNever[] = {"hover",        "active",  "focus",    "focus-within", "focus-visible",
                                         "visited",      "target",  "before",   "after",        "first-line",
                                         "first-letter", "checked", "disabled", "placeholder",  "target-within"};
  const bool is_part = text.starts_with("::");
  text.remove_prefix(is_part ? 2 : 1);
  const std::string name = lower_case(take_name(text));
  std::string_view inside;
  const bool has_inside = text.starts_with('(');
  if (has_inside) {
    text.remove_prefix(1);
    inside = take_block(text, ')');
  }
  if (name == "where" || name == "is" || name == "not" || name == "matches") {
    std::uint32_t weight = 0;
    GroupTest test = group_test(inside, depth, weight);
    test.negated = name == "not";
    compound.groups.push_back(std::move(test));
    if (name != "where") selector.weight += weight;
    return;
  }
  selector.weight += kClassWeight;
  // Names that begin with a hyphen are states of one browser's controls.
  if (is_part || name.starts_with('-') || std::ranges::find(kNever, name) != std::end(kNever)) {
    selector.never = true;
  } else if (const auto places = named_places(name)) {
    compound.places.insert(compound.places.end(), places->begin(), places->end());
  } else if (has_inside && name.starts_with("nth-")) {
    PlaceTest test = place_test(inside);
    test.from_end = name.starts_with("nth-last-");
    test.of_type = name.ends_with("-of-type");
    if (!test.of_type && !name.ends_with("-child")) fail_selector();
    compound.places.push_back(test);
  } else if (name == "root") {
    compound.is_root = true;
  } else if (name == "empty") {
    compound.is_empty = true;
  } else {
    throw UnknownStyle("style rules with :" + printable(name));
  }
}

Compound take_compound(std::string_view& text, Selector& selector, int depth) {
  Compound compound;
  const std::size_t size = text.size();
  if (text.starts_with('*')) {
    text.remove_prefix(1);
  } else if (text[0] != '.' && text[0] != '#' && text[0] != ':' && text[0] != '[') {
    compound.element = take_name(text);
    selector.weight += kElementWeight;
  }
  while (!text.empty() && std::string_view(".#:[").find(text[0]) != std::string_view::npos) {
    const char kind = text[0];
    if (kind == ':') {
      take_pseudo_class(text, compound, selector, depth);
      continue;
    }
    text.remove_prefix(1);
    if (kind == '[') {
      compound.attributes.push_back(attribute_test(trimmed(take_block(text, ']'))));
      selector.weight += kClassWeight;
    } else if (kind == '.') {
      compound.classes.push_back(take_name(text));
      selector.weight += kClassWeight;
    } else {
      compound.id = take_name(text);
      selector.weight += kIdWeight;
    }
  }
  if (text.size() == size) fail_selector();
  return compound;
}

Selector take_nested(std::string_view& text, int depth) {
  // Even if this selector fails, the next one begins behind the comma.
  const std::size_t comma = std::min(find_outside(text, ","), text.size());
  std::string_view own = trimmed(text.substr(0, comma));
  text.remove_prefix(std::min(comma + 1, text.size()));
  Selector selector;
  char combinator = ' ';
  while (!own.empty()) {
    Compound compound = take_compound(own, selector, depth);
    compound.combinator = combinator;
    selector.path.push_back(std::move(compound));
    const std::string_view rest = trimmed(own);
    if (rest.empty()) return selector;
    const bool named = rest[0] == '>' || rest[0] == '+' || rest[0] == '~';
    if (!named && rest.size() == own.size()) fail_selector();
    combinator = named ? rest[0] : ' ';
    own = named ? trimmed(rest.substr(1)) : rest;
  }
  fail_selector();
}

bool has_class(std::string_view list, std::string_view name) {
  while (!list.empty()) {
    const std::size_t begin = list.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return false;
    list.remove_prefix(begin);
    const std::size_t end = std::min(list.find_first_of(kBlanks), list.size());
    if (list.substr(0, end) == name) return true;
    list.remove_prefix(end);
  }
  return false;
}

bool fits(const AttributeTest& wanted, const pugi::xml_node& node) {
  const pugi::xml_attribute attribute = node.attribute(wanted.name.c_str());
  const std::string_view value = attribute.value();
  if (!attribute) return false;
  if (wanted.how == '\0') return true;
  if (wanted.how == '=') return value == wanted.value;
  if (wanted.value.empty()) return false;
  if (wanted.how == '~') return has_class(value, wanted.value);
  if (wanted.how == '^') return value.starts_with(wanted.value);
  if (wanted.how == '$') return value.ends_with(wanted.value);
  if (wanted.how == '*') return value.find(wanted.value) != std::string_view::npos;
  return value == wanted.value || value.starts_with(wanted.value + "-");
}

pugi::xml_node element_before(pugi::xml_node node) {
  do {
    node = node.previous_sibling();
  } while (node && node.type() != pugi::node_element);
  return node;
}

/// The place of an element. On first use it numbers all children of the element's parent.
SiblingPlace place_of(const pugi::xml_node& node, StyleWork& work) {
  const auto known = work.places.find(node.internal_object());
  if (known != work.places.end()) return known->second;
  const pugi::xml_node parent = node.parent();
  for (const std::size_t end : {0, 1}) {
    long number = 0;
    std::unordered_map<std::string_view, long> of_type;
    for (pugi::xml_node child = end == 0 ? parent.first_child() : parent.last_child(); child;
         child = end == 0 ? child.next_sibling() : child.previous_sibling()) {
      if (child.type() != pugi::node_element) continue;
      SiblingPlace& place = work.places[child.internal_object()];
      place.of_all[end] = ++number;
      place.of_type[end] = ++of_type[child.name()];
    }
  }
  return work.places[node.internal_object()];
}

/// Whether the element is number step * n + offset, for an n from 0 on, among its siblings.
bool stands_at(const PlaceTest& test, const pugi::xml_node& node, StyleWork& work) {
  const SiblingPlace place = place_of(node, work);
  const std::size_t end = test.from_end ? 1 : 0;
  const long rest = (test.of_type ? place.of_type[end] : place.of_all[end]) - test.offset;
  return test.step == 0 ? rest == 0 : rest % test.step == 0 && rest / test.step >= 0;
}

bool compound_holds(const Compound& compound, const pugi::xml_node& node, StyleWork& work) {
  if (++work.comparisons > kMostStyleWork) throw WorkLimitError("the style sheets take too much work");
  if (!compound.element.empty() && local_name(node) != compound.element) return false;
  if (!compound.id.empty() && compound.id != node.attribute("id").value()) return false;
  if (compound.is_root && node.parent().type() == pugi::node_element) return false;
  const auto shows = [](const pugi::xml_node& child) {
    return child.type() == pugi::node_element || child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata;
  };
  if (compound.is_empty && std::ranges::any_of(node.children(), shows)) return false;
  return std::ranges::all_of(compound.attributes, [&](const AttributeTest& test) { return fits(test, node); }) &&
         std::ranges::all_of(compound.classes,
                             [&](const std::string& name) { return has_class(node.attribute("class").value(), name); }) &&
         std::ranges::all_of(compound.places, [&](const PlaceTest& place) { return stands_at(place, node, work); }) &&
         std::ranges::all_of(compound.groups, [&](const GroupTest& group) {
           const auto one_holds = [&](const Selector& selector) { return holds(selector, node, work); };
           return std::ranges::any_of(group.any_of, one_holds) != group.negated;
         });
}

/// Whether path[0..last] holds, its last part for this node.
bool path_holds(const std::vector<Compound>& path, std::size_t last, const pugi::xml_node& node, StyleWork& work) {
  if (!compound_holds(path[last], node, work)) return false;
  if (last == 0) return true;
  const char combinator = path[last].combinator;
  const bool beside = combinator == '+' || combinator == '~', once = combinator == '>' || combinator == '+';
  for (pugi::xml_node other = node;;) {
    other = beside ? element_before(other) : other.parent();
    if (other.type() != pugi::node_element) return false;
    if (path_holds(path, last - 1, other, work)) return true;
    if (once) return false;
  }
}

}  // namespace

Selector take_selector(std::string_view& text) { return take_nested(text, 0); }

bool holds(const Selector& selector, const pugi::xml_node& node, StyleWork& work) {
  return !selector.never && path_holds(selector.path, selector.path.size() - 1, node, work);
}

}  // namespace ligne::svg
