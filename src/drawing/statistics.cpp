#include "drawing/statistics.hpp"

namespace ligne {

void Statistics::count(std::string_view name, std::uint64_t n) { counts.emplace_back(name, n); }

void Statistics::time(std::string_view name, double s) { seconds.emplace_back(name, s); }

}  // namespace ligne
