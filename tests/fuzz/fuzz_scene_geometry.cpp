// The default method on scenes made of bytes, against the oracle. What it finds is shown as a scene that `ligne draw` reads.

#include "byte_scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string faults = ligne::test::faults_of(ligne::test::scene_of_bytes({data, size}));
  if (faults.empty()) return 0;
  std::fputs(faults.c_str(), stderr);
  std::abort();
}
