/// Writes to standard output: the requested text is written completely, or the program reports that it was not.
#pragma once

#include <string>

namespace swarmanoid::program {

/// Opens /dev/null in the place of each standard stream that is closed; otherwise the next file that is opened would
/// get its number, and the output for the stream. It is called before any other file is opened.
/// @return whether standard output was open
bool fillStandardStreams();

/// Writes the text at once to the standard output of that time, even if users' code has closed the stream since.
/// @throws std::runtime_error if it cannot be written
void print(const std::string& text);

}  // namespace swarmanoid::program
