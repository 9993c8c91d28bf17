#include "swarmanoid_interface/random.hpp"

#include <Random123/philox.h>

#include <cmath>

namespace swarmanoid {

std::uint64_t stableHash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

RandomStream::RandomStream(std::uint64_t seed, std::string_view entity, std::string_view device)
    : seed_(seed), stream_(stableHash(entity) * 0x9e3779b97f4a7c15ULL ^ stableHash(device)) {}

std::uint64_t RandomStream::bits() {
  const r123::Philox4x32 philox;
  const r123::Philox4x32::ctr_type counter{{static_cast<std::uint32_t>(tick_), static_cast<std::uint32_t>(tick_ >> 32),
                                            draw_++, static_cast<std::uint32_t>(stream_ >> 32)}};
  // the stream's upper half is part of the counter because the key has room for 64 bits only
  const r123::Philox4x32::key_type key{{static_cast<std::uint32_t>(seed_) ^ static_cast<std::uint32_t>(stream_),
                                        static_cast<std::uint32_t>(seed_ >> 32)}};
  const r123::Philox4x32::ctr_type word = philox(counter, key);
  return static_cast<std::uint64_t>(word[1]) << 32 | word[0];
}

double RandomStream::uniform() {
  constexpr double kTwoToMinus53 = 1.0 / 9007199254740992.0;
  return static_cast<double>(bits() >> 11) * kTwoToMinus53;
}

double RandomStream::gaussian(double mean, double standard_deviation) {
  constexpr double kTwoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return mean + standard_deviation * radius * std::cos(kTwoPi * uniform());
}

}  // namespace swarmanoid
