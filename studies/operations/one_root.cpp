#include "studies/operations/one_root.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ligne::studies {

WideInteger::WideInteger(Int128 value) : is_negative_(value < 0) {
  __extension__ using Unsigned = unsigned __int128;
  Unsigned magnitude = is_negative_ ? -static_cast<Unsigned>(value) : static_cast<Unsigned>(value);
  for (std::size_t i = 0; magnitude != 0; ++i, magnitude >>= 32) words_[i] = static_cast<std::uint32_t>(magnitude);
}

int WideInteger::sign() const {
  const bool is_zero = std::all_of(words_.begin(), words_.end(), [](std::uint32_t w) { return w == 0; });
  return is_zero ? 0 : is_negative_ ? -1 : 1;
}

WideInteger WideInteger::operator-() const {
  WideInteger result = *this;
  result.is_negative_ = !is_negative_;
  return result;
}

int WideInteger::compare(const Words& a, const Words& b) {
  for (std::size_t i = kWords; i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

WideInteger operator+(const WideInteger& a, const WideInteger& b) {
  const bool adds = a.is_negative_ == b.is_negative_;
  // The difference of magnitudes has the sign of the larger one.
  const bool swaps = !adds && WideInteger::compare(a.words_, b.words_) < 0;
  const WideInteger &x = swaps ? b : a, &y = swaps ? a : b;
  WideInteger result;
  result.is_negative_ = x.is_negative_;
  std::int64_t carry = 0;
  for (std::size_t i = 0; i < WideInteger::kWords; ++i) {
    const std::int64_t word = carry + std::int64_t{x.words_[i]} + (adds ? 1 : -1) * std::int64_t{y.words_[i]};
    result.words_[i] = static_cast<std::uint32_t>(word);
    carry = word >> 32;
  }
  assert(carry == 0);
  return result;
}

WideInteger operator*(const WideInteger& a, const WideInteger& b) {
  WideInteger result;
  result.is_negative_ = a.is_negative_ != b.is_negative_;
  for (std::size_t i = 0; i < WideInteger::kWords; ++i) {
    if (a.words_[i] == 0) continue;
    std::uint64_t carry = 0;
    for (std::size_t k = 0; i + k < WideInteger::kWords; ++k) {
      const std::uint64_t word = carry + result.words_[i + k] + std::uint64_t{a.words_[i]} * b.words_[k];
      result.words_[i + k] = static_cast<std::uint32_t>(word);
      carry = word >> 32;
    }
    assert(carry == 0);
  }
  return result;
}

int sign_with_roots(const WideInteger& d, int e, const WideInteger& q, int f, const WideInteger& r) {
  // d + e sqrt(q): both have one sign, or the larger square decides.
  const auto one_root = [](const WideInteger& a, int b, const WideInteger& root) {
    const int sign_a = a.sign(), sign_b = root.sign() == 0 ? 0 : b;
    if (sign_a == 0 || sign_b == 0 || sign_a == sign_b) return sign_a != 0 ? sign_a : sign_b;
    return sign_a * (a * a - root).sign();
  };
  const int first = one_root(d, e, q), second = r.sign() == 0 ? 0 : f;
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  // Opposite signs: (d + e sqrt(q))^2 - r = (d^2 + q - r) + 2 d e sqrt(q).
  const WideInteger sum = d * d + (e == 0 ? WideInteger(0) : q) - r, factor = d + d;
  return first * one_root(sum, e * factor.sign(), factor * factor * q);
}

namespace {

Int128 whole_root(Int128 square) {
  auto root = static_cast<Int128>(std::sqrt(static_cast<long double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

}  // namespace

OneRoot::OneRoot(Int128 p, int e, Int128 q, Int128 s) : p(p), q(q), s(s), e(e) {
  if (this->s < 0) {
    this->p = -p;
    this->s = -s;
    this->e = -e;
  }
  if (this->e == 0) this->q = 0;
  if (const Int128 root = whole_root(this->q); root * root == this->q) {
    this->p += this->e * root;
    this->q = 0;
    this->e = 0;
  }
}

double OneRoot::value() const {
  return static_cast<double>((static_cast<long double>(p) + e * std::sqrt(static_cast<long double>(q))) /
                             static_cast<long double>(s));
}

int OneRoot::sign_of_linear(Int128 u, Int128 v) const {
  // u (p + e sqrt(q)) + v s
  const WideInteger root = WideInteger(u) * u * q;
  return sign_with_roots(WideInteger(u) * p + WideInteger(v) * s, u > 0 ? e : u < 0 ? -e : 0, root, 0, 0);
}

int OneRoot::compare(const OneRoot& a, const OneRoot& b) {
  // Roundings of the sums, roots and quotients in doubles, relative to their terms; a wide bound.
  constexpr double kRounding = 0x1p-48;
  const double pa = static_cast<double>(a.p), ra = std::sqrt(static_cast<double>(a.q)), sa = static_cast<double>(a.s);
  const double pb = static_cast<double>(b.p), rb = std::sqrt(static_cast<double>(b.q)), sb = static_cast<double>(b.s);
  const double difference = (pa + a.e * ra) / sa - (pb + b.e * rb) / sb;
  const double doubt = kRounding * ((std::abs(pa) + ra) / sa + (std::abs(pb) + rb) / sb);
  if (difference > doubt) return 1;
  if (difference < -doubt) return -1;
  const WideInteger d = WideInteger(a.p) * b.s - WideInteger(b.p) * a.s;
  return sign_with_roots(d, a.e, WideInteger(a.q) * b.s * b.s, -b.e, WideInteger(b.q) * a.s * a.s);
}

}  // namespace ligne::studies
