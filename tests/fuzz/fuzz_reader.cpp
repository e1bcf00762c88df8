
#include "reader_harness.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ligne::read_as_fuzzer(LIGNE_FUZZ_KIND, std::as_bytes(std::span(data, size)));
  return 0;
}
