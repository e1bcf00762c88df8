#pragma once
/// The two tiers of tests. The first makes every kind of check. Where scenes, views and variants of methods multiply, it
/// takes a part of the products, which the seed chooses; the second tier takes all of them.

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <vector>

namespace ligne::test {

/// True with LIGNE_TEST_TIER=all in the environment, which is what ./test.sh --all sets.
bool runs_all();

/// LIGNE_TEST_SEED of the environment, or 0. The rotation turns with it.
std::uint64_t rotation_seed();

/// A number that depends on the seed and the key alone, the same on every machine.
std::uint64_t rotation_of(std::string_view key);

/// Whether the first tier takes item `number` of `key`: every `one_in`-th one, beginning at a place that the seed and the
/// key choose. The second tier takes every item.
bool is_chosen(std::string_view key, std::size_t number, std::size_t one_in);

/// The items of a list that the first tier takes, by their places in it.
template <class List>
auto chosen(std::string_view key, std::size_t one_in, const List& list) {
  std::vector<std::decay_t<decltype(*std::begin(list))>> taken;
  std::size_t number = 0;
  for (const auto& item : list)
    if (is_chosen(key, number++, one_in)) taken.push_back(item);
  return taken;
}
template <class Item>
std::vector<Item> chosen(std::string_view key, std::size_t one_in, std::initializer_list<Item> list) {
  return chosen<std::initializer_list<Item>>(key, one_in, list);
}

// Counts of what the tests compare: a number of tests alone does not tell how much they look at.

enum class Check : std::uint8_t {
  drawings,   ///< drawings of a method held against the oracle
  intervals,  ///< intervals of lines on which the oracle's answer was compared with a drawing
  pairs,      ///< drawings held against another drawing, or against known answers
};
inline constexpr int kChecks = 3;

/// May be called from any thread.
void count_checks(Check check, std::uint64_t number = 1);
std::uint64_t checks_made(Check check);

}  // namespace ligne::test
