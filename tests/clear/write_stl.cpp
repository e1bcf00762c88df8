#include "clear/write_stl.hpp"

#include <fstream>
#include <stdexcept>
#include <string>

namespace ligne::test {

void write_stl(const std::vector<std::array<Point3, 3>>& triangles, const std::filesystem::path& file) {
  std::ofstream out(file, std::ios::binary);
  const auto write = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
  out.write(std::string(80, ' ').data(), 80);
  write(static_cast<std::uint32_t>(triangles.size()));
  for (const std::array<Point3, 3>& triangle : triangles) {
    for (int k = 0; k < 3; ++k) write(0.0f);  // readers take the normal from the corners
    for (const Point3& p : triangle)
      for (int axis = 0; axis < 3; ++axis) write(static_cast<float>(p[axis]));
    write(std::uint16_t{0});
  }
  if (!out.flush()) throw std::runtime_error("can't write " + file.string());
}

}  // namespace ligne::test
