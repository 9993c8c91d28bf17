/// Formats numbers as files and messages contain them, independently of a locale that users' code has set: "0.5",
/// "1000000".
#pragma once

#include <cstdint>
#include <locale>
#include <sstream>
#include <string>

namespace swarmanoid {

/// A std::ostringstream that always uses the classic locale. It is used wherever a number is written.
class PlainTextStream : public std::ostringstream {
 public:
  PlainTextStream() { imbue(std::locale::classic()); }
};

/// Formats the number as "%.*g" does.
std::string shortNumber(double value, int digits);

/// A hash as files contain it: 16 hexadecimal digits.
std::string hashText(std::uint64_t hash);

/// Restores the locale of the process, of C++ and of this thread after users' code has changed it; the first time a
/// warning is written to standard error. It is called after users' code, while other threads may still be in a step.
void restoreLocale();

}  // namespace swarmanoid
