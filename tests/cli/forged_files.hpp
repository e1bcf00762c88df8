#pragma once
/// Files whose bytes were changed by somebody who made their checksum fit: nothing in them is to be believed.

#include "files/input_error.hpp"
#include "support/test.hpp"

namespace ligne::test {

/// Changes every byte in turn, and cuts the file everywhere. `sign(bytes)` puts the checksum in, `read(bytes, name)` reads:
/// it returns, or throws an InputError of one line.
template <class Sign, class Read>
void expect_forgeries_are_refused(const std::string& bytes, Sign sign, Read read) {
  std::size_t refused = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const unsigned char flip : {0x01, 0x80, 0xff}) {
      std::string changed = bytes;
      changed[i] = static_cast<char>(static_cast<unsigned char>(changed[i]) ^ flip);
      sign(changed);
      try {
        read(std::as_bytes(std::span(changed)), "forged");
      } catch (const InputError& error) {
        ++refused;
        EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos);
      }
    }
  }
  EXPECT_GT(refused, bytes.size()) << "a third of the changes at the least";
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    std::string cut = bytes.substr(0, size);
    sign(cut);
    EXPECT_THROW(read(std::as_bytes(std::span(cut)), "cut"), InputError);
  }
}

}  // namespace ligne::test
