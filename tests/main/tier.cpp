#include "main/tier.hpp"

#include <array>
#include <atomic>
#include <cstdlib>

namespace ligne::test {

bool runs_all() {
  const char* const tier = std::getenv("LIGNE_TEST_TIER");
  return tier && std::string_view(tier) == "all";
}

std::uint64_t rotation_seed() {
  const char* const seed = std::getenv("LIGNE_TEST_SEED");
  return seed ? std::strtoull(seed, nullptr, 10) : 0;
}

std::uint64_t rotation_of(std::string_view key) {
  // FNV-1a over the key and the bytes of the seed, then the finalizer of MurmurHash3 to spread the bits.
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t byte) { hash = (hash ^ byte) * 0x100000001b3u; };
  for (const char c : key) add(static_cast<unsigned char>(c));
  const std::uint64_t seed = rotation_seed();
  for (int shift = 0; shift < 64; shift += 8) add(seed >> shift & 0xff);
  hash = (hash ^ hash >> 33) * 0xff51afd7ed558ccdu;
  hash = (hash ^ hash >> 33) * 0xc4ceb9fe1a85ec53u;
  return hash ^ hash >> 33;
}

bool is_chosen(std::string_view key, std::size_t number, std::size_t one_in) {
  return runs_all() || (number + rotation_of(key)) % one_in == 0;
}

namespace {

std::array<std::atomic<std::uint64_t>, kChecks> counts;

}  // namespace

void count_checks(Check check, std::uint64_t number) { counts[static_cast<std::size_t>(check)] += number; }

std::uint64_t checks_made(Check check) { return counts[static_cast<std::size_t>(check)]; }

}  // namespace ligne::test
