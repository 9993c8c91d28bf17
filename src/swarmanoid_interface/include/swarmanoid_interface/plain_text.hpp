/// Numbers as files and messages have them, whatever locale users' code has set: "0.5", "1000000".
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace swarmanoid {

/// What a std::ostringstream is where nobody changes the locale. Used instead of it wherever a number is written.
class PlainTextStream : public std::ostringstream {
 public:
  PlainTextStream() { imbue(std::locale::classic()); }
};

/// As "%.*g" writes it.
std::string shortNumber(double value, int digits);

/// Undoes what users' code has done to the locale of the process, of C++ and of this thread; the first time it says so
/// on standard error. Called after users' code, where others may still be in a step.
void restoreLocale();

}  // namespace swarmanoid
