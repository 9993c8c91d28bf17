#include "swarmanoid_interface/plain_text.hpp"

#include <locale.h>

#include <array>
#include <atomic>
#include <charconv>
#include <clocale>
#include <cstdio>

namespace swarmanoid {
namespace {

const std::string& ownLocale() {
  static const std::string name = std::setlocale(LC_ALL, nullptr);
  return name;
}

const std::string& noted_when_loaded = ownLocale();

void reportOnce() {
  static std::atomic<bool> is_reported{false};
  if (!is_reported.exchange(true)) {
    std::fprintf(stderr, "swarmanoid: warning: users' code has changed the locale; it is put back\n");
  }
}

}  // namespace

std::string shortNumber(double value, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string hashText(std::uint64_t hash) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

void restoreLocale() {
  if (uselocale(nullptr) != LC_GLOBAL_LOCALE) {
    reportOnce();
    uselocale(LC_GLOBAL_LOCALE);
  }
  // the locale of C++ first, which may set the other one too
  if (std::locale() != std::locale::classic()) {
    reportOnce();
    std::locale::global(std::locale::classic());
  }
  if (noted_when_loaded != std::setlocale(LC_ALL, nullptr)) {
    reportOnce();
    std::setlocale(LC_ALL, noted_when_loaded.c_str());
  }
}

}  // namespace swarmanoid
